//! The firmware crate that `lexican new` writes.

use crate::{Error, Template, Value};

/// Its files but for the EDS: where each goes, and what it is made of.
///
/// Beside the context of a dictionary they need
///
/// | name | is |
/// |---|---|
/// | `package` | the crate's name |
/// | `crate_name` | the same as an identifier |
/// | `node_id` | what the device starts with |
/// | `runtime`, `codegen` | the dependencies, as TOML |
/// | `eds` | the EDS file's name, as a Rust string |
/// | `builder` | the calls of the builder after `new`, a line each |
/// | `device_type` | 1000h: `value`, and the `response` to who reads it; none when clients cannot |
/// | `example` | a value that clients may write, or none: a `test`'s name, `write` and `read` requests, the responses `written` and `response` |
pub const FILES: [(&str, Template<'_>); 8] = [
    (
        ".gitignore",
        template("gitignore.j2", include_str!("../scaffold/gitignore.j2")),
    ),
    (
        "Cargo.toml",
        template("Cargo.toml.j2", include_str!("../scaffold/Cargo.toml.j2")),
    ),
    (
        "README.md",
        template("README.md.j2", include_str!("../scaffold/README.md.j2")),
    ),
    (
        "build.rs",
        template("build.rs.j2", include_str!("../scaffold/build.rs.j2")),
    ),
    (
        "src/lib.rs",
        template("lib.rs.j2", include_str!("../scaffold/lib.rs.j2")),
    ),
    (
        "src/handlers.rs",
        template("handlers.rs.j2", include_str!("../scaffold/handlers.rs.j2")),
    ),
    (
        "src/main.rs",
        template("main.rs.j2", include_str!("../scaffold/main.rs.j2")),
    ),
    (
        "tests/sdo.rs",
        template("sdo.rs.j2", include_str!("../scaffold/sdo.rs.j2")),
    ),
];

/// The files, filled.
///
/// # Errors
/// When `context` lacks what they need.
pub fn render(context: &Value) -> Result<Vec<(&'static str, String)>, Error> {
    let files = FILES.iter();
    files
        .map(|(path, template)| Ok((*path, template.render(context.clone())?)))
        .collect()
}

const fn template<'a>(name: &'a str, text: &'a str) -> Template<'a> {
    Template { name, text }
}
