//! Sums, differences, products and quotients of enclosures for the ways of passing them: each is that of a
//! value and a reference, which stands beside its type.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Ball, FloatInterval};

macro_rules! operators {
    ($($type:ty: $($trait:ident $method:ident),*;)*) => {$(
        $(
            impl $trait for $type {
                type Output = $type;

                #[inline]
                fn $method(self, other: $type) -> $type {
                    $trait::$method(self, &other)
                }
            }

            impl $trait<$type> for &$type {
                type Output = $type;

                #[inline]
                fn $method(self, other: $type) -> $type {
                    $trait::$method(self.clone(), &other)
                }
            }

            impl $trait for &$type {
                type Output = $type;

                #[inline]
                fn $method(self, other: Self) -> $type {
                    $trait::$method(self.clone(), other)
                }
            }
        )*

        impl Neg for &$type {
            type Output = $type;

            #[inline]
            fn neg(self) -> $type {
                -self.clone()
            }
        }
    )*};
}

operators! {
    Ball: Add add, Sub sub, Mul mul, Div div;
    FloatInterval: Add add, Sub sub, Mul mul, Div div;
}
