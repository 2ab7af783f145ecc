//! The page of findings that `--format html` writes, in three parts, so that findings need not be kept until the end.

use crate::Template;

/// The head of the page; needs nothing.
pub const BEGIN: Template<'_> = Template {
    name: "begin.html.j2",
    text: include_str!("../report/begin.html.j2"),
};

/// A file's `name` and its `findings`: `level`, `word`, `code`, `rule`, `message`, `page`, and `section`, `line`, `help` or none.
pub const FILE: Template<'_> = Template {
    name: "file.html.j2",
    text: include_str!("../report/file.html.j2"),
};

/// The `summary`, the numbers `deny`, `warn`, `note`, the `failures`, and the `tool` that says all that.
pub const END: Template<'_> = Template {
    name: "end.html.j2",
    text: include_str!("../report/end.html.j2"),
};
