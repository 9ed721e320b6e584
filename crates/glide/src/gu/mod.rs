//! The utility library.

mod file3df;
mod fog;
mod multipass;
mod rle;
mod texture;

pub use file3df::{
    Error3df, File3df, Header3df, MAX_FILE as MAX_3DF_FILE, MAX_HEADER as MAX_3DF_HEADER, Ncc3df,
    Table3df,
};
pub use fog::{fog_table_exp, fog_table_exp2, fog_table_linear, fog_table_w};
pub(crate) use multipass::MultiPass;
pub use rle::{Sprite, encode_rle16};
pub(crate) use texture::{Attributes, MipMaps};
pub use texture::{MAX_MIP_MAPS, MipMap, NCC_TABLE_BYTES, NULL_MIP_MAP, color_mip_map};
