//! Names of objects: numbers, counted from 1 in the order of creation. 0 is
//! none. A number is never used again.

macro_rules! handles {
    ($($(#[$meta:meta])* $name:ident),* $(,)?) => {$(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(
            /// The number, as calls carry it.
            pub u32,
        );
    )*};
}

handles! {
    /// A drawing engine: see [`crate::EngineId::BUILT_IN`].
    EngineId,
    /// A draw context.
    DrawContextId,
    /// A texture.
    TextureId,
    /// A bitmap.
    BitmapId,
    /// A colour table.
    ColorTableId,
}

impl EngineId {
    /// The engine of this crate. Engines of applications count from here on.
    pub const BUILT_IN: EngineId = EngineId(1);
}
