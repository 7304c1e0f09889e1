//! What the Python package `grazing` is made of: the library's functions, with Python's numbers and NumPy's
//! arrays in and out.
//!
//! Thin: each function converts its arguments, lets the library work on a thread of its own while Python goes
//! on ([`watch`]), and gives back tuples, texts and arrays. The classes that a user sees are Python's, in
//! `grazing/*.py`. No mathematics here.

mod arrays;
mod batch;
mod boxes;
mod classify;
mod columns;
mod decay;
mod exact;
mod failure;
mod forced;
mod machines;
mod places;
mod proofs;
mod scene;
mod theory;
mod watch;

use pyo3::prelude::*;

/// The compiled part of the package. Use the package `grazing`.
#[pymodule]
fn _grazing(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<scene::Scene>()?;
    proofs::add(module)?;
    theory::add(module)?;
    places::add(module)?;
    classify::add(module)?;
    boxes::add(module)?;
    decay::add(module)?;
    forced::add(module)
}
