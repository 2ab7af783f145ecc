//! The virtual WV58MR and WH58MR, chapter by chapter of the manual 099/22.

mod device;

mod dialogues;
mod emcy;
mod guarding;
mod housing;
mod led;
mod lss;
mod parameters;
mod pdo;
mod position;
mod speed;
mod storage;
mod work_area;
