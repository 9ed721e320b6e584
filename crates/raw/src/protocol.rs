//! The render-host protocol: 11-byte ASCII records.
//!
//! A record is a word as `0x` and eight hexadecimal digits, or a name padded with `*`, both ended
//! by a newline. Source: RAW, appendix on the render host.

/// Bytes in a record.
pub const RECORD_BYTES: usize = 11;

/// One record from the client.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Record {
    /// A word for the device.
    Data(u32),
    /// Wait for one word from the device and drop it.
    Wait,
    /// Pause or stop the simulation.
    Halt,
    /// The next record is a count; pass that many words back to the client.
    Read,
    /// The next record is text for the log.
    Debug,
    /// Start counting.
    PerfStart,
    /// Stop counting.
    PerfStop,
    /// A scene begins.
    EnterScene,
    /// A scene has ended.
    ExitScene,
    /// A frame has been sent.
    Frame,
    /// A primitive has been sent.
    Prim,
    /// Print the counters.
    Report,
    /// Zero the counters and stop counting.
    PerfReset,
    /// Reset the device whatever it is doing. Beyond the thesis.
    AsyncReset,
    /// Text for the log: what follows [`Record::Debug`], byte for byte.
    Text([u8; RECORD_BYTES]),
}

/// Names in the order in which prefixes are tried.
const NAMES: [(&str, Record); 13] = [
    ("wait", Record::Wait),
    ("halt", Record::Halt),
    ("read", Record::Read),
    ("debug", Record::Debug),
    ("pstart", Record::PerfStart),
    ("pstop", Record::PerfStop),
    ("penterss", Record::EnterScene),
    ("pexitss", Record::ExitScene),
    ("pframe", Record::Frame),
    ("pprim", Record::Prim),
    ("preport", Record::Report),
    ("preset", Record::PerfReset),
    ("areset", Record::AsyncReset),
];

/// A record that is neither a name nor a hexadecimal word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("malformed record \"{}\"", bytes.escape_ascii())]
pub struct MalformedRecord {
    /// The eleven bytes.
    pub bytes: [u8; RECORD_BYTES],
}

impl Record {
    /// Reads a record.
    ///
    /// # Errors
    /// The bytes are neither a known name nor a word of at most eight digits; the original parsed
    /// such a record as far as it went and sent the result.
    pub fn parse(bytes: [u8; RECORD_BYTES]) -> Result<Self, MalformedRecord> {
        for (name, record) in NAMES {
            if bytes.starts_with(name.as_bytes()) {
                return Ok(record);
            }
        }
        // A word without its newline has lost step with the stream.
        bytes
            .strip_suffix(b"\n")
            .map(|text| text.strip_prefix(b"0x").unwrap_or(text))
            .and_then(|digits| std::str::from_utf8(digits).ok())
            .filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))
            .and_then(|d| u32::from_str_radix(d, 16).ok())
            .map(Record::Data)
            .ok_or(MalformedRecord { bytes })
    }

    /// Reads a record from text as a client writes it: cut to ten characters, padded with `*`.
    ///
    /// # Errors
    /// As [`Record::parse`].
    pub fn from_text(text: &str) -> Result<Self, MalformedRecord> {
        Self::parse(padded(text))
    }

    /// Writes a record.
    pub fn bytes(self) -> [u8; RECORD_BYTES] {
        match self {
            Record::Text(bytes) => bytes,
            Record::Data(word) => data(word),
            named => {
                let name = NAMES.iter().find(|(_, record)| *record == named);
                padded(name.expect("every record but data and text has a name").0)
            }
        }
    }
}

/// A word as the eleven bytes of a record. Whole frame buffers are sent so:
/// no text is made on the way.
fn data(word: u32) -> [u8; RECORD_BYTES] {
    let mut out = *b"0x00000000\n";
    for (i, digit) in out[2..10].iter_mut().enumerate() {
        *digit = b"0123456789abcdef"[(word >> (28 - 4 * i) & 15) as usize];
    }
    out
}

/// Text as the eleven bytes of a record.
pub fn padded(text: &str) -> [u8; RECORD_BYTES] {
    let mut bytes = [b'*'; RECORD_BYTES];
    bytes[RECORD_BYTES - 1] = b'\n';
    for (to, from) in bytes.iter_mut().zip(text.bytes().take(RECORD_BYTES - 1)) {
        *to = from;
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_round_trip() {
        for record in NAMES.map(|n| n.1).into_iter().chain([Record::Data(0xdead_beef)]) {
            assert_eq!(Record::parse(record.bytes()), Ok(record));
        }
        assert_eq!(&Record::Wait.bytes(), b"wait******\n");
        assert_eq!(&Record::Data(26).bytes(), b"0x0000001a\n");
    }

    #[test]
    fn bad_records_are_named() {
        assert!(Record::parse(*b"0x12345g78\n").is_err());
        assert!(Record::parse(*b"+000000001\n").is_err());
        assert!(Record::parse(*b"0x0000001e0").is_err());
    }
}
