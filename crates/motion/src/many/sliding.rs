//! What it is called when the order changes in which an orbit slides and sticks.
//!
//! The order at a row is a circle of forwards, backwards and stuck. Where one orbit becomes another the names
//! are those of di Bernardo, Budd, Champneys and Kowalczyk, by the one condition that then holds, s being
//! stuck and a ≠ b ways of sliding:
//!
//! | from | to | name | what is 0 |
//! | --- | --- | --- | --- |
//! | a b | a s b | crossing–sliding | what the surface could hold more, where v = 0; it falls from there |
//! | a | a s a | grazing–sliding | the least of \|v\| |
//! | a s | a b s | switching–sliding | what the surface could hold more, where v = 0; it grows from there |
//! | s | s a s | adding–sliding | the least of what the surface could hold more, while it sticks |
//!
//! A symmetric orbit does one of these at several places at once.

use std::collections::BTreeSet;

use super::Grip;
use crate::continuation::Bifurcation;

/// Orders longer than this are not told apart, and of more than so many in between none is looked for.
const LONGEST: usize = 24;
const MOST: usize = 10_000;

/// Whether two circles are the same.
pub(super) fn same(a: &[Grip], b: &[Grip]) -> bool {
    let n = a.len();
    n == b.len() && (n == 0 || (0..n).any(|turn| (0..n).all(|i| a[i] == b[(i + turn) % n])))
}

/// What lies between orbits with these orders at their rows.
pub(super) fn between(a: &[Vec<Grip>], b: &[Vec<Grip>]) -> Bifurcation {
    let changed: Vec<(&Vec<Grip>, &Vec<Grip>)> = a.iter().zip(b).filter(|(a, b)| !same(a, b)).collect();
    let [(a, b)] = changed[..] else { return Bifurcation::FrictionChange };
    let (less, more) = if a.len() < b.len() { (a, b) } else { (b, a) };
    let all = [
        Bifurcation::CrossingSliding,
        Bifurcation::GrazingSliding,
        Bifurcation::SwitchingSliding,
        Bifurcation::AddingSliding,
    ];
    let found = all.into_iter().find(|kind| more.len() <= LONGEST && undone(more, less, *kind));
    found.unwrap_or(Bifurcation::FrictionChange)
}

/// Whether a circle becomes another where some of what one kind adds is taken out.
fn undone(more: &[Grip], less: &[Grip], kind: Bifurcation) -> bool {
    // There are many ways to the same circle, each of which is turned as its least.
    let turned = |circle: &[Grip], i: usize| [&circle[i..], &circle[..i]].concat();
    let least = |circle: &[Grip]| (0..circle.len()).map(|i| turned(circle, i)).min().unwrap_or_default();
    let mut known = BTreeSet::from([least(more)]);
    let mut open = vec![least(more)];
    while let Some(circle) = open.pop() {
        if circle.len() <= less.len() {
            if same(&circle, less) {
                return true;
            }
            continue;
        }
        let shorter = (0..circle.len()).filter_map(|i| removed(&turned(&circle, i), kind));
        let new: Vec<Vec<Grip>> =
            shorter.map(|circle| least(&circle)).filter(|one| known.insert(one.clone())).collect();
        open.extend(new);
        if known.len() > MOST {
            return false;
        }
    }
    false
}

/// The circle without what a kind adds after its first part, if that is there.
fn removed(circle: &[Grip], kind: Bifurcation) -> Option<Vec<Grip>> {
    let (a, rest) = circle.split_first()?;
    let stuck = |grip: &Grip| *grip == Grip::Stuck;
    // After the last comes the first.
    let at = |i: usize| circle.get(i % circle.len());
    let (x, next) = (rest.first()?, at(2)?);
    let found = match kind {
        Bifurcation::CrossingSliding => stuck(x) && !stuck(a) && !stuck(next) && a != next,
        Bifurcation::GrazingSliding => stuck(x) && !stuck(a) && a == next,
        Bifurcation::SwitchingSliding => !stuck(a) && !stuck(x) && stuck(next),
        Bifurcation::AddingSliding => stuck(a) && !stuck(x) && stuck(next),
        _ => false,
    };
    if !found {
        return None;
    }
    // One part goes; where those beside it are one then, two.
    let gone = if a == next { 2 } else { 1 };
    let left: Vec<Grip> = [a].into_iter().chain(circle.iter().skip(1 + gone)).copied().collect();
    Some(if circle.len() == 2 { vec![*a] } else { left })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(word: &str) -> Vec<Grip> {
        let one = |letter| match letter {
            'f' => Grip::Forward,
            'b' => Grip::Backward,
            _ => Grip::Stuck,
        };
        word.chars().map(one).collect()
    }

    #[test]
    fn changes_have_the_name_of_what_they_add() {
        for (a, b, name) in [
            ("fb", "fsb", "crossing-sliding"),
            ("fb", "fsbs", "crossing-sliding"),
            ("f", "fs", "grazing-sliding"),
            ("fsb", "sbfsf", "grazing-sliding"),
            ("fs", "bsf", "switching-sliding"),
            ("sfsb", "sbfsfb", "switching-sliding"),
            ("s", "sf", "adding-sliding"),
            ("fs", "sfsb", "adding-sliding"),
            ("fb", "sbsfb", "friction-change"),
            ("fb", "fbfb", "friction-change"),
        ] {
            let (a, b) = (vec![circle("s"), circle(a)], vec![circle("s"), circle(b)]);
            assert!(same(&a[1], &a[1]) && !same(&a[1], &b[1]));
            assert_eq!(between(&a, &b).name(), name, "{a:?} {b:?}");
            assert_eq!(between(&b, &a).name(), name);
        }
        // As many ways as there are orders of taking parts out.
        let long = [vec![circle(&"fsbs".repeat(6))], vec![circle("fsf")]];
        assert_eq!(between(&long[0], &long[1]).name(), "friction-change");
        assert_eq!(between(&long[0], &[circle(&"fb".repeat(6))]).name(), "crossing-sliding");
        let both = [vec![circle("s"), circle("fsb")], vec![circle("sf"), circle("fb")]];
        assert_eq!(between(&both[0], &both[1]).name(), "friction-change");
    }
}
