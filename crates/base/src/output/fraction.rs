//! Fractions as text where results are written for machines.

use num_rational::Ratio;
use serde::Serializer;

/// `"p/q"`, an integer too: `"0/1"`.
pub fn serialize_fraction<S: Serializer>(x: &Ratio<u64>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(&format_args!("{}/{}", x.numer(), x.denom()))
}
