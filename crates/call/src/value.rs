//! What can be an argument of a call.

use std::fmt;

use crate::data::Data;
use crate::decode::{DecodeError, Decoder};
use crate::encode::Encoder;
use crate::show::{show_bytes, show_float, show_list};

/// Plain data that can be written as bytes, read back, and shown to a person.
///
/// `decode` of what `encode` wrote yields the same value, bit for bit. Each value takes at least
/// one byte. Implementations for a front end's own types come from [`value_enum!`](crate::value_enum),
/// [`value_struct!`](crate::value_struct) and [`value_symbols!`](crate::value_symbols).
pub trait Value {
    /// Appends this value.
    fn encode(&self, encoder: &mut Encoder);

    /// Reads one value.
    ///
    /// # Errors
    /// Any [`DecodeError`]; the decoder's position is then unspecified.
    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError>
    where
        Self: Sized;

    /// Prints the value for a listing, in one line. Long lists and data are abbreviated.
    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result;

    /// Appends all of `values`, without their number. Bytes override this to copy at once.
    fn encode_slice(values: &[Self], encoder: &mut Encoder)
    where
        Self: Sized,
    {
        for value in values {
            value.encode(encoder);
        }
    }

    /// Reads `count` values. The caller has checked that `count` bytes are left.
    ///
    /// # Errors
    /// Those of [`decode`](Self::decode).
    fn decode_list(count: usize, decoder: &mut Decoder<'_>) -> Result<Vec<Self>, DecodeError>
    where
        Self: Sized,
    {
        // Not `with_capacity(count)`: an element may be far larger in memory than encoded, and
        // the count is only a claim until the elements have been read.
        let mut list = Vec::new();
        for _ in 0..count {
            list.push(Self::decode(decoder)?);
        }
        Ok(list)
    }
}

/// The encoding of one value, all data in place.
pub fn to_bytes<T: Value>(value: &T) -> Vec<u8> {
    let mut encoder = Encoder::new();
    value.encode(&mut encoder);
    encoder.into_bytes()
}

/// The value that fills `bytes`, all data in place.
///
/// # Errors
/// Any [`DecodeError`], [`TrailingBytes`](crate::DecodeErrorKind::TrailingBytes) if the value ends
/// before the bytes do.
pub fn from_bytes<T: Value>(bytes: &[u8]) -> Result<T, DecodeError> {
    let mut decoder = Decoder::new(bytes);
    let value = T::decode(&mut decoder)?;
    decoder.finish()?;
    Ok(value)
}

/// Implements `Value` for integers that are shown in decimal.
macro_rules! integer {
    ($($type:ty),*) => {$(
        impl Value for $type {
            #[inline]
            fn encode(&self, encoder: &mut Encoder) {
                encoder.raw(&self.to_le_bytes());
            }

            #[inline]
            fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
                decoder.array().map(Self::from_le_bytes)
            }

            fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }
    )*};
}

integer!(u16, u32, u64, i8, i16, i32, i64);

impl Value for u8 {
    #[inline]
    fn encode(&self, encoder: &mut Encoder) {
        encoder.u8(*self);
    }

    #[inline]
    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.u8()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }

    fn encode_slice(values: &[Self], encoder: &mut Encoder) {
        encoder.raw(values);
    }

    fn decode_list(count: usize, decoder: &mut Decoder<'_>) -> Result<Vec<Self>, DecodeError> {
        decoder.raw(count).map(<[u8]>::to_vec)
    }
}

impl Value for f32 {
    #[inline]
    fn encode(&self, encoder: &mut Encoder) {
        encoder.f32(*self);
    }

    #[inline]
    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.f32()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        show_float(f, self, self.is_nan(), u64::from(self.to_bits()))
    }
}

impl Value for f64 {
    #[inline]
    fn encode(&self, encoder: &mut Encoder) {
        encoder.f64(*self);
    }

    #[inline]
    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.f64()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        show_float(f, self, self.is_nan(), self.to_bits())
    }
}

impl Value for bool {
    #[inline]
    fn encode(&self, encoder: &mut Encoder) {
        encoder.bool(*self);
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.bool()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Value for String {
    fn encode(&self, encoder: &mut Encoder) {
        encoder.str(self);
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.str().map(str::to_owned)
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self, f)
    }
}

impl Value for Data {
    fn encode(&self, encoder: &mut Encoder) {
        encoder.data(self);
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.data()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        show_bytes(f, self)
    }
}

impl<T: Value> Value for Option<T> {
    fn encode(&self, encoder: &mut Encoder) {
        encoder.bool(self.is_some());
        if let Some(value) = self {
            value.encode(encoder);
        }
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        match decoder.marker("option", 1)? {
            0 => Ok(None),
            _ => T::decode(decoder).map(Some),
        }
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Some(value) => value.show(f),
            None => f.write_str("none"),
        }
    }
}

impl<T: Value> Value for Vec<T> {
    fn encode(&self, encoder: &mut Encoder) {
        encoder.slice(self);
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        decoder.list()
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        show_list(f, self)
    }
}

impl<T: Value, const N: usize> Value for [T; N] {
    fn encode(&self, encoder: &mut Encoder) {
        T::encode_slice(self, encoder);
    }

    fn decode(decoder: &mut Decoder<'_>) -> Result<Self, DecodeError> {
        let mut elements = [const { None }; N];
        for element in &mut elements {
            *element = Some(T::decode(decoder)?);
        }
        Ok(elements.map(|element| element.expect("the loop above filled every element")))
    }

    fn show(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        show_list(f, self)
    }
}
