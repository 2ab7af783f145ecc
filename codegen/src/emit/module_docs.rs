//! The first lines of a generated module.

use super::facts::quoted;
use crate::plan::Plan;

/// What was generated, from what, and of which device.
pub(super) fn lines(plan: &Plan<'_>) -> Vec<String> {
    let device = &plan.dictionary.device;
    let mut lines = vec![format!(
        " Object dictionary of {}, generated from {}. Do not edit.",
        product(plan),
        quoted(plan.file)
    )];
    lines.push(String::new());
    lines.extend(named("Vendor", &device.vendor_name));
    lines.extend(named("Order code", &device.order_code));
    lines.extend(named("Description", &plan.dictionary.file.description));
    if let Some(node_id) = plan
        .dictionary
        .commissioning
        .as_ref()
        .and_then(|commissioning| commissioning.node_id)
    {
        lines.push(format!(" * Configured for node-ID {}", node_id.get()));
    }
    lines.push(format!(
        " * {} values of {} objects; {} bytes of RAM",
        plan.rows.len(),
        plan.dictionary.objects.len(),
        plan.size()
    ));
    lines
}

fn product(plan: &Plan<'_>) -> String {
    match plan.dictionary.device.product_name.trim() {
        "" => "a device".to_owned(),
        name => quoted(name),
    }
}

fn named(what: &str, text: &str) -> Option<String> {
    (!text.trim().is_empty()).then(|| format!(" * {what}: {}", quoted(text)))
}
