//! What every enum of calls can say of itself.

use crate::show::Fields;
use crate::value::Value;

/// An enum of numbered variants with named fields, as made by [`value_enum!`](crate::value_enum).
pub trait Tagged: Value {
    /// Number and name of each variant, in the order of declaration.
    const VARIANTS: &'static [(u16, &'static str)];

    /// The number of this variant, which is stable for ever.
    fn tag(&self) -> u16;

    /// The name of this variant, as declared.
    fn name(&self) -> &'static str;

    /// Names and values of the fields, in the order of declaration.
    fn fields(&self) -> Fields<'_>;
}

/// Rejects, at compile time, an enum two variants of which have one number.
///
/// Called by [`value_enum!`](crate::value_enum); of no use otherwise.
///
/// # Panics
/// If a number occurs twice.
pub const fn assert_distinct_tags(tags: &[u16]) {
    let mut first = 0;
    while first < tags.len() {
        let mut second = first + 1;
        while second < tags.len() {
            assert!(tags[first] != tags[second], "two variants have the same tag");
            second += 1;
        }
        first += 1;
    }
}
