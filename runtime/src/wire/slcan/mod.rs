//! slcan: CAN frames as ASCII on a serial line, as Lawicel's CAN232 and CANUSB adapters speak it, and Linux' `slcand`,
//! python-can and most cheap adapters with them.
//!
//! ```text
//! host → adapter              adapter → host
//! S6<CR>                      <CR>                   500 kbit/s
//! O<CR>                       <CR>                   on the bus
//! t60184000100000000000<CR>   z<CR>                  601#4000100000000000 was sent
//!                             t58184300100096010200<CR>
//! x<CR>                       <BEL>                  not understood
//! ```
//!
//! A firmware that is its own adapter and a host that talks to one use the same three things: [`Lines`] gathers bytes to
//! lines, [`Command`] is what a host says, [`Answer`] what an adapter says. No IO, no state beyond the line that is coming
//! in.

mod answer;
mod command;
mod frame;
mod line;

pub use answer::Answer;
pub use command::Command;
pub use line::{Line, Lines};

/// Ends a line (CR).
pub const END: u8 = b'\r';

/// The adapter's answer to what it did not understand or could not do (BEL); it is a line of its own, without [`END`].
pub const REFUSAL: u8 = 0x07;
