//! Expedited SDO transfers, byte by byte (CiA 301, 7.2.4.3), and what an access is refused for.

use lexican_runtime::AbortCode;
use lexican_tests::{
    bus::Bus,
    sample::{
        Quiet,
        device::{Device, Dictionary, Handlers},
        quiet,
    },
};

fn bus() -> Bus<Device<Quiet>> {
    Bus::booted(quiet(), 1)
}

#[test]
fn values_of_one_to_four_bytes_come_in_the_response_itself() {
    bus()
        .send("601#4000100000000000")
        .expect("581#4300100096010200")
        .send("601#4000200000000000")
        .expect("581#4F00200005000000")
        .send("601#4006200000000000")
        .expect("581#47062000FFFFFF00") // INTEGER24, −1
        .send("601#4017100000000000")
        .expect("581#4B17100000000000")
        .send("601#4009200000000000")
        .expect("581#4709200074616700"); // a string of three bytes
}

#[test]
fn a_value_of_each_length_is_written_and_read_back() {
    bus()
        .send("601#2F00200007000000")
        .expect("581#6000200000000000")
        .send("601#4000200000000000")
        .expect("581#4F00200007000000")
        .send("601#2B006200D2040000")
        .expect("581#6000620000000000")
        .send("601#4000620000000000")
        .expect("581#4B006200D2040000")
        .send("601#270620009DFFFF00") // −99
        .expect("581#6006200000000000")
        .send("601#4006200000000000")
        .expect("581#470620009DFFFF00")
        .send("601#2303600078563412")
        .expect("581#6003600000000000")
        .send("601#4003600000000000")
        .expect("581#4303600078563412");
}

#[test]
fn bytes_beyond_the_length_mean_nothing() {
    bus()
        .send("601#2F00200007AABBCC")
        .expect("581#6000200000000000")
        .send("601#4000200000000000")
        .expect("581#4F00200007000000");
}

#[test]
fn a_download_without_a_size_has_the_size_of_the_object() {
    bus()
        .send("601#2200620034120000")
        .expect("581#6000620000000000")
        .send("601#4000620000000000")
        .expect("581#4B00620034120000")
        // More than four bytes cannot have come.
        .send("601#2202200001020304")
        .expect("581#8002200010000706");
}

#[test]
fn what_does_not_exist_is_told_apart() {
    bus()
        .send("601#40FF5F0000000000")
        .expect("581#80FF5F0000000206")
        .send("601#4018100900000000")
        .expect("581#8018100911000906")
        .send("601#40181BFF00000000")
        .expect("581#80181BFF00000206")
        .send("601#401810FF00000000") // the structure of an object is not kept
        .expect("581#801810FF11000906")
        .send("601#23FF5F0001020304")
        .expect("581#80FF5F0000000206")
        .send("601#2318100901020304")
        .expect("581#8018100911000906");
}

#[test]
fn an_empty_place_of_the_table_is_no_object() {
    bus()
        .send("601#4000000000000000")
        .expect("581#8000000000000206")
        .send("601#400000FF00000000")
        .expect("581#800000FF00000206")
        .send("601#2300000000000000")
        .expect("581#8000000000000206");
}

#[test]
fn access_is_checked_before_the_length() {
    bus()
        .send("601#2F04600001000000") // one byte to a read-only UNSIGNED32
        .expect("581#8004600002000106")
        .send("601#2300100001000000") // a constant
        .expect("581#8000100002000106")
        .send("601#4008200000000000") // a write-only object
        .expect("581#8008200001000106");
}

#[test]
fn the_length_is_checked_before_the_limits() {
    bus()
        .send("601#23002000FF000000")
        .expect("581#8000200012000706")
        .send("601#2F17100000000000")
        .expect("581#8017100013000706")
        .send("601#230220000000000F") // four bytes to an UNSIGNED64
        .expect("581#8002200013000706");
}

#[test]
fn limits_are_kept() {
    bus()
        .send("601#2F0020000B000000")
        .expect("581#8000200031000906")
        .send("601#2F00200000000000")
        .expect("581#8000200032000906")
        .send("601#2F0020000A000000")
        .expect("581#6000200000000000")
        .send("601#2F00200001000000")
        .expect("581#6000200000000000")
        .send("601#2706200065000000") // INTEGER24: 101
        .expect("581#8006200031000906")
        .send("601#270620009BFFFF00") // −101
        .expect("581#8006200032000906")
        .send("601#270620009CFFFF00") // −100
        .expect("581#6006200000000000");
}

#[test]
fn limits_of_reals_are_kept() {
    bus()
        .send("601#230520000000C03F") // 1.5
        .expect("581#6005200000000000")
        .send("601#230520000100C03F")
        .expect("581#8005200031000906")
        .send("601#230520000100C0BF") // below −1.5
        .expect("581#8005200032000906")
        .send("601#230520000000C07F") // not a number
        .expect("581#8005200030000906")
        .send("601#4005200000000000")
        .expect("581#430520000000C03F");
}

#[test]
fn a_boolean_is_0_or_1() {
    bus()
        .send("601#2F01200000000000")
        .expect("581#6001200000000000")
        .send("601#2F01200002000000")
        .expect("581#8001200030000906")
        .send("601#4001200000000000")
        .expect("581#4F01200000000000")
        .send("601#2F01200001000000")
        .expect("581#6001200000000000")
        .send("601#4001200000000000")
        .expect("581#4F01200001000000");
}

#[test]
fn a_formula_of_the_node_id_has_its_value() {
    Bus::booted(quiet(), 0x10)
        .send("610#4014100000000000")
        .expect("590#4314100090000000")
        .send("610#4000120200000000")
        .expect("590#4300120290050000");
}

#[test]
fn a_short_string_is_written_in_the_request_itself() {
    bus()
        .send("601#2B09200068690000")
        .expect("581#6009200000000000")
        .send("601#4009200000000000")
        .expect("581#4B09200068690000");
}

#[test]
fn a_request_of_fewer_than_eight_bytes_a_remote_or_an_extended_frame_is_ignored() {
    bus()
        .send("601#400010")
        .silence()
        .send("601#R8")
        .silence()
        .send("00000601#4000100000000000")
        .silence()
        .send("602#4000100000000000")
        .silence();
}

#[test]
fn an_unknown_command_is_refused_with_the_multiplexer_that_it_brought() {
    bus()
        .send("601#E000620000000000")
        .expect("581#8000620001000405")
        .send("601#FF17100300000000")
        .expect("581#8017100301000405");
}

#[test]
fn an_abort_of_the_client_is_not_answered() {
    bus().send("601#8008100000000008").silence();
}

/// Counts positions, refuses presets above 1000.
struct Encoder;

impl Handlers for Encoder {
    fn write_preset_value(&mut self, od: &mut Dictionary, value: u32) -> Result<(), AbortCode> {
        if value > 1000 {
            return Err(AbortCode::DEVICE_STATE);
        }
        od.cyclic_timer = 7;
        Ok(())
    }

    fn read_position_value(&mut self, od: &mut Dictionary) -> Result<(), AbortCode> {
        od.position_value += 1;
        if od.position_value > 2 {
            Err(AbortCode::HARDWARE_ERROR)
        } else {
            Ok(())
        }
    }
}

#[test]
fn the_application_brings_a_value_up_to_date_before_it_is_read() {
    Bus::booted(Device::new(Encoder), 1)
        .send("601#4004600000000000")
        .expect("581#4304600001000000")
        .send("601#4004600000000000")
        .expect("581#4304600002000000")
        .send("601#4004600000000000")
        .expect("581#8004600000000606");
}

#[test]
fn the_application_may_refuse_a_value_and_then_nothing_is_stored() {
    Bus::booted(Device::new(Encoder), 1)
        .send("601#23036000E8030000")
        .expect("581#6003600000000000")
        .send("601#4000620000000000")
        .expect("581#4B00620007000000") // what the handler did beside it
        .send("601#23036000E9030000")
        .expect("581#8003600022000008")
        .send("601#4003600000000000")
        .expect("581#43036000E8030000");
}
