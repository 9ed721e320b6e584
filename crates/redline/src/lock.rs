//! What a program changed in a locked buffer.
//!
//! A lock hands out a copy; the unlock brings back only what differs from it,
//! so that drawing in between is not undone. Changes are runs: offset and
//! length as 32-bit numbers, the low byte first, then the bytes.

use fillrate_call::Data;

/// Equal bytes between two changes up to which they are one run: a run's head
/// takes as many.
const GAP: usize = 8;

/// The runs in which `after` differs from `before`; they have one length.
pub fn changes(before: &[u8], after: &[u8]) -> Data {
    let mut out = Vec::new();
    let mut run: Option<(usize, usize)> = None;
    for (at, _) in before.iter().zip(after).enumerate().filter(|(_, (a, b))| a != b) {
        run = match run {
            Some((from, to)) if at - to <= GAP => Some((from, at + 1)),
            Some(done) => {
                push(&mut out, after, done);
                Some((at, at + 1))
            }
            None => Some((at, at + 1)),
        };
    }
    if let Some(done) = run {
        push(&mut out, after, done);
    }
    out.into()
}

fn push(out: &mut Vec<u8>, after: &[u8], (from, to): (usize, usize)) {
    out.extend((from as u32).to_le_bytes());
    out.extend(((to - from) as u32).to_le_bytes());
    out.extend(&after[from..to]);
}

/// The runs of [`changes`], as offsets and bytes; ends where they are damaged.
pub fn runs(mut changes: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    std::iter::from_fn(move || {
        let (head, rest) = changes.split_at_checked(8)?;
        let number = |at: usize| u32::from_le_bytes([0, 1, 2, 3].map(|i| head[at + i])) as usize;
        let (run, rest) = rest.split_at_checked(number(4))?;
        changes = rest;
        Some((number(0), run))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_hold_what_changed() {
        let before = vec![0u8; 100];
        let mut after = before.clone();
        (after[3], after[5], after[60], after[99]) = (1, 2, 3, 4);
        let changes = changes(&before, &after);
        let found: Vec<_> = runs(&changes).collect();
        assert_eq!(found, [(3, &[1, 0, 2][..]), (60, &[3]), (99, &[4])]);
        assert_eq!(runs(&changes[..changes.len() - 1]).count(), 2);
        assert!(super::changes(&before, &before).is_empty());
    }
}
