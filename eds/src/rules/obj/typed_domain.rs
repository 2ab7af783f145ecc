use crate::{
    diagnostic::Level,
    ir::{DataType, ObjectCode},
    model::Eds,
    rules::{ModelRule, Report, declare_rule},
    span::Spanned,
};

declare_rule! {
    /// ## What it does
    /// Finds objects with ObjectType DOMAIN and another DataType than DOMAIN.
    ///
    /// ## Why it matters
    /// A domain has bytes of any number, a value of a type has as many as the type. Tools that go by the one or the other read a file or a
    /// number.
    ///
    /// ## Example
    /// ```ini
    /// [2000]
    /// ParameterName=Firmware
    /// ObjectType=0x2
    /// DataType=0x0005
    /// ```
    ///
    /// Use instead:
    /// ```ini
    /// [2000]
    /// ParameterName=Firmware
    /// ObjectType=0x2
    /// DataType=0x000F
    /// ```
    ///
    /// ## Reference
    /// CiA 301, 7.4.3, DOMAIN; CiA 306-1, ObjectType
    pub(crate) TypedDomain { code: "OBJ033", level: Level::Warn, since: "0.1.0" }
}

impl ModelRule for TypedDomain {
    fn check(eds: &Eds, report: &mut Report) {
        for object in &eds.objects {
            let subs = object.subs.iter().map(|sub| &sub.description);
            for description in object.description.iter().chain(subs) {
                let is_domain = description
                    .object_type
                    .is_some_and(|code| code.value == ObjectCode::Domain);
                let other = |data_type: &Spanned<u16>| data_type.value != DataType::Domain.index();
                if let Some(data_type) = description.data_type.filter(other).filter(|_| is_domain) {
                    let stated = report.quote(data_type.span);
                    let name = DataType::from_index(data_type.value).map_or(stated, |known| known.name().to_owned());
                    report
                        .at(data_type.span, format!("the object is a DOMAIN, but of type {name}"))
                        .help("write `DataType=0x000F`, or `ObjectType=0x7` for a value of that type");
                }
            }
        }
    }
}
