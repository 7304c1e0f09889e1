//! A plain search by bisection, which asks the checker itself: covers of a few small n.

use super::{
    expansion::{Cell, Patch},
    *,
};

/// The trees of one strip.
fn trees(n: u64, strip: &Strip, rows: &[[i64; 2]], leaves: &mut u64) -> String {
    let form = if strip.outermost { Form::Quotient } else { Form::Sine };
    let mut text = String::new();
    for &r in rows {
        let mut pending = vec![Cell { r, s: strip.units }];
        while let Some(cell) = pending.pop() {
            let proved = |leaf: &Leaf| strip.allows(leaf).is_ok() && leaf.prove(n, &cell, form).is_ok();
            if let Some(leaf) =
                candidates(n, strip, &cell, form, rows.last().unwrap()[1]).into_iter().find(proved)
            {
                text += &leaf.to_string();
                *leaves += 1;
                continue;
            }
            let Cell { r, s } = cell;
            // The longer side in terms of n θ and n r.
            let (dr, ds) = ((r[1] - r[0]) as f64 / 2f64.powi(60), 6.3 * (s[1] - s[0]) as f64 / 2f64.powi(64));
            let [middle_r, middle_s] = [r[0] as u64 + (r[1] - r[0]) as u64 / 2, s[0] + (s[1] - s[0]) / 2];
            assert!(dr > 1e-12 && ds > 1e-12, "nothing closes {}", tree::shown(&cell));
            if dr > ds {
                text += "r";
                pending
                    .extend([Cell { r: [middle_r as i64, r[1]], s }, Cell { r: [r[0], middle_r as i64], s }]);
            } else {
                text += "s";
                pending.extend([Cell { r, s: [middle_s, s[1]] }, Cell { r, s: [s[0], middle_s] }]);
            }
        }
    }
    text
}

fn candidates(n: u64, strip: &Strip, cell: &Cell, form: Form, top: i64) -> Vec<Leaf> {
    let Ok(patch) = Patch::new(n, cell, form) else { return Vec::new() };
    let centre: Vec<_> = (1..n).zip(patch.expansions().map(|expansion| expansion.c[0])).collect();
    let positive = centre.iter().max_by_key(|(_, value)| value).unwrap().0;
    let negative = centre.iter().min_by_key(|(_, value)| value).unwrap().0;
    // At the top, where an edge leaf lies has to be told; elsewhere it need not.
    let across = if cell.r[1] == top { vec![1, -1] } else { vec![0] };
    let mut all = vec![Leaf::None { positive, negative }];
    for positive in [false, true] {
        all.push(Leaf::Orbit { positive });
        if let Some(deciding) = strip.deciding() {
            for &across in &across {
                all.push(Leaf::Edge { positive, deciding, across });
            }
        }
    }
    all
}

fn certificate(n: u64, r_max: &str) -> String {
    let (p, q) = r_max.split_once('/').unwrap();
    let rows = strips::rows(Fraction::new(p.parse().unwrap(), q.parse().unwrap()).unwrap());
    let mut leaves = 0;
    let mut body = String::new();
    for strip in strips::strips(n).unwrap() {
        body += &format!("strip {} {}\n{}\n", strip.left, strip.right, trees(n, &strip, &rows, &mut leaves));
    }
    format!("n {n} {r_max} {leaves}\nidentity region2\nidentity region4\n{body}")
}

#[test]
fn small_periods_are_proved() {
    for n in 3..=9 {
        let block = certificate(n, &format!("{}/{}", n.pow(3) - 1, n.pow(3)));
        check_block(n, block.as_bytes(), 5).unwrap();
        if std::env::var("SHOW").is_ok() {
            println!("{block}");
        }
    }
}
