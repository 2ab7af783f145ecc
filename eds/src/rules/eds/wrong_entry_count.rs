use crate::{
    diagnostic::Level,
    model::{Eds, List},
    rules::{ModelRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds numbers of lines that are not the number of lines below them: NrOfEntries of `[xxxxName]`, `[xxxxValue]`,
    /// `[xxxxDenotation]`, `[ConnectedModules]` and a module's lists, ObjectLinks, Lines of `[Comments]`. Also an NrOfEntries of
    /// `[SupportedModules]` that is not the number of modules that the file describes.
    ///
    /// ## Why it matters
    /// A reader that trusts the number stops too early, or looks for lines that are not there.
    ///
    /// ## Example
    /// ```ini
    /// [Comments]
    /// Lines=2
    /// Line1=Gain and offset are stored by 1010h.
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [Comments]
    /// Lines=1
    /// Line1=Gain and offset are stored by 1010h.
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, NrOfEntries, ObjectLinks, `[Comments]`. Of the lists of objects it is EDS005.
    pub(crate) WrongEntryCount { code: "EDS032", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for WrongEntryCount {
    fn check(eds: &Eds, report: &mut Report) {
        check_list(eds.comments.as_ref(), "Lines", report);
        for object in &eds.objects {
            check_list(object.names.as_deref(), "NrOfEntries", report);
            check_list(object.values.as_deref(), "NrOfEntries", report);
            check_list(object.denotations.as_deref(), "NrOfEntries", report);
            check_list(object.links.as_deref(), "ObjectLinks", report);
        }
        check_list(eds.connected_modules.as_ref(), "NrOfEntries", report);
        for module in &eds.modules {
            check_list(module.comments.as_ref(), "Lines", report);
            check_list(module.fixed_objects.as_ref(), "NrOfEntries", report);
            check_list(module.sub_extends.as_ref(), "NrOfEntries", report);
        }
        // Its lines are the modules themselves, M1 to the number of them.
        let supported = eds.supported_modules.as_ref().and_then(|modules| modules.count);
        check_count(supported, eds.modules.len(), "NrOfEntries", "module", report);
    }
}

fn check_list<T>(list: Option<&List<T>>, keyword: &str, report: &mut Report) {
    let Some(list) = list else { return };
    check_count(list.count, list.items.len(), keyword, "line", report);
}

fn check_count(count: Option<Spanned<u32>>, number: usize, keyword: &str, what: &str, report: &mut Report) {
    let Some(count) = count.filter(|count| count.value as usize != number) else {
        return;
    };
    let have = match number {
        0 => format!("there is no {what}"),
        1 => format!("there is one {what}"),
        number => format!("there are {number} {what}s"),
    };
    report
        .at(count.span, format!("{keyword} is {}, but {have}", count.value))
        .help(format!("write `{keyword}={number}`"));
}
