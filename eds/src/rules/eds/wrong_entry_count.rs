use crate::{
    diagnostic::{Diagnostic, Level},
    fix::Fix,
    model::{Eds, List},
    rules::{ModelRule, Report, declare_rule},
    span::{Span, Spanned},
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
    pub(crate) WrongEntryCount { code: "EDS032", level: Level::Warn, since: "0.1.0", fixable: Sometimes }
}

impl ModelRule for WrongEntryCount {
    fn check(eds: &Eds, report: &mut Report) {
        check_texts(eds.comments.as_ref(), "Lines", report);
        for object in &eds.objects {
            check_texts(object.names.as_deref(), "NrOfEntries", report);
            check_numbers(object.values.as_deref(), "NrOfEntries", report);
            check_texts(object.denotations.as_deref(), "NrOfEntries", report);
            check_numbers(object.links.as_deref(), "ObjectLinks", report);
        }
        check_numbers(eds.connected_modules.as_ref(), "NrOfEntries", report);
        for module in &eds.modules {
            check_texts(module.comments.as_ref(), "Lines", report);
            check_numbers(module.fixed_objects.as_ref(), "NrOfEntries", report);
            check_numbers(module.sub_extends.as_ref(), "NrOfEntries", report);
        }
        // Its lines are the modules themselves, M1 to the number of them.
        let supported = eds.supported_modules.as_ref().and_then(|modules| modules.count);
        check_count(supported, eds.modules.len(), "NrOfEntries", "module", report);
    }
}

/// Each line of it can be read, so that the number is certain.
fn check_texts(list: Option<&List<String>>, keyword: &str, report: &mut Report) {
    let Some(list) = list else { return };
    let number = list.items.len();
    if let Some((finding, count)) = check_count(list.count, number, keyword, "line", report) {
        finding.fix(Fix::replace(count, number.to_string()));
    }
}

fn check_numbers<T>(list: Option<&List<T>>, keyword: &str, report: &mut Report) {
    let Some(list) = list else { return };
    check_count(list.count, list.items.len(), keyword, "line", report);
}

/// The finding, and where the number stands.
fn check_count<'r>(
    count: Option<Spanned<u32>>,
    number: usize,
    keyword: &str,
    what: &str,
    report: &'r mut Report,
) -> Option<(&'r mut Diagnostic, Span)> {
    let count = count.filter(|count| count.value as usize != number)?;
    let have = match number {
        0 => format!("there is no {what}"),
        1 => format!("there is one {what}"),
        number => format!("there are {number} {what}s"),
    };
    let at = report.bare(count.span);
    let finding = report.at(count.span, format!("{keyword} is {}, but {have}", count.value));
    finding.help(format!("write `{keyword}={number}`"));
    Some((finding, at))
}
