//! The sign of the eigenvalue that tends to infinity at the bifurcation (section 3.6 of the paper).

use super::Case;
use crate::local::Region;

/// The sign, −1 or 1, of Λ ≈ K² γ² u_n² / (2 eµ (λ₁ⁿ − 1)(λ₂ⁿ − 1)) (61) for an orbit of period `n` that
/// exists in `case`.
///
/// sign(eµ) in regions 2, 3 and 4, −sign(eµ) in region 1, (−1)^{n+1} sign(eµ) in region 5 and on its edge.
pub fn large_eigenvalue_sign(region: Region, n: u64, case: Case) -> i8 {
    match region {
        Region::Two | Region::Three | Region::Four => case.sign_emu(),
        Region::One => -case.sign_emu(),
        // An orbit on the line |a₁| = a₂ + 1 exists only at its left part, for odd n, which has the signs of
        // region 5.
        Region::Five | Region::Line if n % 2 == 1 => case.sign_emu(),
        Region::Five | Region::Line => -case.sign_emu(),
    }
}
