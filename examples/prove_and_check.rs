//! Prove Theorem 2 for a range of periods, write the certificate, and have it checked.
//!
//! Run with `cargo run --release --example prove_and_check`.

use grazing::{
    certificate,
    search::{ProofMethod, prove_theorem2, write_theorem2},
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let range = 3..=50;
    let proof = prove_theorem2(range.clone(), ProofMethod::Exact, &())?;
    if let Some(decision) = &proof.refuted {
        println!("refuted for n = {}: {:?}", decision.n, decision.disagreement);
        return Ok(());
    }
    let mut text = Vec::new();
    write_theorem2(range, &proof, &mut text, &())?;
    println!("a certificate of {} bytes for {} periods", text.len(), proof.periods);

    // The checker knows nothing of the search: it reads the text and proves every line again.
    let checked = certificate::check(&mut &text[..])?;
    println!("{}: {}", checked, checked.statement);

    // A certificate that has been tampered with is rejected, with the line and the reason.
    let damaged = String::from_utf8(text)?.replace("orbit 1/16 1/8 + +", "orbit 1/16 1/8 + -");
    println!("damaged: {}", certificate::check(&mut damaged.as_bytes()).unwrap_err());
    Ok(())
}
