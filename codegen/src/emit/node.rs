//! The few syntax nodes that are built by hand, because a thousand objects need thousands of them: a node built costs
//! a tenth of one parsed from tokens, which shows in a build script that is compiled without optimisation.

use proc_macro2::Span;
use syn::{
    AttrStyle, Attribute, Expr, ExprLit, Field, FieldModifiers, FieldValue, Ident, Lit, LitInt, LitStr, Member, Meta,
    MetaNameValue, Path, Token, Type, TypePath, Visibility,
};

/// An identifier; `name` is one.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// A path of one name.
pub(super) fn path(name: &str) -> Path {
    Path::from(ident(name))
}

/// A type without parameters.
pub(super) fn named_type(name: &str) -> Type {
    Type::Path(TypePath {
        attrs: Vec::new(),
        qself: None,
        path: path(name),
    })
}

/// A line of documentation; it is one line.
pub(super) fn doc(line: &str) -> Attribute {
    let text = if line.is_empty() {
        String::new()
    } else {
        format!(" {line}")
    };
    Attribute {
        pound_token: Token![#](Span::call_site()),
        style: AttrStyle::Outer,
        bracket_token: syn::token::Bracket::default(),
        meta: Meta::NameValue(MetaNameValue {
            path: path("doc"),
            eq_token: Token![=](Span::call_site()),
            value: literal(Lit::Str(LitStr::new(&text, Span::call_site()))),
        }),
    }
}

/// Lines of documentation.
pub(super) fn docs(lines: &[String]) -> Vec<Attribute> {
    lines.iter().map(|line| doc(line)).collect()
}

/// A literal.
pub(super) fn literal(lit: Lit) -> Expr {
    Expr::Lit(ExprLit { attrs: Vec::new(), lit })
}

/// A number as `text` writes it.
pub(super) fn number(text: &str) -> Expr {
    literal(Lit::Int(LitInt::new(text, Span::call_site())))
}

/// A field of a struct's declaration.
pub(super) fn field(docs: Vec<Attribute>, vis: Visibility, name: &str, ty: Type) -> Field {
    Field {
        attrs: docs,
        vis,
        modifiers: FieldModifiers::default(),
        ident: Some(ident(name)),
        colon_token: Some(Token![:](Span::call_site())),
        ty,
        default: None,
    }
}

/// A field of a struct's value.
pub(super) fn field_value(name: &str, expr: Expr) -> FieldValue {
    FieldValue {
        attrs: Vec::new(),
        member: Member::Named(ident(name)),
        colon_token: Some(Token![:](Span::call_site())),
        expr,
    }
}
