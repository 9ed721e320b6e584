//! Printing values for listings.

use std::fmt;

use crate::data::BlobId;
use crate::value::Value;

/// How many elements of a list are shown before the rest is only counted.
const SHOWN_ELEMENTS: usize = 8;

/// A named argument of a call or field of a record.
#[derive(Clone, Copy)]
pub struct Field<'a> {
    /// The name, as the front end spells it.
    pub name: &'static str,
    /// What it holds.
    pub value: &'a dyn Value,
}

/// Shows the value without the name.
impl fmt::Display for Field<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.show(f)
    }
}

impl fmt::Debug for Field<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={self}", self.name)
    }
}

/// The arguments of one call in the order in which they are declared.
#[derive(Clone, Debug)]
pub struct Fields<'a>(std::vec::IntoIter<Field<'a>>);

impl<'a> Fields<'a> {
    /// Fields in this order.
    pub fn new(fields: Vec<Field<'a>>) -> Self {
        Self(fields.into_iter())
    }
}

impl<'a> Iterator for Fields<'a> {
    type Item = Field<'a>;

    fn next(&mut self) -> Option<Field<'a>> {
        self.0.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.0.size_hint()
    }
}

impl ExactSizeIterator for Fields<'_> {}

/// Lets a value be used with `format!` and its relatives.
#[derive(Clone, Copy)]
pub struct Shown<'a>(pub &'a dyn Value);

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.show(f)
    }
}

/// Prints `name(a=1, b=2)`; the common form of calls and records.
///
/// # Errors
/// Those of the formatter.
pub fn show_record(f: &mut fmt::Formatter<'_>, name: &str, fields: &[Field<'_>]) -> fmt::Result {
    write!(f, "{name}(")?;
    for (index, field) in fields.iter().enumerate() {
        let comma = if index == 0 { "" } else { ", " };
        write!(f, "{comma}{}={field}", field.name)?;
    }
    f.write_str(")")
}

/// Prints a float in its shortest exact form, NaN with its bit pattern.
pub(crate) fn show_float(
    f: &mut fmt::Formatter<'_>,
    value: &dyn fmt::Debug,
    is_nan: bool,
    bits: u64,
) -> fmt::Result {
    if is_nan { write!(f, "nan({bits:#x})") } else { value.fmt(f) }
}

/// Prints the first elements, and how many more there are.
pub(crate) fn show_list<T: Value>(f: &mut fmt::Formatter<'_>, list: &[T]) -> fmt::Result {
    f.write_str("[")?;
    for (index, element) in list.iter().take(SHOWN_ELEMENTS).enumerate() {
        f.write_str(if index == 0 { "" } else { ", " })?;
        element.show(f)?;
    }
    match list.len().saturating_sub(SHOWN_ELEMENTS) {
        0 => f.write_str("]"),
        more => write!(f, ", {more} more]"),
    }
}

/// Prints the size and the content hash of large data.
pub(crate) fn show_bytes(f: &mut fmt::Formatter<'_>, bytes: &[u8]) -> fmt::Result {
    write!(f, "{} bytes {}", bytes.len(), BlobId::of(bytes))
}
