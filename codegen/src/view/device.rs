//! The file and the device, as templates see them.

use lexican_eds::ir::{Commissioning, DeviceInfo};
use lexican_templates::{Value, context};

use crate::plan::Plan;

pub(super) fn file(plan: &Plan<'_>) -> Value {
    let file = &plan.dictionary.file;
    context! {
        name => plan.file,
        version => file.file_version,
        revision => file.file_revision,
        eds_version => file.eds_version.as_str(),
        description => file.description.as_str(),
    }
}

pub(super) fn device(device: &DeviceInfo) -> Value {
    context! {
        vendor_name => device.vendor_name.as_str(),
        vendor_number => device.vendor_number,
        product_name => device.product_name.as_str(),
        product_number => device.product_number,
        revision_number => device.revision_number,
        order_code => device.order_code.as_str(),
        baud_rates => device.baud_rates.0.clone(),
        simple_boot_up_master => device.simple_boot_up_master,
        simple_boot_up_slave => device.simple_boot_up_slave,
        granularity => device.granularity,
        dynamic_channels_supported => device.dynamic_channels_supported,
        group_messaging => device.group_messaging,
        nr_of_rx_pdo => device.nr_of_rx_pdo,
        nr_of_tx_pdo => device.nr_of_tx_pdo,
        lss_supported => device.lss_supported,
        ng_slave => device.ng_slave,
    }
}

pub(super) fn commissioning(commissioning: &Commissioning) -> Value {
    context! {
        node_id => commissioning.node_id.map(lexican_eds::ir::NodeId::get),
        node_name => commissioning.node_name.as_str(),
        baud_rate => commissioning.baud_rate,
        net_number => commissioning.net_number,
        network_name => commissioning.network_name.as_str(),
        canopen_manager => commissioning.canopen_manager,
        lss_serial_number => commissioning.lss_serial_number,
    }
}
