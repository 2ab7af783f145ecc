//! Time, from SysTick.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::{SYST, syst::SystClkSource};
use cortex_m_rt::exception;
use lexican_runtime::Instant;

/// The oscillator that the chip starts with, divided as it starts.
const HERTZ: u32 = 12_500_000;

/// Milliseconds since the start; they wrap after 49 days.
static MILLIS: AtomicU32 = AtomicU32::new(0);

/// A clock that does not wrap, as long as it is asked once in 49 days.
#[derive(Debug)]
pub(crate) struct Clock {
    last: u32,
    wraps: u32,
}

impl Clock {
    /// Lets SysTick interrupt every millisecond.
    pub(crate) fn start(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(HERTZ / 1000 - 1);
        timer.clear_current();
        timer.enable_counter();
        timer.enable_interrupt();
        Self { last: 0, wraps: 0 }
    }

    /// The time.
    pub(crate) fn now(&mut self) -> Instant {
        let millis = MILLIS.load(Ordering::Relaxed);
        if millis < self.last {
            self.wraps = self.wraps.wrapping_add(1);
        }
        self.last = millis;
        Instant::from_millis(u64::from(self.wraps) << 32 | u64::from(millis))
    }

    /// Sleeps until `due`, or until `is_idle` is no more: the interrupts that wake it are those that change either.
    pub(crate) fn sleep_until(&mut self, due: Option<Instant>, is_idle: fn() -> bool) {
        while due.is_none_or(|due| self.now() < due) {
            // An interrupt between the question and the sleep ends the sleep, and is served after it.
            let slept = cortex_m::interrupt::free(|_| {
                let idle = is_idle();
                if idle {
                    cortex_m::asm::wfi();
                }
                idle
            });
            if !slept {
                return;
            }
        }
    }
}

#[exception]
fn SysTick() {
    // The only writer.
    let millis = MILLIS.load(Ordering::Relaxed);
    MILLIS.store(millis.wrapping_add(1), Ordering::Relaxed);
}
