use crate::{
    Reading,
    diagnostic::Level,
    ir::{AccessType, Address, DataType, Entry, NodeId, Value},
    model::Description,
    rules::{ReadingRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds a ParameterValue for a constant, or for a read-only parameter of SDOs and PDOs (1200h to 1BFFh), whose DefaultValue is
    /// another one.
    ///
    /// ## Why it matters
    /// No tool can write it: the device keeps the value that it has, and the configuration is never what the file says.
    ///
    /// Other read-only values change by themselves: a tool may have read them from the device, and they are left alone.
    ///
    /// ## Example
    /// ```ini
    /// [1A00sub0]
    /// ParameterName=Number of mapped objects
    /// AccessType=const
    /// DefaultValue=1
    /// ParameterValue=2
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [1A00sub0]
    /// ParameterName=Number of mapped objects
    /// AccessType=const
    /// DefaultValue=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, 5.2, ParameterValue
    pub(crate) ChangedConstantParameter { code: "DCF009", level: Level::Warn, since: "0.1.0" }
}

impl ReadingRule for ChangedConstantParameter {
    fn check(reading: &Reading, report: &mut Report) {
        let Some(commissioning) = &reading.dictionary.commissioning else {
            return;
        };
        for object in &reading.eds.objects {
            let single = object.description.iter().map(|description| (0, description));
            let subs = object.subs.iter().map(|sub| (sub.sub, &sub.description));
            for (sub, description) in single.chain(subs) {
                let entry = reading.dictionary.entry(Address::new(object.index, sub));
                if let Some(entry) = entry.filter(|entry| entry.configured && stays(entry)) {
                    check_value(description, entry.data_type, commissioning.node_id, report);
                }
            }
        }
    }
}

/// Whether the value is the same whenever it is read.
fn stays(entry: &Entry) -> bool {
    let parameter = (0x1200..0x1C00).contains(&entry.address.index);
    entry.access == AccessType::Const || (entry.access == AccessType::Ro && parameter)
}

fn check_value(description: &Description, data_type: DataType, node_id: Option<NodeId>, report: &mut Report) {
    let (default, parameter) = (&description.default_value, description.parameter_value());
    let (Some(default), Some(parameter)) = (default, parameter) else {
        return;
    };
    let bytes = |value: &Value| value.to_bytes(data_type, node_id);
    if bytes(&default.value) != bytes(&parameter.value) {
        let (ours, theirs) = (report.quote(parameter.span), report.quote(default.span));
        report
            .at(
                parameter.span,
                format!("ParameterValue {ours} cannot be written; the device has {theirs}"),
            )
            .related(default.span, "the value that stays")
            .help("remove the ParameterValue, or fix the AccessType");
    }
}
