//! Which of two values is larger.

use std::cmp::Ordering;

use super::{NodeId, Value};

impl Value {
    /// How this compares with `other` as a number; `None` when one of them has no order: a text, bytes, a time, not a number,
    /// or a real and an integer.
    ///
    /// `node_id` resolves a formula; without it `$NODEID` counts as 0.
    #[must_use]
    pub fn compare(&self, other: &Self, node_id: Option<NodeId>) -> Option<Ordering> {
        if let (Some(left), Some(right)) = (self.real(), other.real()) {
            return left.partial_cmp(&right);
        }
        Some(self.integer(node_id)?.cmp(&other.integer(node_id)?))
    }

    fn integer(&self, node_id: Option<NodeId>) -> Option<i128> {
        match self {
            Self::Boolean(value) => Some(i128::from(*value)),
            Self::Integer(value) => Some(i128::from(*value)),
            Self::Unsigned(value) => Some(i128::from(*value)),
            Self::NodeIdPlus(base) => {
                let sum = base.wrapping_add(node_id.map_or(0, |id| u64::from(id.get())));
                Some(i128::from(sum))
            }
            _ => None,
        }
    }

    fn real(&self) -> Option<f64> {
        match self {
            Self::Real32(value) => Some(f64::from(*value)),
            Self::Real64(value) => Some(*value),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_compare_across_their_kinds() {
        let less = Some(Ordering::Less);
        assert_eq!(Value::Integer(-1).compare(&Value::Unsigned(0), None), less);
        assert_eq!(Value::Integer(i64::MAX).compare(&Value::Unsigned(u64::MAX), None), less);
        assert_eq!(Value::Real32(0.5).compare(&Value::Real64(0.75), None), less);
        assert_eq!(Value::Boolean(false).compare(&Value::Boolean(true), None), less);
    }

    #[test]
    fn a_formula_compares_as_what_it_gives_for_the_node() {
        let formula = Value::NodeIdPlus(0x180);
        let node = NodeId::new(5);
        assert_eq!(formula.compare(&Value::Unsigned(0x185), node), Some(Ordering::Equal));
        assert_eq!(formula.compare(&Value::Unsigned(0x180), None), Some(Ordering::Equal));
    }

    #[test]
    fn what_has_no_order_does_not_compare() {
        assert_eq!(Value::Real32(f32::NAN).compare(&Value::Real32(0.0), None), None);
        assert_eq!(Value::Real32(1.0).compare(&Value::Unsigned(0), None), None);
        assert_eq!(Value::Text(String::new()).compare(&Value::Unsigned(0), None), None);
    }
}
