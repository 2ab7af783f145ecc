//! What follows from where the shaft is: cams (6300h) and the work area (6400h).

use lexican_runtime::profile::encoder::{Area, Cam, Cams, area};

use crate::wdga::Dictionary;

/// Shows the state of the cams at `position` of `range` (chapter 7.5).
pub(crate) fn show_cams(cams: &mut Cams, od: &mut Dictionary, position: u64, range: u64) {
    let [enable] = od.cam_enable_register;
    let [polarity] = od.cam_polarity_register;
    od.cam_state_register = [if enable == 0 {
        *cams = Cams::new();
        0
    } else {
        cams.update(&switch_points(od), enable, polarity, position, range)
    }];
}

/// Shows whether `position` is within the work area.
pub(crate) fn show_area(od: &mut Dictionary, position: u32) {
    let limits = Area {
        low: od.work_area_low_limit[0],
        high: od.work_area_high_limit[0],
        minimum: od.module_identification_minimum_position,
        maximum: od.module_identification_maximum_position,
    };
    od.area_state_register = [area(&limits, position.into())];
}

/// 6310h to 6337h
fn switch_points(od: &Dictionary) -> [Cam; 8] {
    let cam = |[low]: [i32; 1], [high]: [i32; 1], [hysteresis]: [u32; 1]| Cam { low, high, hysteresis };
    [
        cam(od.cam_1_low_limit, od.cam_1_high_limit, od.cam_1_hysteresis),
        cam(od.cam_2_low_limit, od.cam_2_high_limit, od.cam_2_hysteresis),
        cam(od.cam_3_low_limit, od.cam_3_high_limit, od.cam_3_hysteresis),
        cam(od.cam_4_low_limit, od.cam_4_high_limit, od.cam_4_hysteresis),
        cam(od.cam_5_low_limit, od.cam_5_high_limit, od.cam_5_hysteresis),
        cam(od.cam_6_low_limit, od.cam_6_high_limit, od.cam_6_hysteresis),
        cam(od.cam_7_low_limit, od.cam_7_high_limit, od.cam_7_hysteresis),
        cam(od.cam_8_low_limit, od.cam_8_high_limit, od.cam_8_hysteresis),
    ]
}
