//! The text of the file: bytes, lines, headers.

mod byte_order_mark;
mod control_character;
mod duplicate_keyword;
mod duplicate_section;
mod foreign_file;
mod hash_comment;
mod indented_header;
mod junk_line;
mod keyword_outside_section;
mod malformed_header;
mod mixed_line_ends;
mod overlong_line;
mod text_after_header;
mod text_not_ascii;

pub(super) use byte_order_mark::ByteOrderMark;
pub(super) use control_character::ControlCharacter;
pub(super) use duplicate_keyword::DuplicateKeyword;
pub(super) use duplicate_section::DuplicateSection;
pub(super) use foreign_file::ForeignFile;
pub(super) use hash_comment::HashComment;
pub(super) use indented_header::IndentedHeader;
pub(super) use junk_line::JunkLine;
pub(super) use keyword_outside_section::KeywordOutsideSection;
pub(super) use malformed_header::MalformedHeader;
pub(super) use mixed_line_ends::MixedLineEnds;
pub(super) use overlong_line::OverlongLine;
pub(super) use text_after_header::TextAfterHeader;
pub(super) use text_not_ascii::TextNotAscii;
