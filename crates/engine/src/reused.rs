//! Lists that are filled again and again.

/// A list that keeps its elements when it is emptied: the next ones are written
/// where they stay, and what they do not set is what was there before.
#[derive(Debug)]
pub(crate) struct Reused<T> {
    all: Vec<T>,
    used: usize,
}

impl<T> Default for Reused<T> {
    fn default() -> Reused<T> {
        Reused { all: Vec::new(), used: 0 }
    }
}

impl<T: Default> Reused<T> {
    /// One more element, to be written.
    #[inline(always)]
    pub fn add(&mut self) -> &mut T {
        if self.used == self.all.len() {
            self.grow();
        }
        self.used += 1;
        &mut self.all[self.used - 1]
    }

    #[cold]
    fn grow(&mut self) {
        let more = self.all.len().max(16);
        self.all.resize_with(self.all.len() + more, T::default);
    }
}

impl<T> Reused<T> {
    /// How many elements are in use.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.used
    }

    /// An element in use.
    #[inline(always)]
    pub fn get(&self, index: usize) -> Option<&T> {
        self.all[..self.used].get(index)
    }

    /// The last element in use.
    #[inline(always)]
    pub fn last(&self) -> Option<&T> {
        self.all[..self.used].last()
    }

    /// The same, to be written.
    #[inline(always)]
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.all[..self.used].last_mut()
    }

    /// What becomes the element after so many others, where it is there already.
    #[inline(always)]
    pub fn ahead(&mut self, others: usize) -> Option<&mut T> {
        self.all.get_mut(self.used + others)
    }

    /// Forgets all elements, and keeps the memory.
    pub fn clear(&mut self) {
        self.used = 0;
    }
}

impl<T> core::ops::Index<u32> for Reused<T> {
    type Output = T;

    /// An element in use; of others nothing is known.
    #[inline(always)]
    fn index(&self, index: u32) -> &T {
        &self.all[index as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_are_written_where_they_stay() {
        let mut list = Reused::default();
        for i in 0..100 {
            *list.add() = i;
        }
        assert_eq!((list.len(), list[99], list.last()), (100, 99, Some(&99)));
        list.clear();
        assert_eq!((list.len(), list.get(0), list.last()), (0, None, None));
        assert_eq!((*list.add(), list.len()), (0, 1));
        assert_eq!(list.ahead(2).copied(), Some(3));
        *list.add() = 7;
        assert_eq!((list[0], list[1], list.last_mut().copied()), (0, 7, Some(7)));
        assert_eq!(list.get(2), None);
    }
}
