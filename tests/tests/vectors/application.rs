//! What the application does in the vectors that depend on it: the calls of the tests that they were recorded from.

use lexican_runtime::{Address, Emergency, NmtCommand, od};
use lexican_tests::{bus::Bus, simulated::Simulated};
use serde_json::Value;

/// 2500h:0Bh, which the recorded PDOs carry.
const MAPPED: Address = Address::new(0x2500, 0x0B);

/// One call.
enum Act {
    /// An error code occurs, with this bit of the error register.
    Raise(u16, u8),
    /// The same with bytes of the manufacturer.
    RaiseWith(u16, u8, [u8; 5]),
    /// An error code is gone.
    Clear(u16),
    /// The application sets an object of its dictionary, whatever a client may do.
    Set(u16, &'static [u8]),
    /// The application sets 2500h:0Bh.
    Mapped(u8),
    /// An event for a TPDO.
    Trigger(u16),
    /// 2500h:0Bh has changed.
    Changed,
}

use Act::{Changed, Clear, Mapped, Raise, RaiseWith, Set, Trigger};

/// Starts the node of a PDO vector that does not do so by a frame.
pub(crate) fn prepare(bus: &mut Bus<Simulated>, vector: &Value) {
    let mut exchanges = vector["exchanges"].as_array().into_iter().flatten();
    let is_recorded = matches!(vector["kind"].as_str(), Some("pdo_tx" | "pdo_rx"));
    if is_recorded && !exchanges.any(|exchange| exchange["request"]["id"] == "000") {
        bus.node().obey(NmtCommand::Start);
        bus.advance(0);
    }
}

/// Does what the application does in the exchange `number` of the vector `name`, between request and responses;
/// `remaining` exchanges follow it.
pub(crate) fn act(bus: &mut Bus<Simulated>, name: &str, number: usize, remaining: usize) {
    let acts = match (name, remaining) {
        ("TS_TPdo_Type255ViaObj", 0) => &[Changed],
        ("TS_TPdo_Type254ViaNum", 0) => &[Trigger(1)],
        _ => acts(name, number),
    };
    for act in acts {
        match *act {
            Raise(code, register) => {
                bus.node().raise_emergency(Emergency::new(code, register));
            }
            RaiseWith(code, register, bytes) => {
                bus.node().raise_emergency(Emergency::new(code, register).with(bytes));
            }
            Clear(code) => {
                bus.node().clear_emergency(code);
            }
            Set(index, bytes) => {
                od::set(bus.node().device_mut(), Address::new(index, 0), bytes).expect("such an object");
            }
            Mapped(value) => {
                od::set(bus.node().device_mut(), MAPPED, &[value]).expect("such an object");
            }
            Trigger(number) => assert!(bus.node().trigger_tpdo(number), "{name}"),
            Changed => assert!(bus.node().object_changed(MAPPED), "{name}"),
        }
        bus.advance(0);
    }
}

fn acts(name: &str, number: usize) -> &'static [Act] {
    match (name, number) {
        // Its 1014h is written by the test, without the node-ID.
        ("TS_Emcy_TxUserData", 0) => &[
            Set(0x1014, &[0x81, 0, 0, 0]),
            RaiseWith(0x2000, 0x02, [0x11, 0x12, 0x13, 0x14, 0x15]),
        ],
        ("TS_Emcy_TxChangedId", 0) => &[Set(0x1014, &[0x01, 0x01, 0, 0]), Raise(0x2000, 0x02)],
        ("TS_Emcy_ErrRegOnSetRepeat", 0) => &[Raise(0x2000, 0x02), Raise(0x2000, 0x02), Raise(0x3000, 0x04)],
        ("TS_Emcy_HistNumOnSetRepeat" | "TS_Emcy_HistObjOnSetRepeat", 0) => &[Raise(0x2000, 0x02), Raise(0x2000, 0x02)],
        ("TS_Emcy_HistNumOnSetMulti" | "TS_Emcy_HistClearOk", 0) => &[Raise(0x2000, 0x02), Raise(0x3000, 0x04)],
        ("TS_Emcy_HistNumOnClr", 0) => &[Raise(0x2000, 0x02), Raise(0x3000, 0x04), Clear(0x3000)],
        ("TS_Emcy_TxOnClr", 0) => &[Raise(0x2000, 0x02), Clear(0x2000)],
        ("TS_Emcy_ErrRegOnReset", 0) => &[Raise(0x2000, 0x02), Raise(0x3000, 0x04), Clear(0x2000), Clear(0x3000)],
        ("TS_Emcy_TxOnReset", 0) => &[Raise(0x2000, 0x02), Raise(0x4000, 0x08), Clear(0x2000), Clear(0x4000)],
        ("TS_TPdo_TmrAndNum" | "TS_TPdo_Inhibit", 0) => &[Trigger(1), Trigger(1)],
        ("TS_TPdo_TmrAndInhibit", 0) => &[Trigger(1)],
        ("TS_TPdo_ChangeEventTime", 0) => &[Mapped(0x11), Trigger(2)],
        ("TS_TPdo_SetEventTimeAndReset", 3) => &[Mapped(0x91), Trigger(2), Mapped(0x22), Trigger(2)],
        ("TS_TPdo_ChangeAsyncProperty", 1) => &[Mapped(0x91)],
        ("TS_TPdo_ChangeAsyncProperty", 2) => &[Mapped(0x33), Trigger(2)],
        (emcy, 0) if emcy.starts_with("TS_Emcy_") => &[Raise(0x2000, 0x02)],
        _ => &[],
    }
}
