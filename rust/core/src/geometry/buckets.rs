//! Values in numbered buckets, bucket by bucket in memory.

use std::ops::Range;

/// Values by the number of their bucket; those of one bucket stay in the order in which they came.
#[derive(Debug, Clone)]
pub struct Buckets<T> {
    /// Where each bucket begins among the values, and where the last one ends.
    begins: Vec<usize>,
    values: Vec<T>,
}

/// What puts values into buckets: once to count them, and once more for good.
#[derive(Debug)]
pub struct Sorter<T> {
    /// How many values each bucket has but for the first entry, then where its next one goes.
    next: Vec<usize>,
    /// None while they are counted.
    values: Option<Vec<T>>,
}

impl<T> Sorter<T> {
    /// Puts a value into a bucket.
    #[inline]
    pub fn put(&mut self, bucket: usize, value: T) {
        match &mut self.values {
            None => self.next[bucket + 1] += 1,
            Some(values) => {
                values[self.next[bucket]] = value;
                self.next[bucket] += 1;
            }
        }
    }
}

impl<T> Default for Buckets<T> {
    fn default() -> Self {
        Self { begins: vec![0], values: Vec::new() }
    }
}

impl<T: Clone + Default> Buckets<T> {
    /// Sorts into `count` buckets what `fill` puts there; it is asked twice, and does the same both
    /// times (counting sort).
    #[must_use]
    pub fn new(count: usize, fill: impl Fn(&mut Sorter<T>)) -> Self {
        let mut sorter = Sorter { next: vec![0; count + 1], values: None };
        fill(&mut sorter);
        for bucket in 0..count {
            sorter.next[bucket + 1] += sorter.next[bucket];
        }
        let begins = sorter.next.clone();
        sorter.values = Some(vec![T::default(); begins[count]]);
        fill(&mut sorter);
        Self { begins, values: sorter.values.unwrap_or_default() }
    }
}

impl<T> Buckets<T> {
    /// The values of a bucket.
    #[must_use]
    #[inline]
    pub fn of(&self, bucket: usize) -> &[T] {
        &self.values[self.range(bucket)]
    }

    /// The values of some buckets that follow one another.
    #[must_use]
    #[inline]
    pub fn across(&self, buckets: Range<usize>) -> &[T] {
        &self.values[self.begins[buckets.start]..self.begins[buckets.end]]
    }

    /// The values of each bucket, to be changed.
    pub fn each_mut(&mut self) -> impl Iterator<Item = &mut [T]> {
        let mut rest = self.values.as_mut_slice();
        self.begins.windows(2).map(move |ends| {
            let own;
            (own, rest) = std::mem::take(&mut rest).split_at_mut(ends[1] - ends[0]);
            own
        })
    }

    /// Where the values of a bucket lie among all.
    #[must_use]
    #[inline]
    pub fn range(&self, bucket: usize) -> Range<usize> {
        self.begins[bucket]..self.begins[bucket + 1]
    }

    /// All values, bucket by bucket.
    #[must_use]
    #[inline]
    pub fn values(&self) -> &[T] {
        &self.values
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn each_bucket_has_its_own_in_their_order(
            put in prop::collection::vec(0..7_usize, 0..60),
        ) {
            let mut buckets = Buckets::new(7, |sorter| {
                put.iter().enumerate().for_each(|(value, &bucket)| sorter.put(bucket, value));
            });
            let own = |bucket| (0..put.len()).filter(|&i| put[i] == bucket).collect::<Vec<_>>();
            for bucket in 0..7 {
                prop_assert_eq!(buckets.of(bucket), own(bucket));
                prop_assert_eq!(&buckets.values()[buckets.range(bucket)], own(bucket));
            }
            prop_assert_eq!(buckets.across(2..5), [own(2), own(3), own(4)].concat());
            prop_assert_eq!(buckets.across(6..6), Vec::<usize>::new());
            for (bucket, values) in buckets.each_mut().enumerate() {
                prop_assert_eq!(&*values, own(bucket));
                values.fill(bucket);
            }
            prop_assert!(buckets.values().is_sorted());
        }
    }

    #[test]
    fn none_hold_nothing() {
        assert!(Buckets::<u8>::default().values().is_empty());
        assert!(Buckets::<u8>::new(0, |_| ()).across(0..0).is_empty());
    }
}
