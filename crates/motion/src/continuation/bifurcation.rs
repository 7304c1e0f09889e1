//! What happens to a periodic orbit along its branch: one list, for labels, tasks and proofs alike.

use super::FollowedOrbit;

/// A bifurcation of codimension one, or another end of a branch as one of orbits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Bifurcation {
    /// The branch turns back in the parameter: two orbits meet, a multiplier is 1.
    SaddleNode,
    /// Another branch of the same pattern crosses (pitchfork, transcritical): a multiplier is 1.
    Crossing,
    /// A multiplier is −1: the branch of the doubled pattern is born.
    Flip,
    /// Two complex multipliers have modulus 1 (Neimark–Sacker).
    Torus,
    /// A minimum of the gap is zero: a new impact with zero velocity.
    Grazing,
    /// An impact's velocity is zero: the branch ends as an orbit of this pattern.
    Fade,
    /// Dry friction: where a velocity changes its sign, the force that sticking takes is the largest there
    /// is, and falls from one to the other side of it: beside it the motion sticks for a moment.
    CrossingSliding,
    /// Dry friction: a minimum of a velocity is zero: beside it the motion sticks, and slides on the same
    /// way.
    GrazingSliding,
    /// Dry friction: where it begins to stick, the force that this takes is the largest there is, and gets
    /// smaller: beside it the motion turns round before it sticks.
    SwitchingSliding,
    /// Dry friction: while it sticks, a maximum of the force that this takes is the largest there is: beside
    /// it the motion slides in between.
    AddingSliding,
    /// Dry friction: what happens along it is otherwise from here on, in another way than these.
    FrictionChange,
}

impl Bifurcation {
    /// All, in the order of a branch's monitors.
    pub const ALL: [Bifurcation; 11] = [
        Bifurcation::SaddleNode,
        Bifurcation::Crossing,
        Bifurcation::Flip,
        Bifurcation::Torus,
        Bifurcation::Grazing,
        Bifurcation::Fade,
        Bifurcation::CrossingSliding,
        Bifurcation::GrazingSliding,
        Bifurcation::SwitchingSliding,
        Bifurcation::AddingSliding,
        Bifurcation::FrictionChange,
    ];

    /// Those that are zeros of a monitor, in its order.
    pub const MONITORED: [Bifurcation; 6] = *Bifurcation::ALL.first_chunk().unwrap();

    /// Whether what friction does is otherwise beyond it.
    pub(crate) fn is_sliding(self) -> bool {
        self as usize > Bifurcation::Fade as usize
    }

    /// Its name in tables and labels.
    pub fn name(self) -> &'static str {
        match self {
            Bifurcation::SaddleNode => "saddle-node",
            Bifurcation::Crossing => "crossing",
            Bifurcation::Flip => "flip",
            Bifurcation::Torus => "neimark-sacker",
            Bifurcation::Grazing => "grazing",
            Bifurcation::Fade => "fade",
            Bifurcation::CrossingSliding => "crossing-sliding",
            Bifurcation::GrazingSliding => "grazing-sliding",
            Bifurcation::SwitchingSliding => "switching-sliding",
            Bifurcation::AddingSliding => "adding-sliding",
            Bifurcation::FrictionChange => "friction-change",
        }
    }

    /// What happens there, where its name is no word of the field's.
    pub fn meaning(self) -> Option<&'static str> {
        match self {
            Bifurcation::Crossing => Some("two branches cross"),
            Bifurcation::Fade => {
                Some("an impact has lost its speed: a grazing, seen from the orbit that has the impact")
            }
            Bifurcation::CrossingSliding => {
                Some("what turns round in dry friction begins to stick for a moment there, or ceases to")
            }
            Bifurcation::GrazingSliding => {
                Some("what slides begins to stick for a moment, and slides on the same way, or ceases to")
            }
            Bifurcation::SwitchingSliding => {
                Some("what begins to stick turns round first for a moment, or ceases to")
            }
            Bifurcation::AddingSliding => Some("what sticks slides for a moment in between, or ceases to"),
            Bifurcation::FrictionChange => Some("what sticks and slides changes in another way"),
            _ => None,
        }
    }

    /// The one with a name.
    pub fn named(name: &str) -> Option<Bifurcation> {
        Bifurcation::ALL.into_iter().find(|known| known.name() == name)
    }

    /// The one that a monitor's number means for orbits with so many impacts: after those in order, of which
    /// `Torus` is the first of [`FollowedOrbit::circles`], come the impacts' speeds, then the other circles.
    pub(super) fn of(monitor: usize, impacts: usize) -> Bifurcation {
        let fade = Bifurcation::Fade as usize;
        match monitor {
            _ if monitor < fade => Bifurcation::ALL[monitor],
            _ if monitor < fade + impacts => Bifurcation::Fade,
            _ => Bifurcation::Torus,
        }
    }

    /// Whether an orbit is at it: its multipliers are the bifurcation's, and no speed is zero where
    /// multipliers are asked for. A zero of a monitor that fails this is a pole of the multipliers seen from
    /// both sides.
    pub fn is_at(self, orbit: &impl FollowedOrbit) -> bool {
        orbit.is_at(self)
    }
}

/// A point of codimension two on a curve of bifurcations in two parameters.
///
/// With one degree of freedom and linear damping a curve of Neimark–Sacker points has no Chenciner points: Re
/// d is zero all along, see [`NormalForm`](super::NormalForm).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Degeneracy {
    /// On a curve of saddle-nodes: the coefficient a vanishes, three orbits meet.
    Cusp,
    /// On a curve of flips: the coefficient b vanishes, the flip turns from supercritical to subcritical.
    GeneralisedFlip,
    /// On a curve of Neimark–Sacker points: the coefficient Re d vanishes.
    Chenciner,
    /// Both multipliers are 1.
    Resonance1,
    /// Both multipliers are −1.
    Resonance2,
    /// One multiplier is 1 and another −1, which takes more than one degree of freedom.
    FoldFlip,
    /// One multiplier is 1 and two complex ones are on the unit circle, which takes more than one degree of
    /// freedom.
    FoldTorus,
    /// The same with one multiplier −1.
    FlipTorus,
    /// Four complex multipliers are on the unit circle.
    DoubleTorus,
    /// On a curve of pitchforks: the coefficient c vanishes, the pitchfork turns from supercritical to
    /// subcritical.
    DegeneratePitchfork,
    /// The multipliers are third roots of 1.
    Resonance3,
    /// The multipliers are ±i.
    Resonance4,
    /// On a curve of grazings: e = 0, the curve has the direction of the first parameter.
    NoDrift,
    /// On a curve of grazings: γ = 0.
    NoGamma,
    /// On a curve of grazings: u_2 = 0; from here curves of saddle-nodes and flips of the orbit of twice the
    /// period start.
    Resonant2,
    /// The same with u_3 = 0 and three times the period.
    Resonant3,
    /// The same with u_4 = 0, u_2 not.
    Resonant4,
    /// The same with u_5 = 0.
    Resonant5,
    /// The same with u_6 = 0, neither u_2 nor u_3.
    Resonant6,
}

impl Degeneracy {
    /// All, in the order of a curve's monitors.
    pub const ALL: [Degeneracy; 19] = [
        Degeneracy::Cusp,
        Degeneracy::GeneralisedFlip,
        Degeneracy::Chenciner,
        Degeneracy::Resonance1,
        Degeneracy::Resonance2,
        Degeneracy::FoldFlip,
        Degeneracy::FoldTorus,
        Degeneracy::FlipTorus,
        Degeneracy::DoubleTorus,
        Degeneracy::DegeneratePitchfork,
        Degeneracy::Resonance3,
        Degeneracy::Resonance4,
        Degeneracy::NoDrift,
        Degeneracy::NoGamma,
        Degeneracy::Resonant2,
        Degeneracy::Resonant3,
        Degeneracy::Resonant4,
        Degeneracy::Resonant5,
        Degeneracy::Resonant6,
    ];

    /// Its name in tables and labels.
    pub fn name(self) -> &'static str {
        match self {
            Degeneracy::Cusp => "cusp",
            Degeneracy::GeneralisedFlip => "generalised-flip",
            Degeneracy::Chenciner => "chenciner",
            Degeneracy::Resonance1 => "1:1-resonance",
            Degeneracy::Resonance2 => "1:2-resonance",
            Degeneracy::FoldFlip => "fold-flip",
            Degeneracy::FoldTorus => "fold-neimark-sacker",
            Degeneracy::FlipTorus => "flip-neimark-sacker",
            Degeneracy::DoubleTorus => "double-neimark-sacker",
            Degeneracy::DegeneratePitchfork => "degenerate-pitchfork",
            Degeneracy::Resonance3 => "1:3-resonance",
            Degeneracy::Resonance4 => "1:4-resonance",
            Degeneracy::NoDrift => "e-zero",
            Degeneracy::NoGamma => "gamma-zero",
            Degeneracy::Resonant2 => "resonant-grazing-2",
            Degeneracy::Resonant3 => "resonant-grazing-3",
            Degeneracy::Resonant4 => "resonant-grazing-4",
            Degeneracy::Resonant5 => "resonant-grazing-5",
            Degeneracy::Resonant6 => "resonant-grazing-6",
        }
    }
}

/// What happens at a point of a branch, or of a curve of bifurcations.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Singularity {
    /// A bifurcation; on a curve of bifurcations, a second one at the same point.
    Bifurcation(Bifurcation),
    /// A bifurcation of codimension two.
    Degeneracy(Degeneracy),
    /// A function of this name takes a value.
    Level(String),
}
