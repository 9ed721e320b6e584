//! The utility library's parts that need no board.

mod fog;

pub use fog::{fog_table_exp, fog_table_exp2, fog_table_linear, fog_table_w};
