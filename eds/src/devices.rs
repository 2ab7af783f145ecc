//! The EDS files of the encoders, written from their manuals: for build scripts that have no file of their own.
//!
//! Each is what `eds/devices/` has under that name; `docs/errata.md` of the repository says where they decide against a manual.

/// `wdga.eds`: Wachendorff WDGA, multiturn.
pub const WDGA: &[u8] = include_bytes!("../devices/wdga.eds");
/// `wdga-st.eds`: Wachendorff WDGA, singleturn.
pub const WDGA_ST: &[u8] = include_bytes!("../devices/wdga-st.eds");
/// `wv58mr.eds`: SIKO WV58MR and WH58MR, multiturn.
pub const WV58MR: &[u8] = include_bytes!("../devices/wv58mr.eds");
/// `wv58mr-st.eds`: SIKO WV58MR and WH58MR, singleturn.
pub const WV58MR_ST: &[u8] = include_bytes!("../devices/wv58mr-st.eds");
