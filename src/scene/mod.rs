//! Scenes: an oscillator, what to do with it and how accurately, as a TOML file that anyone can write.
//!
//! The format, with every key, is in docs/scenes.md, written by [`reference()`] from the declarations of keys.
//! Numbers are exact; coefficients are rational expressions in named parameters ([`Expression`]). Not here: running the
//! tasks (the module `run`).
//!
//! Each file imports from those before it alone: `expression`, `keys`; the keys, `system`, `simulate`, `orbits`, `sections`,
//! `branches`, `validate`; `task`; `scene`, the type and its values; `check`; `input`, `family`, `reference`.

pub mod branches;
mod check;
mod expression;
mod family;
mod input;
mod keys;
pub mod orbits;
mod reference;
#[expect(clippy::module_inception)]
mod scene;
mod sections;
pub mod simulate;
mod system;
pub mod task;
pub mod validate;
mod walls;

pub use expression::{Coefficient, Expression};
pub use family::SceneFamily;
pub use keys::Key;
pub use reference::reference;
pub use scene::Scene;
pub(crate) use scene::phase;
pub use sections::{BasinsTask, Frame, SectionTask, Values};
pub use system::Accuracy;
pub use task::{Kind, Task};
