//! The devices and fixtures as `lexican-codegen` compiles them: the very files that its snapshots hold.

include!("../generated/cia406.snap.rs");
include!("../generated/cia406_multi.snap.rs");
include!("../generated/every_kind.snap.rs");
include!("../generated/multiplexed.snap.rs");
include!("../generated/servers.snap.rs");
include!("../generated/wdga.snap.rs");
include!("../generated/wdga_configured.snap.rs");
include!("../generated/wdga_st.snap.rs");
include!("../generated/wv58mr.snap.rs");
include!("../generated/wv58mr_configured.snap.rs");
include!("../generated/wv58mr_handled.snap.rs");
include!("../generated/wv58mr_st.snap.rs");
