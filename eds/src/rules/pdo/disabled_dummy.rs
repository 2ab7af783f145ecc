use super::mapped::{all_mapped, label};
use crate::{
    diagnostic::Level,
    ir::{Dictionary, Direction},
    rules::{DictionaryRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds RPDOs that map a data type which `[DummyUsage]` does not allow as a dummy.
    ///
    /// ## Why it matters
    /// The file says of one type that it cannot stand in a PDO and that it does. A master that checks `[DummyUsage]` refuses to
    /// configure the PDO as the device already has it.
    ///
    /// ## Example
    /// ```ini
    /// [DummyUsage]
    /// Dummy0005=0
    ///
    /// [1600sub1]
    /// DefaultValue=0x00050008
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [DummyUsage]
    /// Dummy0005=1
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, `[DummyUsage]`
    pub(crate) DisabledDummy { code: "PDO014", level: Level::Warn, since: "0.1.0" }
}

impl DictionaryRule for DisabledDummy {
    fn check(dictionary: &Dictionary, report: &mut Report) {
        let received = all_mapped(dictionary).filter(|mapped| mapped.pdo.direction == Direction::Receive);
        for mapped in received {
            let dummy = mapped.dummy();
            if let Some(data_type) = dummy.filter(|dummy| !dictionary.dummies.contains(dummy)) {
                let (pdo, name, index) = (label(&mapped.pdo), data_type.name(), data_type.index());
                report
                    .at(
                        mapped.span,
                        format!("{pdo} maps a dummy {name}, which [DummyUsage] does not allow"),
                    )
                    .help(format!("write `Dummy{index:04X}=1` in [DummyUsage]"));
            }
        }
    }
}
