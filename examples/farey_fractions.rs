//! Farey fractions: neighbours, a walk over a range, rank and k-th term.
//!
//! Run with `cargo run --example farey_fractions`.

use grazing::{
    farey::{Walk, kth, neighbours, rank},
    num_rational::Ratio,
};

fn main() -> grazing::Result<()> {
    let x = Ratio::new(3, 8);
    let pair = neighbours(&x)?;
    println!("{} < {x} < {} are neighbours in F_8", pair.left, pair.right);

    let near_third: Vec<String> =
        Walk::new(1000, &Ratio::new(332, 1000), &x)?.take(5).map(|x| x.to_string()).collect();
    println!("F_1000 from 0.332 on: {}", near_third.join(", "));

    let index = rank(&Ratio::new(3, 8), 1_000_000)?;
    println!("3/8 is term {index} of F_1000000, and term {index} is {}", kth(index, 1_000_000)?);
    Ok(())
}
