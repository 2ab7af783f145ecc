//! Reals that look like a constant of mathematics. Clippy denies such literals, while 3.14 in an EDS is 3.14.

use std::f64::consts as c;

use syn::{Expr, parse_quote};

use super::{
    literal::{grouped, signed_number},
    node::{ident, path},
};

const CONSTANTS: [(f64, &str); 19] = [
    (c::E, "E"),
    (c::FRAC_1_PI, "FRAC_1_PI"),
    (c::FRAC_1_SQRT_2, "FRAC_1_SQRT_2"),
    (c::FRAC_2_PI, "FRAC_2_PI"),
    (c::FRAC_2_SQRT_PI, "FRAC_2_SQRT_PI"),
    (c::FRAC_PI_2, "FRAC_PI_2"),
    (c::FRAC_PI_3, "FRAC_PI_3"),
    (c::FRAC_PI_4, "FRAC_PI_4"),
    (c::FRAC_PI_6, "FRAC_PI_6"),
    (c::FRAC_PI_8, "FRAC_PI_8"),
    (c::LN_2, "LN_2"),
    (c::LN_10, "LN_10"),
    (c::LOG2_10, "LOG2_10"),
    (c::LOG2_E, "LOG2_E"),
    (c::LOG10_2, "LOG10_2"),
    (c::LOG10_E, "LOG10_E"),
    (c::PI, "PI"),
    (c::SQRT_2, "SQRT_2"),
    (c::TAU, "TAU"),
];

/// How `text`, a number of the type `rust` (`f32` or `f64`), is written when it looks like a constant, without its sign:
/// by the constant's name if it is the very same, else as a fraction, which is the same number since its parts are exact.
pub(super) fn near_constant(text: &str, rust: &str) -> Option<Expr> {
    let digits = text.trim_start_matches('-');
    let &(constant, name) = CONSTANTS.iter().find(|(constant, _)| looks_like(digits, *constant))?;
    if !is_exactly(digits, constant, rust) {
        return Some(fraction(digits));
    }
    let (rust, name) = (path(rust), ident(name));
    Some(parse_quote!(core::#rust::consts::#name))
}

/// Whether `digits` are the first ones of `constant`, or such digits rounded.
fn looks_like(digits: &str, constant: f64) -> bool {
    let decimals = digits.len().saturating_sub(2);
    digits.len() > 3 && (constant.to_string().starts_with(digits) || format!("{constant:.decimals$}") == digits)
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "an `f32`'s constants are the `f64`'s, rounded"
)]
fn is_exactly(digits: &str, constant: f64, rust: &str) -> bool {
    match rust {
        "f32" => digits.parse() == Ok(constant as f32),
        _ => digits.parse() == Ok(constant),
    }
}

/// `314.0 / 100.0`
fn fraction(digits: &str) -> Expr {
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let numerator = digits.replace('.', "");
    let denominator = format!("1{}", "0".repeat(decimals));
    let [numerator, denominator] =
        [numerator.trim_start_matches('0'), &denominator].map(|digits| signed_number(&(grouped(digits, 3) + ".0")));
    parse_quote!(#numerator / #denominator)
}

#[cfg(test)]
mod tests {
    use quote::ToTokens as _;

    use super::near_constant;

    #[test]
    fn a_value_near_a_constant_is_a_fraction_and_the_constant_itself_has_its_name() {
        let text =
            |digits: &str, rust: &str| near_constant(digits, rust).map(|expr| expr.to_token_stream().to_string());
        assert_eq!(text("3.14", "f32").as_deref(), Some("314.0 / 100.0"));
        assert_eq!(text("0.3183", "f64").as_deref(), Some("3183.0 / 10000.0"));
        assert_eq!(text("3.1415927", "f32").as_deref(), Some("core :: f32 :: consts :: PI"));
        assert_eq!(
            text("2.718281828459045", "f64").as_deref(),
            Some("core :: f64 :: consts :: E")
        );
        assert_eq!(text("3.15", "f32"), None);
        assert_eq!(text("3.1", "f32"), None);
    }
}
