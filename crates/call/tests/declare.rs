//! What a declaration yields besides the encoding.

use fillrate_call::{Shown, Tagged, Value};

use crate::{Call, Compare, corner};

#[test]
fn variants_are_listed_in_order() {
    let expected = [
        (1, "Init"),
        (2, "DrawTriangle"),
        (3, "BufferClear"),
        (4, "DepthFunction"),
        (5, "DrawPolygon"),
        (600, "Download"),
        (65535, "Wide"),
        (7, "Batch"),
    ];
    assert_eq!(Call::VARIANTS, expected);
}

#[test]
fn call_names_its_fields() {
    let call = Call::BufferClear { color: 0x10, alpha: 2, depth: 3 };
    assert_eq!((call.tag(), call.name()), (3, "BufferClear"));
    let fields: Vec<_> = call.fields().map(|field| (field.name, field.to_string())).collect();
    let expected = [("color", "16"), ("alpha", "2"), ("depth", "3")];
    assert_eq!(fields, expected.map(|(name, value)| (name, value.to_owned())));
    assert_eq!(Call::Init {}.fields().len(), 0);
}

#[test]
fn listing_shows_every_kind_of_value() {
    let shown = |value: &dyn Value| Shown(value).to_string();
    assert_eq!(shown(&corner(1.0)), "(x=1.0, y=1.5, tmu=[[1.0, 2.0, 3.0], [4.0, 5.0, 1.0]])");
    assert_eq!(shown(&f32::from_bits(0x7fc0_0001)), "nan(0x7fc00001)");
    assert_eq!(shown(&1e30f32), "1e30");
    assert_eq!(shown(&Some(3u8)), "3");
    assert_eq!(shown(&None::<u8>), "none");
    assert_eq!(shown(&vec![7u8; 10]), "[7, 7, 7, 7, 7, 7, 7, 7, 2 more]");
    assert_eq!(shown(&"a\nb".to_owned()), r#""a\nb""#);
    let call = Call::DepthFunction { function: Compare(1), mask: true };
    assert_eq!(call.to_string(), "DepthFunction(function=LESS, mask=true)");
    assert_eq!(Call::Init {}.to_string(), "Init()");
}

#[test]
fn symbols_keep_unnamed_numbers() {
    assert_eq!(Compare::ALWAYS.symbol(), Some("ALWAYS"));
    assert_eq!(Compare(0xdead).symbol(), None);
    assert_eq!(Compare(0xdead).to_string(), "0xdead");
}
