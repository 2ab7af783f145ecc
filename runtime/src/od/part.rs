//! Values that are too long to be stored in the dictionary: the application gives and takes them in parts.

/// A part of a value that a client writes.
///
/// The first one has no bytes: it says that a download begins, before the client has sent anything, and may be refused. Then
/// the bytes come in order, as many at a time as the SDO server's buffer holds; the last ones when the client has said that
/// all is right, with its CRC if it has one. A download that is given up has no last part: the next one begins anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part<'a> {
    /// Bytes of the value before this part.
    pub offset: usize,
    /// The bytes.
    pub bytes: &'a [u8],
    /// Whether the value is complete now.
    pub is_last: bool,
    /// How many bytes the whole value has, if the client has said so; then the last part ends there.
    pub announced: Option<usize>,
}

impl Part<'_> {
    /// The part without bytes that begins a download.
    pub(crate) const fn announcement(announced: Option<usize>) -> Self {
        Self {
            offset: 0,
            bytes: &[],
            is_last: false,
            announced,
        }
    }

    /// Whether a download begins.
    #[must_use]
    pub const fn is_first(&self) -> bool {
        self.offset == 0 && self.bytes.is_empty() && !self.is_last
    }
}

/// Answers a request for a part of `value`, which stands in memory as a whole: copies its bytes from `offset` on into
/// `buffer`, as many as there are and fit, and gives its length.
pub fn copy_part(value: &[u8], offset: usize, buffer: &mut [u8]) -> usize {
    let rest = value.get(offset..).unwrap_or_default();
    buffer.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
    value.len()
}
