use crate::{
    diagnostic::Level,
    ir::Address,
    model::{Description, Eds},
    rules::{ModelRule, Report, declare_rule, more},
};

declare_rule! {
    /// ## What it does
    /// Finds objects and sub-objects whose ParameterName is there but empty. One finding for an object.
    ///
    /// ## Why it matters
    /// Users of a tool see a line without a word, and a generator has to make up a name.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// ParameterName=
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ParameterName=Gain
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, ParameterName. A missing one is EDS002.
    pub(crate) EmptyName { code: "OBJ032", level: Level::Note, since: "0.1.0" }
}

impl ModelRule for EmptyName {
    fn check(eds: &Eds, report: &mut Report) {
        for object in &eds.objects {
            let subs = object.subs.iter().map(|sub| (Some(sub.sub), &sub.description));
            let own = object.description.as_ref().map(|description| (None, description));
            let mut nameless = own
                .into_iter()
                .chain(subs)
                .filter(|(_, description)| is_nameless(description));
            if let Some((sub, description)) = nameless.next() {
                let (which, more) = (designation(object.index, sub), more(nameless.count()));
                report
                    .at(description.header, format!("{which} has an empty ParameterName{more}"))
                    .help("write what the value is");
            }
        }
    }
}

fn is_nameless(description: &Description) -> bool {
    let name = description.parameter_name.as_ref();
    name.is_some_and(|name| name.value.is_empty())
}

/// `2000h`, or `2000sub1`.
fn designation(index: u16, sub: Option<u8>) -> String {
    sub.map_or_else(|| format!("{index:04X}h"), |sub| Address::new(index, sub).to_string())
}
