//! What may be written in PRE-OPERATIONAL only.

/// Methods of `Handlers` that refuse to write in any other state, each with the type of its value; `[u32]` stands for an
/// array, whose method has the sub-index too.
macro_rules! in_preoperational {
    ($($name:ident: $type:tt;)*) => { $( in_preoperational!(@ $name $type); )* };
    (@ $name:ident [$type:ty]) => {
        fn $name(&mut self, _: &mut Dictionary, _: u8, _: $type) -> Result<(), AbortCode> {
            self.in_preoperational()
        }
    };
    (@ $name:ident $type:ty) => {
        fn $name(&mut self, _: &mut Dictionary, _: $type) -> Result<(), AbortCode> {
            self.in_preoperational()
        }
    };
}

pub(crate) use in_preoperational;
