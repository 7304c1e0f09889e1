//! The multipliers of an orbit: the eigenvalues of its 2 × 2 monodromy matrix.

/// The two multipliers, by their sum and product.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Multipliers {
    /// λ₁ + λ₂.
    pub trace: f64,
    /// λ₁λ₂.
    pub determinant: f64,
}

impl Multipliers {
    /// λ₁ and λ₂ as (real, imaginary) parts, the larger modulus or the positive imaginary part first.
    pub fn values(&self) -> [(f64, f64); 2] {
        let half = self.trace / 2.0;
        let discriminant = half * half - self.determinant;
        if discriminant < 0.0 {
            let imaginary = (-discriminant).sqrt();
            return [(half, imaginary), (half, -imaginary)];
        }
        // The larger without cancellation, the smaller from the product.
        let larger = half + discriminant.sqrt().copysign(half);
        let smaller = if larger == 0.0 { 0.0 } else { self.determinant / larger };
        [(larger, 0.0), (smaller, 0.0)]
    }

    /// Whether both are inside the unit circle (Jury): |tr| < 1 + det and det < 1.
    pub fn is_stable(&self) -> bool {
        self.fold().min(self.flip()) > 0.0 && self.determinant < 1.0
    }

    /// (1 − λ₁)(1 − λ₂): 0 where a multiplier is 1, at a saddle-node.
    pub fn fold(&self) -> f64 {
        1.0 - self.trace + self.determinant
    }

    /// (1 + λ₁)(1 + λ₂): 0 where a multiplier is −1, at a flip.
    pub fn flip(&self) -> f64 {
        1.0 + self.trace + self.determinant
    }
}
