//! The declarations from which everything about a value follows.

/// Declares an enum of numbered variants with named fields, and all that [`Tagged`](crate::Tagged)
/// and [`Value`](crate::Value) promise.
///
/// Encoding: the number as two bytes, then the fields in the order of declaration. The number and
/// the fields of a variant never change once a trace with it exists; a changed call is a new
/// variant with a new number.
///
/// `Debug`, `Clone`, `PartialEq` and `Display` (`Name(a=1, b=2)`) come with it; further derives and
/// attributes may be given. The documentation of a variant covers its fields.
///
/// See the [crate documentation](crate) for an example.
#[macro_export]
macro_rules! value_enum {
    (
        $(#[$meta:meta])*
        $vis:vis enum $name:ident {
            $(
                $(#[$variant_meta:meta])*
                $tag:literal => $variant:ident {
                    $( $(#[$field_meta:meta])* $field:ident : $type:ty ),* $(,)?
                }
            ),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        // A boxed variant would cost an allocation per triangle.
        #[allow(clippy::large_enum_variant)]
        $vis enum $name {
            $(
                $(#[$variant_meta])*
                $variant {
                    $( $(#[$field_meta])* #[allow(missing_docs)] $field: $type ),*
                }
            ),*
        }

        const _: () = $crate::assert_distinct_tags(&[$($tag),*]);

        impl $crate::Value for $name {
            #[inline]
            fn encode(&self, encoder: &mut $crate::Encoder) {
                match self {
                    $(
                        Self::$variant { $($field),* } => {
                            encoder.u16($tag);
                            $( $crate::Value::encode($field, encoder); )*
                        }
                    )*
                }
            }

            fn decode(
                decoder: &mut $crate::Decoder<'_>,
            ) -> ::core::result::Result<Self, $crate::DecodeError> {
                let offset = decoder.offset();
                match decoder.u16()? {
                    $(
                        $tag => ::core::result::Result::Ok(Self::$variant {
                            $( $field: <$type as $crate::Value>::decode(decoder)? ),*
                        }),
                    )*
                    tag => ::core::result::Result::Err($crate::DecodeError {
                        offset,
                        kind: $crate::DecodeErrorKind::UnknownTag {
                            type_name: ::core::stringify!($name),
                            tag,
                        },
                    }),
                }
            }

            fn show(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self {
                    $(
                        Self::$variant { $($field),* } => $crate::show_record(
                            f,
                            ::core::stringify!($variant),
                            &[$($crate::Field { name: ::core::stringify!($field), value: $field }),*],
                        ),
                    )*
                }
            }
        }

        impl $crate::Tagged for $name {
            const VARIANTS: &'static [(u16, &'static str)] =
                &[$(($tag, ::core::stringify!($variant))),*];

            fn tag(&self) -> u16 {
                match self {
                    $( Self::$variant { .. } => $tag, )*
                }
            }

            fn name(&self) -> &'static str {
                match self {
                    $( Self::$variant { .. } => ::core::stringify!($variant), )*
                }
            }

            fn fields(&self) -> $crate::Fields<'_> {
                $crate::Fields::new(match self {
                    $(
                        Self::$variant { $($field),* } => ::std::vec![
                            $($crate::Field { name: ::core::stringify!($field), value: $field }),*
                        ],
                    )*
                })
            }
        }

        impl ::core::fmt::Display for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::Value::show(self, f)
            }
        }
    };
}

/// Declares a record with named fields, and all that [`Value`](crate::Value) promises.
///
/// Encoding: the fields in the order of declaration, nothing between them. The fields never change
/// once a trace with the record exists.
///
/// `Debug`, `Clone` and `PartialEq` come with it; further derives and attributes may be given. At
/// least one field is needed, since a value takes at least one byte.
///
/// See the [crate documentation](crate) for an example.
#[macro_export]
macro_rules! value_struct {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident {
            $( $(#[$field_meta:meta])* $field_vis:vis $field:ident : $type:ty ),+ $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        $vis struct $name {
            $( $(#[$field_meta])* $field_vis $field: $type ),+
        }

        impl $crate::Value for $name {
            #[inline]
            fn encode(&self, encoder: &mut $crate::Encoder) {
                $( $crate::Value::encode(&self.$field, encoder); )+
            }

            #[inline]
            fn decode(
                decoder: &mut $crate::Decoder<'_>,
            ) -> ::core::result::Result<Self, $crate::DecodeError> {
                ::core::result::Result::Ok(Self {
                    $( $field: <$type as $crate::Value>::decode(decoder)? ),+
                })
            }

            fn show(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::show_record(
                    f,
                    "",
                    &[$($crate::Field { name: ::core::stringify!($field), value: &self.$field }),+],
                )
            }
        }
    };
}

/// Declares a number some values of which have names, as enumerants of a C header do.
///
/// Any number can be held, encoded and decoded, since a program may pass any; those with a name are
/// shown by it, others in hexadecimal. The names become associated constants.
///
/// `Debug`, `Clone`, `Copy`, `PartialEq`, `Eq`, `Hash` and `Display` come with it.
///
/// ```
/// fillrate_call::value_symbols! {
///     /// How depths are compared.
///     pub struct Compare(u32) {
///         /// Nothing passes.
///         NEVER = 0,
///         /// Everything passes.
///         ALWAYS = 7,
///     }
/// }
///
/// assert_eq!(Compare::ALWAYS, Compare(7));
/// assert_eq!(Compare(0).to_string(), "NEVER");
/// assert_eq!(Compare(99).to_string(), "0x63");
/// ```
#[macro_export]
macro_rules! value_symbols {
    (
        $(#[$meta:meta])*
        $vis:vis struct $name:ident($type:ty) {
            $( $(#[$symbol_meta:meta])* $symbol:ident = $number:expr ),* $(,)?
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        $vis struct $name(
            /// The number, as a program passed it.
            pub $type
        );

        impl $name {
            $( $(#[$symbol_meta])* pub const $symbol: Self = Self($number); )*

            /// The name of this number, if it has one; the first, if several.
            pub fn symbol(self) -> ::core::option::Option<&'static str> {
                $(
                    if self == Self::$symbol {
                        return ::core::option::Option::Some(::core::stringify!($symbol));
                    }
                )*
                ::core::option::Option::None
            }
        }

        impl $crate::Value for $name {
            #[inline]
            fn encode(&self, encoder: &mut $crate::Encoder) {
                $crate::Value::encode(&self.0, encoder);
            }

            #[inline]
            fn decode(
                decoder: &mut $crate::Decoder<'_>,
            ) -> ::core::result::Result<Self, $crate::DecodeError> {
                <$type as $crate::Value>::decode(decoder).map(Self)
            }

            fn show(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                match self.symbol() {
                    ::core::option::Option::Some(symbol) => f.write_str(symbol),
                    ::core::option::Option::None => ::core::write!(f, "{:#x}", self.0),
                }
            }
        }

        impl ::core::fmt::Display for $name {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                $crate::Value::show(self, f)
            }
        }
    };
}
