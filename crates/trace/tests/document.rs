//! The example in the format's description is what the writer writes.

use fillrate_trace::{FrameInfo, Meta, TraceWriter, meta};

use crate::read_all;

const DOCUMENT: &str = include_str!("../../../docs/trace-format.md");

/// The trace of the example.
fn example() -> Vec<u8> {
    let about = Meta::new().with(meta::API, "glide2x").with(meta::PROGRAM, "triangle");
    let mut writer = TraceWriter::new(Vec::new(), &about).expect("memory");
    writer.blob(b"texels").expect("memory");
    writer.record(&[3, 0, 0xff, 0, 0, 0, 0, 0xff, 0xff]).expect("memory");
    writer.record(&[7, 0, 1, 0, 0, 0]).expect("memory");
    let hash = Some(0x0123_4567_89ab_cdef);
    writer.end_frame(FrameInfo { width: 640, height: 480, hash }).expect("memory");
    writer.finish().expect("memory")
}

/// The bytes in the lines of the document that start with an offset in four hexadecimal digits.
fn bytes_in_document() -> Vec<u8> {
    let mut bytes = Vec::new();
    for line in DOCUMENT.lines() {
        let Some((offset, rest)) = line.split_once("  ") else { continue };
        if offset.len() != 4 || usize::from_str_radix(offset, 16) != Ok(bytes.len()) {
            continue;
        }
        // Two spaces at least separate the bytes from the remark.
        let pairs = rest.split(' ').map_while(|pair| u8::from_str_radix(pair, 16).ok());
        bytes.extend(pairs);
    }
    bytes
}

/// The form of the dump in the document, without its remarks.
fn dump(bytes: &[u8]) -> String {
    let line = |(index, row): (usize, &[u8])| {
        let digits: Vec<_> = row.iter().map(|byte| format!("{byte:02x}")).collect();
        format!("{:04x}  {}\n", index * 8, digits.join(" "))
    };
    bytes.chunks(8).enumerate().map(line).collect()
}

#[test]
fn example_in_the_document_is_exact() {
    let expected = example();
    let found = bytes_in_document();
    assert!(found == expected, "docs/trace-format.md should show:\n{}", dump(&expected));
    assert_eq!(read_all(&found).len(), 5);
}
