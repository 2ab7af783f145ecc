use crate::{
    Reading,
    diagnostic::Level,
    ir::Problem,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds sub-objects of an object whose ObjectType allows none, though it has a DataType of its own: a VAR, a DOMAIN.
    ///
    /// ## Why it matters
    /// Nobody knows which of the two the device has: readers take the value, or the sub-objects, or refuse the file.
    ///
    /// ## Example
    /// ```ini
    /// [100B]
    /// ParameterName=Node-ID
    /// ObjectType=0x7
    /// DataType=0x0005
    /// AccessType=ro
    ///
    /// [100Bsub0]
    /// ParameterName=Node-ID
    /// DataType=0x0005
    /// AccessType=ro
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [100B]
    /// ParameterName=Node-ID
    /// ObjectType=0x7
    /// DataType=0x0005
    /// AccessType=ro
    /// ```
    ///
    /// ## Reference
    /// CiA 301, object codes; CANchkEDS V27
    pub(crate) SubObjectsOfSingleValue { code: "OBJ017", level: Level::Deny, since: "0.1.0" }
}

impl ReadingRule for SubObjectsOfSingleValue {
    fn check(reading: &Reading, report: &mut Report) {
        for problem in &reading.problems {
            if let Problem::SubsOfSingleValue { index, code, at } = *problem {
                let number = code.number();
                report
                    .at(
                        at,
                        format!("object {index:04X}h has sub-objects, but its ObjectType {number} allows none"),
                    )
                    .help("remove them, or fix the ObjectType");
            }
        }
    }
}
