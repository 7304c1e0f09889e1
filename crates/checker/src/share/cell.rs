//! What certainly holds at all points of a part of the box.
//!
//! Enclosed are c = a₁/√a₂ and ρ = √a₂, and of machines γ. With t = 2πw the eigenvalues of tA are t(−z ±
//! √(z²−1)), so that ρ = exp(−zt); below z = 1, with κ = √(1−z²), c = 2 cos κt and γ has the sign of sin
//! κt, and above it, with κ = √(z²−1), c = e^{κt} + e^{−κt} and γ > 0. A part that has z = 1 in it, or lies
//! so near that rounding puts it there, is not decided. Signs of N are found on the rectangle of a₁ = cρ
//! and a₂ = ρ². That of u_n is the one at (c, 1), since u_n = ρ^{n−1} times its value there. So it is asked
//! for: of a damped machine u_n is tiny, and what encloses it at (a₁, a₂) is not.
//!
//! Besides, where λ = ρ e^{iθ} is complex and θ is known, N_{n,k} = ρ^{k−1} F/sin θ with F = ρ^{n−k} sin nθ
//! − sin kθ − ρⁿ sin (n−k)θ (62), which intervals enclose, too: less closely where n is large, more where ρ
//! is small.
//!
//! *Regions.* Region 3 is |c| < 2. Machines with z > 1 have eigenvalues in (0, 1), that is region 2.
//!
//! *A period.* With N = u_n b_{n,k} of a certain sign and u_n of one, b has a sign. A period does not occur
//! either where one N_{n,k} is > 0 and another is < 0, whatever u_n is: then b has both signs, or u_n = 0.
//!
//! *No chaos.* Let L be the letter that two periods with orbits of one impact have (U if the signs of eµ
//! and γ are the same, else D). By the word theorem (W1 to W6 of `proofs/words.md`):
//!
//! - eµ < 0: in region 1 only period 1 occurs, with U; elsewhere all letters are D, and if a₁ = u_2 ≤ 0
//!   only 1 occurs. So there is no chaos for γ < 0, nor for γ > 0 in region 1 or where u_2 < 0;
//! - eµ > 0: in region 1 all letters are U, in region 5 all are D, in region 2 only 1 occurs;
//! - eµ > 0 in region 3, that is s = arg λ/2π between 0 and ½: a second period with the letter L occurs iff
//!   n does, the first one that may: n = ⌊1/s⌋ + 1 for D, with N_{n,1} > 0; for U, with s < ¼, n = K + 1, K
//!   the least with 2Ks > 1, with N_{n,K} < 0; for U, with s > ¼, the least n = 2m + 1 with m/n > s, with
//!   N_{n,2} < 0. No chaos is the other strict sign.
//!
//! *Which n.* u_j has the sign of sin 2πjs. Let j run from 1, by steps of 1, while u_j > 0. As 2s < 1 no
//! step passes over 1 < 2js < 2, where u_j < 0: the first such j is K. If s > ¼ let j run from 1 by steps
//! of 2: with s = ½ − t it is sin 2πjt, 4t < 1, and the first j with u_j < 0 is the least odd one with 1 <
//! 2jt, which is m/j > s for j = 2m + 1. From K on u_j ≤ 0 while js ≤ 1, and the first j with u_j > 0 after
//! is ⌊1/s⌋ + 1. So n is where a sign changes along a walk. On a part a sign may be open where it changes;
//! if at one place of the walk it is open, at all before it has the one sign and at the next the other,
//! then the change is at the one or the next place at every point: from the last place before, two steps
//! take 2js, or 2jt, on by less than 2. What is claimed must hold for both.

use std::cmp::Ordering;

use super::{
    MOST, Part,
    text::{Area, Claim, Coordinates},
};
use crate::{
    decimal::Fraction,
    touch::{
        Interval,
        flow::{Flow, circle},
    },
    word::{
        number::Rational,
        set::{Place, Signs},
    },
};

/// The bits of signs: 16 more than intervals have.
const BITS: usize = 64;

/// A part of the box, or what is known of it.
pub(super) struct Cell {
    /// Of N.
    signs: Signs,
    /// Of u, on c and 1.
    turns: Signs,
    /// The paper's region that all of it lies in.
    region: Option<u64>,
    /// Of machines, whether γ > 0.
    gamma: Option<bool>,
    /// θ, with the sign of its sine.
    angle: Option<(Interval, bool)>,
    /// sin jθ and ρʲ, as far as they were asked for.
    waves: Vec<[Interval; 2]>,
    rho: Interval,
}

/// e^x.
fn exp(x: Interval) -> Interval {
    // A² = A, so that this is 1 + (e^x − 1)A.
    let e = Flow { damping: Interval::MINUS_ONE, stiffness: Interval::ZERO }.exp(x);
    e.a + e.b
}

/// What is enclosed of a machine.
struct Image {
    c: Interval,
    rho: Interval,
    gamma: Option<bool>,
    /// θ, a multiple of 2π off, with the sign of its sine.
    angle: Option<(Interval, bool)>,
    /// A region that is known beforehand.
    region: Option<u64>,
}

fn machine(w: Interval, z: Interval) -> Option<Image> {
    let t = (Interval::PI + Interval::PI) * w;
    // z ≥ 0: rounding may put it below.
    let rho = exp(-(z * t)).within_unit();
    let under = Interval::ONE - z.squared();
    if under.is_positive() {
        let angle = under.roots() * t;
        let (cos, sin) = circle(angle);
        let gamma = if sin.is_positive() { Some(true) } else { (-sin).is_positive().then_some(false) };
        let angle = gamma.map(|gamma| (angle, gamma));
        return Some(Image { c: cos + cos, rho, gamma, angle, region: None });
    }
    if !(-under).is_positive() {
        return None;
    }
    let growth = exp((-under).roots() * t);
    let c = growth + Interval::ONE.over(growth);
    Some(Image { c, rho, gamma: Some(true), angle: None, region: Some(2) })
}

/// The points with a₁ and a₂ in these intervals.
fn rectangle(a1: Interval, a2: Interval) -> Place {
    let [[a, b], [c, d]] = [a1, a2].map(|x| x.in_units().map(|units| Rational::binary(units, 48)));
    Place::Box([a, b, c, d])
}

impl Cell {
    /// None where its a₁ and a₂ are not known well enough.
    pub fn of(area: &Area, part: &Part) -> Option<Cell> {
        let [x, y] = [0, 1].map(|i| {
            let [lo, hi] = area.ends[i].map(Fraction::enclosed);
            // Both ends are off by less than a unit.
            lo.hull(hi).part(part.index[i], 1 << part.halvings[i]).outwards()
        });
        let free = |c, rho, angle| Image { c, rho, gamma: None, angle, region: None };
        let (image, place) = match area.coordinates {
            Coordinates::Plane => {
                let (a2, rho) = (y.within_unit(), y.roots());
                (free(x.over(rho), rho, None), rectangle(x, a2))
            }
            coordinates => {
                let image = match coordinates {
                    Coordinates::Machine => machine(x, y)?,
                    _ => {
                        let angle = (Interval::PI + Interval::PI) * y;
                        let cos = circle(angle).0;
                        free(cos + cos, x.within_unit(), Some((angle, true)))
                    }
                };
                let place = rectangle(image.c * image.rho, image.rho.squared());
                (image, place)
            }
        };
        let turns = rectangle(image.c, Interval::ONE);
        let complex = turns.region().filter(|&region| region == 3);
        let region = image.region.or(complex).or_else(|| place.region());
        Some(Cell {
            signs: Signs::new(place, BITS).ok()?,
            turns: Signs::new(turns, BITS).ok()?,
            region,
            gamma: image.gamma,
            angle: image.angle,
            waves: Vec::new(),
            rho: image.rho,
        })
    }

    /// Whether the claim certainly holds at all points, or at none; `left` is how many signs may be asked
    /// for.
    pub fn holds(&mut self, claim: &Claim, left: &mut u64) -> Result<Option<bool>, String> {
        match claim {
            Claim::Period { positive, n } => self.occurs(*n, *positive, left),
            Claim::Word { positive, letters } => self.is_word(*positive, letters, left),
            Claim::Chaos { positive, gamma } => match gamma.or(self.gamma) {
                Some(gamma) => self.is_chaotic(*positive, gamma, left),
                None => Ok(None),
            },
        }
    }

    /// The sign of u_n.
    fn u(&mut self, n: usize) -> Option<Ordering> {
        self.turns.reach(n);
        self.turns.u(n)
    }

    /// The sign of N_{n,k}, `signs` having been made known that far.
    fn numerator(&mut self, n: usize, k: usize) -> Option<Ordering> {
        let found = self.signs.numerator(n, k);
        let (None, Some((angle, positive))) = (found, self.angle) else { return found };
        for j in self.waves.len()..=n {
            let power = self.waves.last().map_or(Interval::ONE, |[_, power]| *power * self.rho);
            self.waves.push([circle(Interval::integer(j as u64) * angle).1, power]);
        }
        let [[of_n, whole], [of_k, _], [of_rest, rest]] = [n, k, n - k].map(|j| self.waves[j]);
        let wave = rest * of_n - of_k - whole * of_rest;
        let wave = if positive { wave } else { -wave };
        match (wave.is_positive(), (-wave).is_positive()) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    }

    /// Whether period n occurs.
    fn occurs(&mut self, n: u64, positive: bool, left: &mut u64) -> Result<Option<bool>, String> {
        *left = left.checked_sub(2 * n).ok_or("the check would ask for more than 10^7 signs")?;
        let n = n as usize;
        self.signs.reach(n);
        let found: Vec<_> = (1..n).map(|k| self.numerator(n, k)).collect();
        let is_there = |sign: Ordering| found.contains(&Some(sign));
        let wanted = self.u(n).map(|u| if positive { u } else { u.reverse() });
        Ok(match wanted {
            Some(wanted) if is_there(wanted.reverse()) => Some(false),
            Some(wanted) => found.iter().all(|sign| *sign == Some(wanted)).then_some(true),
            None => (is_there(Ordering::Less) && is_there(Ordering::Greater)).then_some(false),
        })
    }

    /// Whether the letter of period n, which occurs, is U: c_n has the sign of N_{2n,n}.
    fn is_upper(&mut self, n: u64) -> Option<bool> {
        let n = n as usize;
        self.signs.reach(2 * n);
        self.numerator(2 * n, n).map(|sign| sign == Ordering::Greater)
    }

    fn is_word(
        &mut self,
        positive: bool,
        letters: &[Option<bool>],
        left: &mut u64,
    ) -> Result<Option<bool>, String> {
        let mut certain = true;
        for (n, listed) in (1..).zip(letters) {
            let found = match self.occurs(n, positive, left)? {
                Some(true) if listed.is_some() => self.is_upper(n).map(Some),
                Some(true) => return Ok(Some(false)),
                Some(false) => Some(None),
                None => None,
            };
            match found {
                Some(found) if found != *listed => return Ok(Some(false)),
                Some(_) => {}
                None => certain = false,
            }
        }
        Ok(certain.then_some(true))
    }

    fn is_chaotic(&mut self, positive: bool, gamma: bool, left: &mut u64) -> Result<Option<bool>, String> {
        let upper = positive == gamma;
        *left = left.checked_sub(2 * MOST).ok_or("the check would ask for more than 10^7 signs")?;
        self.signs.reach(MOST as usize + 2);
        let u_2 = self.u(2);
        let none = match (positive, self.region) {
            (false, region) => !gamma || region == Some(1) || u_2 == Some(Ordering::Less),
            (true, Some(1)) => !upper,
            (true, Some(2)) => true,
            (true, Some(3)) => self.has_no_second(upper, u_2),
            (true, Some(5)) => upper,
            _ => false,
        };
        if none {
            return Ok(Some(false));
        }
        let mut found = 0;
        for n in 1..=MOST {
            if self.occurs(n, positive, left)? == Some(true) && self.is_upper(n) == Some(upper) {
                found += 1;
                if found == 2 {
                    return Ok(Some(true));
                }
            }
        }
        Ok(None)
    }

    /// In region 3, eµ > 0: whether no second period with this letter occurs.
    fn has_no_second(&mut self, upper: bool, u_2: Option<Ordering>) -> bool {
        let first = self.change(1, 1, Ordering::Greater);
        let pairs: Option<Vec<_>> = match (upper, u_2) {
            (true, Some(Ordering::Less)) => {
                let odd = self.change(1, 2, Ordering::Greater);
                odd.map(|all| all.into_iter().map(|n| (n, 2)).collect())
            }
            (true, Some(_)) => first.map(|all| all.into_iter().map(|k| (k + 1, k)).collect()),
            (true, None) => None,
            // From the last place that K may be at, where u < 0 at every point.
            (false, _) => {
                let second = first.and_then(|all| self.change(all.into_iter().max()?, 1, Ordering::Less));
                second.map(|all| all.into_iter().map(|n| (n, 1)).collect())
            }
        };
        let sign = if upper { Ordering::Greater } else { Ordering::Less };
        pairs.is_some_and(|all| all.into_iter().all(|(n, k)| self.numerator(n, k) == Some(sign)))
    }

    /// Where u may cease to have a sign, on a walk from `start` in steps: one place, or two.
    fn change(&mut self, start: usize, step: usize, sign: Ordering) -> Option<Vec<usize>> {
        let last = MOST as usize;
        let change = (start..=last).step_by(step).find(|&j| self.u(j) != Some(sign))?;
        let next = change + step;
        match self.u(change) {
            Some(_) => Some(vec![change]),
            None => (next <= last && self.u(next) == Some(sign.reverse())).then(|| vec![change, next]),
        }
    }
}
