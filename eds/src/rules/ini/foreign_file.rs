use crate::{
    diagnostic::Level,
    document::{Document, Format, Problem},
    rules::{DocumentRule, Report, declare_rule},
};

declare_rule! {
    /// ## What it does
    /// Finds files that are no EDS and no DCF of CANopen, and says what they are. Nothing else is reported about such a file.
    ///
    /// ## Why it matters
    /// Other networks have an "EDS" too, and some readers make an empty CANopen device of it without a word.
    ///
    /// ## Example
    /// ```ini
    /// [File]
    /// DescText = "EtherNet/IP drive";
    /// Revision = 1.1;
    /// [Device]
    /// VendCode = 1;
    /// ```
    ///
    /// ## Reference
    /// CiA 306-1, format of the file; CiA 311 for CANopen XML
    pub(crate) ForeignFile { code: "INI014", level: Level::Deny, since: "0.1.0" }
}

impl DocumentRule for ForeignFile {
    fn check(document: &Document, report: &mut Report) {
        for problem in document.problems() {
            if let Problem::NotCanopen { what, at } = *problem {
                let (fact, cure) = words(what);
                report
                    .at(at, format!("this is no EDS or DCF of CANopen: {fact}"))
                    .help(cure);
            }
        }
    }
}

/// What it is, and what to do.
fn words(what: Format) -> (&'static str, &'static str) {
    const ASK: &str = "ask the vendor of the device for its CANopen EDS";
    match what {
        Format::Empty => ("the file is empty", "look for the right file"),
        Format::Binary => (
            "the bytes are no text",
            "look for the right file; an archive must be unpacked first",
        ),
        Format::Utf16 => ("the text is UTF-16", "save the file as ASCII or UTF-8"),
        Format::CanopenXml => (
            "it is a CANopen device description in XML (XDD, XDC or XPD)",
            "export it as EDS from the tool that made it; CANopenEditor reads XDD and writes EDS",
        ),
        Format::PowerlinkXml => ("it is a device description of Ethernet POWERLINK in XML", ASK),
        Format::Html => ("it is a web page", "the download went wrong: look for the file itself"),
        Format::Xml => ("it is XML", "look for the right file"),
        Format::Odva => ("it is an EDS of EtherNet/IP, DeviceNet or ControlNet", ASK),
        Format::Ini => ("it has no section that CiA 306-1 knows", "look for the right file"),
        Format::Text => ("it is a text without a section", "look for the right file"),
        Format::TooLarge => ("the file is larger than 1 GiB", "look for the right file"),
    }
}
