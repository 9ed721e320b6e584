//! Things by number. A number names what was put in until it is taken out; then
//! it names nothing for a long time.

/// Bits of a number that say the place; the others count its uses.
const PLACE_BITS: u32 = 14;
const MAX_PLACES: usize = 1 << PLACE_BITS;
const MAX_USES: u32 = 1 << (24 - PLACE_BITS);

#[derive(Debug)]
struct Slot<T> {
    uses: u32,
    value: Option<T>,
}

/// Up to 16384 things.
#[derive(Debug)]
pub(crate) struct Slots<T> {
    slots: Vec<Slot<T>>,
    free: Vec<usize>,
}

impl<T> Default for Slots<T> {
    fn default() -> Slots<T> {
        Slots { slots: Vec::new(), free: Vec::new() }
    }
}

impl<T> Slots<T> {
    /// Puts something in; its number, or `None` where there is no place.
    pub fn insert(&mut self, value: T) -> Option<u32> {
        let place = match self.free.pop() {
            Some(place) => place,
            None if self.slots.len() < MAX_PLACES => {
                self.slots.push(Slot { uses: 0, value: None });
                self.slots.len() - 1
            }
            None => return None,
        };
        let slot = &mut self.slots[place];
        slot.value = Some(value);
        Some(slot.uses << PLACE_BITS | place as u32)
    }

    fn slot(&self, number: u32) -> Option<&Slot<T>> {
        let slot = self.slots.get(number as usize & (MAX_PLACES - 1))?;
        (slot.uses == number >> PLACE_BITS).then_some(slot)
    }

    /// What has this number.
    pub fn get(&self, number: u32) -> Option<&T> {
        self.slot(number)?.value.as_ref()
    }

    /// What has this number, to be changed.
    #[inline]
    pub fn get_mut(&mut self, number: u32) -> Option<&mut T> {
        let slot = self.slots.get_mut(number as usize & (MAX_PLACES - 1))?;
        if slot.uses == number >> PLACE_BITS { slot.value.as_mut() } else { None }
    }

    /// Takes it out.
    pub fn remove(&mut self, number: u32) -> Option<T> {
        self.slot(number)?;
        let place = number as usize & (MAX_PLACES - 1);
        let slot = &mut self.slots[place];
        let value = slot.value.take()?;
        slot.uses = (slot.uses + 1) % MAX_USES;
        self.free.push(place);
        Some(value)
    }

    /// Takes out all that `which` says.
    pub fn remove_if(&mut self, which: impl Fn(&T) -> bool) {
        for place in 0..self.slots.len() {
            let slot = &self.slots[place];
            if slot.value.as_ref().is_some_and(&which) {
                let number = slot.uses << PLACE_BITS | place as u32;
                self.remove(number);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn old_numbers_name_nothing() {
        let mut slots = Slots::default();
        let (a, b) = (slots.insert('a').unwrap(), slots.insert('b').unwrap());
        assert_eq!((slots.get(a), slots.get(b)), (Some(&'a'), Some(&'b')));
        assert_eq!(slots.remove(a), Some('a'));
        assert_eq!(slots.remove(a), None);
        let c = slots.insert('c').unwrap();
        assert_ne!(a, c);
        assert_eq!(slots.get(a), None);
        assert_eq!(slots.get_mut(c), Some(&mut 'c'));
        slots.remove_if(|value| *value == 'b');
        assert_eq!((slots.get(b), slots.get(c)), (None, Some(&'c')));
    }

    #[test]
    fn there_is_an_end() {
        let mut slots = Slots::default();
        assert!((0..MAX_PLACES).all(|_| slots.insert(()).is_some()));
        assert_eq!(slots.insert(()), None);
    }
}
