//! A1 to A4 and A6 at the greatest depth, and B1 to B3 cell by cell.

use super::{
    super::{Fault, GoOn, Interval, claim, proof::Trap, stop},
    returns::Returns,
    text::Certificate,
};

/// The cells as intervals, with their weights.
struct Cells {
    all: Vec<(Interval, Interval)>,
}

impl Cells {
    fn new(certificate: &Certificate) -> Cells {
        let mut start = Interval::ZERO;
        let all = certificate.cells.iter().map(|cell| {
            let end = cell.end.enclosed();
            (std::mem::replace(&mut start, end).hull(end), Interval::integer(cell.weight))
        });
        Cells { all: all.collect() }
    }

    /// The least weight of the cells that may hold one of these numbers.
    fn least(&self, speed: Interval) -> Interval {
        let near = self.all.iter().skip_while(|(cell, _)| cell.is_below(speed));
        let near = near.take_while(|(cell, _)| !speed.is_below(*cell)).map(|(_, weight)| *weight);
        near.reduce(|one, other| if other.is_below(one) { other } else { one }).unwrap_or(Interval::ZERO)
    }
}

/// Proves everything.
pub(super) fn run(certificate: &Certificate, go_on: GoOn) -> Result<(), Fault> {
    let setting = &certificate.setting;
    stop::holds(setting, go_on)?;
    let depth = certificate.least.enclosed::<96>().hull(setting.depth.enclosed());
    let returns = Returns::new(Trap::new(setting)?, depth, certificate.last);
    returns.begins(certificate.start.enclosed())?;
    let growth = certificate.growth.enclosed::<96>();
    let powers = Returns::powers(certificate.rate.enclosed(), certificate.last);
    let cells = Cells::new(certificate);
    for (i, (cell, weight)) in cells.all.iter().enumerate() {
        let place = || format!("cell {}", i + 1);
        let Some(mut contacts) = returns.contacts(*cell) else { continue };
        let mut n = 1;
        loop {
            go_on()?;
            let Some(power) = powers.get(n) else {
                let last = certificate.last;
                let why = format!("returns may be after more than {last} periods (B2)");
                return Err(Fault::False(why).at(place()));
            };
            if let Some(next) = returns.after(&contacts, n) {
                let lightest = cells.least(next.speed);
                let needed = |least: Interval| (least * *weight).over(lightest);
                let holds = [growth, *power].into_iter().all(|least| needed(least).is_up_to(next.growth));
                claim(holds, format_args!("growth may be less over {n} periods (B3)"))
                    .map_err(|fault| fault.at(place()))?;
            }
            match returns.clear(contacts, n) {
                Some(rest) => contacts = rest,
                None => break,
            }
            n += 1;
        }
    }
    Ok(())
}
