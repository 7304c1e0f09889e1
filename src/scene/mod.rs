//! Scenes: an oscillator, what to do with it and how accurately, as a TOML file that anyone can write.
//!
//! The format, with every key, is in docs/scenes.md, written by [`reference()`] from the declarations of
//! keys. Numbers are exact; coefficients are rational expressions in named parameters ([`Expression`]). Not
//! here: running the tasks (the module `run`).
//!
//! Each file imports from those before it alone: `dual`, `expression`, `keys`, `force`, `matrix`, `measured`;
//! the keys, `system`, `machine`, `simulate`, `orbits`, `sections`, `branches`, `validate`, `chaos`; `task`;
//! `scene`, the type and its values; `values`, those of a machine; `normal`, `check`; `input`, `family`,
//! `reference`.

pub mod branches;
pub mod chaos;
mod check;
mod dual;
mod expression;
mod family;
mod force;
mod input;
mod keys;
mod machine;
mod matrix;
mod measured;
mod normal;
pub mod orbits;
mod reference;
mod restitution;
#[expect(clippy::module_inception, reason = "the chapter is named after its main type")]
mod scene;
mod sections;
pub mod simulate;
mod system;
pub mod task;
pub mod validate;
mod values;
mod walls;

pub use crate::formula::Function;
pub use expression::{Coefficient, Expression};
pub use family::{MachineSceneFamily, SceneFamily};
pub use keys::Key;
pub use machine::MachineScene;
pub use matrix::CoordinateList;
pub use measured::MeasuredForce;
pub use reference::reference;
#[doc(hidden)]
pub use scene::phase;
pub use scene::{Body, Scene};
pub use sections::{BasinsTask, Frame, SectionTask, StartAxis, Values};
pub use system::Accuracy;
pub use task::{Kind, Task};
