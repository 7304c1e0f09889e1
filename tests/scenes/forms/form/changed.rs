//! Not a form: the scene with other coefficients, by which the condition of its numbers is seen.

use toml::{Table, Value};

use crate::forms::{
    draw::Random,
    scene::{LENGTH, What, each_number, stops, text},
};

/// The scene with every coefficient changed by a part of up to δ, at random.
pub fn changed(base: &Table, delta: f64, seed: u64) -> Table {
    let mut scene = base.clone();
    move_walls(&mut scene, delta, seed);
    let parts = (4.0 / delta).log2().round() as u32;
    let mut count = 0;
    each_number(&mut scene, &mut |mut slot| {
        count += 1;
        // How far a born orbit is from its grazing is the difference of two parameters. These are known to
        // δ of themselves, which is more beside a distance of 2⁻²⁰ of the motion's size.
        if slot.what == What::Distance {
            let number: f64 = slot.text().parse().expect("a number");
            let part = f64::from(Random(seed).signed_part());
            *slot.value = Value::Float(number * (1.0 + part / 4.0 * delta * 1_048_576.0));
            return;
        }
        if matches!(slot.what, What::Clock | What::Bound | What::Row) || slot.plain {
            return;
        }
        // The same for the two entries of a symmetric matrix.
        let [i, j] = slot.entry;
        let place = (i.min(j) * 1000 + i.max(j)) as u64;
        let list = u64::from(matches!(slot.what, What::Linear | What::Inertia));
        let key = seed.wrapping_mul(0x1_0001)
            ^ (place * list)
            ^ (((1 - list) * count) << 20)
            ^ ((slot.what as u64) << 50)
            ^ ((slot.unit.1 as u64) << 55);
        let part = Random(key).signed_part();
        let part = if slot.what == What::Restitution { -part.abs() } else { part };
        slot.wrap(&format!("({{}})*(1 + ({part})/2^{parts})"));
    });
    scene
}

/// Moves walls at 0 away by a part of up to δ of the lengths of the scene: of 0 no part is a change, and what
/// rounding leaves of a gap goes with the displacements, wherever the wall is.
fn move_walls(scene: &mut Table, delta: f64, seed: u64) {
    let mut size: f64 = 0.0;
    each_number(scene, &mut |slot| {
        if slot.unit == LENGTH
            && matches!(slot.what, What::Place | What::Start)
            && let Ok(x) = slot.text().parse::<f64>()
        {
            size = size.max(x.abs());
        }
    });
    for (i, wall) in (1..).zip(stops(scene)) {
        let upper = wall.get("side").and_then(Value::as_str) == Some("upper");
        let Some(offset) = wall.get_mut("offset").filter(|offset| text(offset).parse::<f64>() == Ok(0.0))
        else {
            continue;
        };
        let part = f64::from(Random(seed.wrapping_mul(0x1_0001) ^ (i << 40)).signed_part().abs());
        *offset = Value::Float(part / 4.0 * delta * if upper { size } else { -size });
    }
}
