//! Source and document: every file is read, nothing of it is lost, and only what is edited changes.

#![expect(clippy::unwrap_used, reason = "in tests a panic is the report")]

mod corpus;
mod edit;
mod files;
mod lines;
mod robust;
