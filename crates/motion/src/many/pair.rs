//! Pairs of coordinates that move for themselves: their flow, and bounds of it.

/// A pair of coordinates that moves for itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pair {
    /// (η, η′) with η″ + damping η′ + stiffness η = 0.
    Mode { damping: f64, stiffness: f64 },
    /// Real and imaginary part of ζ with ζ′ = (rate + i turn) ζ.
    Spiral { rate: f64, turn: f64 },
    /// Two numbers that grow at these rates.
    Two([f64; 2]),
}

impl Pair {
    /// G with y′ = G y.
    pub(super) fn generator(&self) -> [[f64; 2]; 2] {
        match *self {
            Pair::Mode { damping, stiffness } => [[0.0, 1.0], [-stiffness, -damping]],
            Pair::Spiral { rate, turn } => [[rate, -turn], [turn, rate]],
            Pair::Two([a, b]) => [[a, 0.0], [0.0, b]],
        }
    }

    /// A bound of |f(s)| for 0 ≤ s ≤ `width`, f being g E(s) at one entry of a functional g on the pair, from
    /// f(0) and f′(0).
    ///
    /// f satisfies the pair's own equation f″ + c f′ + k f = 0. With γ ≥ 0 such that h = e^{−γs} f does not
    /// grow, |f| ≤ e^{γ·width} sup |h|, and h is one of
    ///
    /// - e^{−rs} (h₀ cos ωs + (h₀′ + r h₀)/ω sin ωs), r ≥ 0: at most √(h₀² + ((h₀′ + r h₀)/ω)²);
    /// - for real decay rates 0 ≤ a ≤ b: h₀ times a number in [0, 1], plus h₀′ (e^{−as} − e^{−bs})/(b − a),
    ///   which is at most h₀′/b and at most h₀′ s.
    ///
    /// The least of what applies is taken, and 10⁻¹² of it added for rounding.
    pub(super) fn supremum(&self, start: f64, slope: f64, width: f64) -> f64 {
        if let Pair::Two(rates) = *self {
            // Each entry moves for itself: which one it is does not matter for the bound.
            let growth = rates[0].max(rates[1]).max(0.0);
            return start.abs() * (growth * width).exp() * (1.0 + 1e-12);
        }
        let (c, k) = match *self {
            Pair::Mode { damping, stiffness } => (damping, stiffness),
            Pair::Spiral { rate, turn } => (-2.0 * rate, rate * rate + turn * turn),
            Pair::Two(_) => unreachable!("done above"),
        };
        let square = k - c * c / 4.0;
        let root = square.abs().sqrt();
        let slowest = if square > 0.0 { c / 2.0 } else { c / 2.0 - root };
        let growth = (-slowest).max(0.0);
        let (own, decay) = (slope - growth * start, c / 2.0 + growth);
        let straight = if square > 0.0 {
            // Also without ω, by |h′| of a decaying motion, where ω is small.
            f64::INFINITY
        } else {
            let fastest = decay + root;
            start.abs() + own.abs() * if fastest > 0.0 { width.min(1.0 / fastest) } else { width }
        };
        let round = if square > 0.0 { start.hypot((own + decay * start) / root) } else { f64::INFINITY };
        // Nearly critical: h = e^{−rs}(h₀ cos ωs + (h₀′ + r h₀) s sinc ωs).
        let critical =
            if square > 0.0 { start.abs() + (own + decay * start).abs() * width } else { f64::INFINITY };
        straight.min(round).min(critical) * (growth * width).exp() * (1.0 + 1e-12)
    }

    /// The largest modulus of an eigenvalue.
    pub(super) fn rate(&self) -> f64 {
        match *self {
            Pair::Mode { stiffness, damping } => stiffness.abs().sqrt().max(damping.abs()),
            Pair::Spiral { rate, turn } => rate.hypot(turn),
            Pair::Two([a, b]) => a.abs().max(b.abs()),
        }
    }

    /// E(t), but for modes, which have a flow of their own.
    pub(super) fn matrix(&self, t: f64) -> [[f64; 2]; 2] {
        match *self {
            Pair::Mode { .. } => unreachable!("modes move by their own flow"),
            Pair::Spiral { rate, turn } => {
                let ((sin, cos), decay) = ((turn * t).sin_cos(), (rate * t).exp());
                [[decay * cos, -decay * sin], [decay * sin, decay * cos]]
            }
            Pair::Two([a, b]) => [[(a * t).exp(), 0.0], [0.0, (b * t).exp()]],
        }
    }
}
