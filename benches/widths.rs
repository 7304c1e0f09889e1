//! How many bits enclosures lose, at the points of a file: the other side of benches/peers/widths.sh.
//!
//! The file has lines family,distance,quantity,n,k,coordinates,x,y,sign. Printed: family,distance,bits,lost
//! for f64 intervals (53 bits) and balls, the same for a close evaluation to 256 bits (`closely`), and log₂
//! of the condition number (`condition`). Nothing is timed.

use std::{env, fs};

use grazing::{
    local::{Plane, Point, Polar, Quantity, condition::condition},
    number::{Ball, FloatInterval, Precision, parse_rational},
};

fn main() {
    let Some(file) = env::args().skip(1).find(|argument| !argument.starts_with('-')) else { return };
    let precisions = [128, 256, 1024, 4096].map(Precision::new);
    for line in fs::read_to_string(file).expect("a file of points").lines() {
        let part: Vec<&str> = line.split(',').collect();
        let number = |i: usize| part[i].parse::<u64>().expect("an integer");
        let [x, y] = [6, 7].map(|i| parse_rational(part[i]).expect("a fraction"));
        let point = match part[5] {
            "rs" => Point::Polar(Polar::new(x, y).expect("a point")),
            _ => Point::Plane(Plane::new(x, y).expect("a point")),
        };
        let quantity = match part[2] {
            "b" => Quantity::B { n: number(3), k: number(4) },
            _ => Quantity::C { n: number(3) },
        };
        let say = |what: &str, lost: f64| println!("{},{},{what},{lost:.0}", part[0], part[1]);
        let Some(interval) = point.evaluate::<FloatInterval>(quantity, &()) else { continue };
        let (lo, hi) = (interval.lo(), interval.hi());
        let certain = ((lo + hi).abs() / (hi - lo)).log2();
        say("53", 53.0 - if certain.is_nan() { 0.0 } else { certain.clamp(0.0, 53.0) });
        for precision in &precisions {
            let ball = point.evaluate::<Ball>(quantity, precision).expect("no singular point");
            let bits = f64::from(precision.bits());
            say(
                &precision.bits().to_string(),
                ball.certain_bits().map_or(0.0, |certain| bits - certain as f64),
            );
        }
        let close = point.evaluate_closely(quantity, &precisions[1]).expect("no singular point");
        say("closely", close.certain_bits().map_or(0.0, |certain| (256.0 - certain as f64).max(0.0)));
        // From a step of 2⁻³⁰⁰: nearer places need a shorter one.
        if part[1].trim_start_matches("1e-").parse::<u32>().is_ok_and(|digits| digits <= 50) {
            say("condition", condition(&point, quantity).log2());
        }
    }
}
