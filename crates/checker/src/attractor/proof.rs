//! A1 to A7, of all parameters and the greatest ν: for smaller ones all of it holds as well (P9 of the
//! theorem's proof).

use super::{
    Fault, GoOn, Interval, claim,
    rates::{Rates, decay, growth as exponential},
    stop,
    text::{Certificate, Exponent, Setting},
};

/// What A5 to A7 are told by.
pub(super) struct Trap {
    pub rates: Rates,
    pub tau: Interval,
    depth: Interval,
    /// √ν.
    root: Interval,
    /// w.
    window: Interval,
    /// α and α′.
    pub bends: [Interval; 2],
    /// S and Z.
    pub speed: Interval,
    pub slip: Interval,
    /// σ and q.
    strength: Interval,
    height: Interval,
}

/// 2πn.
pub(super) fn periods(n: u64) -> Interval {
    (Interval::PI + Interval::PI) * Interval::integer(n)
}

impl Trap {
    /// A1 to A4, but for the wall.
    pub fn new(setting: &Setting) -> Result<Trap, Fault> {
        let [damping, stiffness, tau] =
            setting.ranges.map(|[lo, hi]| lo.enclosed::<96>().hull(hi.enclosed()));
        let rates = Rates::new(damping, stiffness)?;
        let Rates { slow, fast, apart } = rates;
        let (one, depth) = (Interval::ONE, setting.depth.enclosed::<96>());
        let [before, after] = setting.window.map(|end| end.enclosed::<96>());
        let bends = setting.bends.map(|bend| bend.enclosed::<96>());
        let (speed, slip) = (setting.speed.enclosed::<96>(), setting.slip.enclosed::<96>());
        let (window, root) = (before + after, depth.roots());
        let short = periods(1) - window;
        // D/(e^x − 1) with x = D(2π − w) falls as D grows.
        let left = decay(apart.least() * short);
        let least = (apart.least() * left).over(one - left);
        claim(least.is_up_to(slip), "the slip may be greater (A2)")?;
        let back = rates.least_reach(short).hull(rates.least_reach(periods(1) + window)).least();
        let share = fast.squared().over(apart);
        // (1 + τ)v.
        let whole = one.over(back);
        let early = bends[0] - share * exponential(fast * window) * depth * (slip + whole);
        claim(early.is_positive(), "the gap may not be convex before a contact (A3)")?;
        let most = bends[1] + slow.squared() * depth * (one + slip.over(apart));
        let lambda = decay(slow * periods(1));
        let bounce = tau.squared() * depth * whole.over(one + tau).squared();
        let fall = one - lambda * (one - bounce.over(early + early));
        claim((most * (fall + fall)).is_up_to(speed.squared()), "contacts may be faster (A3)")?;
        let late = bends[0] - share * (depth * slip + (one + tau) * root * speed);
        claim(late.is_positive(), "the gap may not be convex after a contact (A4)")?;
        let strength = tau * (bends[0] - share * depth * slip) + late;
        let steep = speed + root * slip;
        // The greater of two squares.
        let steep = [steep, slow * root].map(|x| x.squared().greatest());
        let height = one - steep[0].hull(steep[1]).greatest().over(bends[0] + bends[0]);
        Ok(Trap { rates, tau, depth, root, window, bends, speed, slip, strength, height })
    }

    /// A_n and B_n, from below.
    fn growths(&self, n: u64) -> [Interval; 2] {
        let [early, late] = [periods(n) - self.window, periods(n) + self.window];
        let reach = self.rates.least_reach(early).hull(self.rates.least_reach(late)).least();
        let by_speed = (self.strength * reach).over(self.root * self.speed);
        let way = ((Interval::ONE + self.tau) * self.speed + self.root * self.slip) * self.speed;
        let by_height = (self.strength * (self.height - self.rates.greatest_rest(early))).over(way);
        [by_speed.least(), by_height.least()]
    }

    /// A6.
    pub fn begins(&self, start: Interval) -> Result<(), Fault> {
        let Rates { slow, fast, apart } = self.rates;
        claim((self.depth * self.slip).is_up_to(start), "what starts may be less than what is trapped (A6)")?;
        let bend = self.bends[1] + slow.squared() * (self.depth + start.over(apart));
        let fastest = (self.depth * (bend + bend)).roots();
        let pull = fast.squared() * (start + (Interval::ONE + self.tau) * fastest).over(apart);
        claim(pull.is_below(self.bends[0]), "what starts may not be trapped (A6)")
    }

    /// Whether every return is after at most so many periods, for ν from a number on.
    fn returns(&self, last: u64, least: Interval) -> bool {
        let time = periods(last) - self.window;
        let kick = (Interval::ONE + self.tau) * self.speed.over(least.roots()) + self.slip;
        let slow = decay(self.rates.slow * time).over(self.rates.apart) * kick;
        (self.rates.greatest_rest(time) + slow).is_below(Interval::ONE)
    }
}

/// The greater of both.
fn greater([one, other]: [Interval; 2]) -> Interval {
    if one.is_below(other) { other } else { one }
}

/// Proves everything.
pub(super) fn run(certificate: &Certificate, go_on: GoOn) -> Result<(), Fault> {
    stop::holds(&certificate.setting, go_on)?;
    let trap = Trap::new(&certificate.setting)?;
    let (least, last) = (certificate.growth.enclosed::<96>(), certificate.last);
    for n in 1..=last {
        go_on()?;
        let both = trap.growths(n);
        let found = if n == last { both[1] } else { greater(both) };
        claim(
            least.is_up_to(found),
            format_args!(
                "growth may be less over {n} periods{} (A5)",
                if n == last { " or more" } else { "" }
            ),
        )?;
    }
    trap.begins(certificate.start.enclosed())?;
    let Some(Exponent { depth, rate, last }) = certificate.exponent else { return Ok(()) };
    claim(trap.returns(last, depth.enclosed()), "returns may be after more periods (A7)")?;
    let rate = rate.enclosed::<96>();
    for n in 1..=last {
        go_on()?;
        let found = greater(trap.growths(n));
        claim(
            exponential(rate * Interval::integer(n)).is_up_to(found),
            format_args!("the exponent may be less over {n} periods (A7)"),
        )?;
    }
    Ok(())
}

/// The least growth, in units of 2⁻⁴⁸.
pub(super) fn growth(certificate: &Certificate) -> Result<i128, Fault> {
    let trap = Trap::new(&certificate.setting)?;
    let last = certificate.last;
    let all = (1..=last).map(|n| {
        let both = trap.growths(n);
        if n == last { both[1] } else { greater(both) }
    });
    Ok(all.map(|found| found.in_units()[0] >> 48).min().unwrap_or(0))
}
