//! The page's program: what the page calls, as WebAssembly in a worker.
//!
//! Every function takes strings, numbers, bytes or typed arrays and gives JSON as a string, or a typed array.
//! Where it fails it gives `{"error": {"message", "line", "key"}}` (see [`answer`]); none panics. The logic
//! stands in plain functions that need no browser (`cargo test`); what a browser needs is one line each.

pub mod answer;
pub mod check;
pub mod machine;
pub mod motion;
pub mod plane;
pub mod theory;

pub use answer::{Answer, Fault};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// Tells the page what a panic said.
    #[wasm_bindgen(js_name = grazingPanic)]
    fn tell_panic(message: &str);

    /// Tells the page how far a call is.
    #[wasm_bindgen(js_name = grazingProgress)]
    fn tell_progress(done: f64, total: f64);
}

/// Runs once, when the page has loaded the program.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|info| {
        tell_panic(&format!("the program broke off, which is a fault in it: {info}"))
    }));
}

/// [`check::check`] of a file's bytes, telling its progress.
#[wasm_bindgen]
pub fn check(bytes: &[u8]) -> String {
    check::check(bytes, &mut |done, total| tell_progress(done as f64, total as f64))
}

/// Breaks off, if the checker was built to notice overflows, as it must be: for tests of a build.
#[wasm_bindgen]
pub fn overflow() -> String {
    grazing_check::overflow().to_string()
}

/// [`theory::number`].
#[wasm_bindgen]
pub fn number(text: &str) -> String {
    theory::number(text)
}

/// [`machine::machine`].
#[wasm_bindgen]
pub fn machine(text: &str) -> String {
    machine::machine(text)
}

/// [`theory::classify`].
#[wasm_bindgen]
pub fn classify(place: &str, x: &str, y: &str, max_n: u32) -> String {
    theory::classify(place, x, y, max_n)
}

/// [`theory::evaluate`].
#[wasm_bindgen]
pub fn evaluate(place: &str, x: &str, y: &str, n: u32, k: u32, bits: u32) -> String {
    theory::evaluate(place, x, y, n, k, bits)
}

/// [`theory::existence`].
#[wasm_bindgen]
pub fn existence(a1: &str, a2: &str, gamma_positive: bool, max_period: u32) -> String {
    theory::existence(a1, a2, gamma_positive, max_period)
}

/// [`theory::cover`].
#[wasm_bindgen]
pub fn cover(first: u32, last: u32, r_max: &str) -> String {
    theory::cover(first, last, r_max)
}

/// [`theory::theorem2`].
#[wasm_bindgen]
pub fn theorem2(first: u32, last: u32) -> String {
    theory::theorem2(first, last)
}

/// [`plane::view`].
#[wasm_bindgen]
pub fn plane_view(request: &str) -> String {
    plane::view(request)
}

/// [`plane::point`].
#[wasm_bindgen]
pub fn plane_point(request: &str) -> String {
    plane::point(request)
}

/// [`plane::certificate`].
#[wasm_bindgen]
pub fn plane_certificate(request: &str) -> String {
    plane::certificate(request)
}

/// [`plane::shares`](fn@plane::shares).
#[wasm_bindgen]
pub fn plane_shares(request: &str) -> String {
    plane::shares(request)
}

/// [`plane::place`].
#[wasm_bindgen]
pub fn plane_place(request: &str) -> String {
    plane::place(request)
}
