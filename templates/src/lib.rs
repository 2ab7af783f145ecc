//! Text templates.
