//! The text templates of Lexican, and what renders them: handler stubs, the documentation of a dictionary, a firmware
//! crate, and templates of a user's own.
//!
//! Templates are in the language of Jinja, as [minijinja] has it. Beside its filters there are
//!
//! * `hex(digits)`: a number in upper-case hexadecimal, `4119 | hex(4)` is `1017`;
//! * `markdown`: a text that means itself in Markdown, also in a table;
//! * `code`: a text as code of Markdown, also in a table.
//!
//! A name that the context does not have is an error, not an empty text. What ends in `.html` or `.html.j2` is escaped
//! for HTML.

mod error;
mod filters;
pub mod report;
pub mod scaffold;

pub use error::Error;
pub use minijinja::{Value, context};

use minijinja::{Environment, UndefinedBehavior, syntax::SyntaxConfig};

/// A skeleton of the generated trait `Handlers`, to start an application from.
pub const STUBS: Template<'_> = Template {
    name: "stubs.rs.j2",
    text: include_str!("../stubs.rs.j2"),
};

/// The methods of a skeleton, which other templates include.
const METHODS: Template<'_> = Template {
    name: "methods.rs.j2",
    text: include_str!("../methods.rs.j2"),
};

/// A dictionary as Markdown: its objects, and its PDOs.
pub const DOCS: Template<'_> = Template {
    name: "docs.md.j2",
    text: include_str!("../docs.md.j2"),
};

/// A template's text, and what messages call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Template<'a> {
    /// The file's name.
    pub name: &'a str,
    /// What is in it.
    pub text: &'a str,
}

impl Template<'_> {
    /// Fills the template with what `context` has.
    ///
    /// # Errors
    /// When the template is not one, or asks for what the context does not have.
    pub fn render(&self, context: Value) -> Result<String, Error> {
        let failed = |error| Error::new(self, &error);
        let environment = environment().map_err(failed)?;
        environment
            .render_named_str(self.name, self.text, context)
            .map_err(failed)
    }
}

/// A block's line leaves no empty line, and the last line keeps its end.
fn environment() -> Result<Environment<'static>, minijinja::Error> {
    let mut environment = Environment::new();
    let syntax = SyntaxConfig::builder()
        .trim_blocks(true)
        .lstrip_blocks(true)
        .keep_trailing_newline(true)
        .build()?;
    environment.set_syntax(syntax);
    environment.set_undefined_behavior(UndefinedBehavior::Strict);
    filters::add(&mut environment);
    environment.add_template(METHODS.name, METHODS.text)?;
    Ok(environment)
}

#[cfg(test)]
mod tests {
    use super::{Template, context};

    fn render(text: &str) -> Result<String, String> {
        let template = Template { name: "test.j2", text };
        let context = context! { index => 0x1017, name => "a|b <c> `d`\n*e*" };
        template.render(context).map_err(|error| error.to_string())
    }

    #[test]
    fn numbers_are_hexadecimal_and_names_safe_in_a_table() {
        assert_eq!(render("{{ index | hex(6) }}").unwrap(), "001017");
        assert_eq!(render("{{ name | markdown }}").unwrap(), r"a\|b \<c\> \`d\` \*e\*");
        assert_eq!(render("{{ name | code }}").unwrap(), r"`` a\|b <c> `d` *e* ``");
    }

    #[test]
    fn an_error_says_where_and_what() {
        let error = render("\n{{ nothing }}").unwrap_err();
        assert!(error.starts_with("test.j2:2: "), "{error}");
        let error = render("{% if %}").unwrap_err();
        assert!(error.starts_with("test.j2:1: "), "{error}");
    }
}
