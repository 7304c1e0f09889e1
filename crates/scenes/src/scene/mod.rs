//! Scenes: a vibro-impact system, what to do with it and how accurately, as a TOML file that anyone can
//! write.
//!
//! There is one grammar, that of format 3; its keys are in docs/scenes.md, written by [`reference()`] from
//! their declarations. Files of formats 1 and 2 are turned into it first (`format`). Numbers are exact;
//! coefficients are expressions in named parameters ([`Expression`]). What the file says becomes what one of
//! two engines is told: `oscillator` for `one`, if the system qualifies, else `machine` for `many`. Not here:
//! running the tasks (the module `run`).
//!
//! Each file imports from those before it alone: `dual`, `expression`, `dimension`, `quantity`, `format`,
//! `keys`, `force`, `matrix`, `measured`; the keys of the system, `system`; what the engines are told,
//! `machine`, `oscillator`; the keys of tasks, `simulate`, `orbits`, `sections`, `branches`, `response`,
//! `validate`, `chaos`; `task`; `scene`, the type and its values; `values`, those of a machine; `normal`,
//! `check`; `wanted`, `input`, `upgrade`, `family`, `reference`.

pub mod branches;
pub mod chaos;
mod check;
mod dimension;
mod dual;
mod expression;
mod family;
mod force;
mod format;
mod grammar;
mod hidden;
mod input;
mod keys;
mod law;
mod linear;
mod machine;
mod matrix;
mod measured;
pub(crate) mod monitors;
mod normal;
pub mod orbits;
mod oscillator;
mod quantity;
mod reference;
pub mod response;
pub mod rest;
mod restitution;
#[expect(clippy::module_inception, reason = "the chapter is named after its main type")]
mod scene;
mod sections;
pub mod simulate;
mod system;
pub mod task;
mod tolerance;
pub(crate) mod tolerated;
pub mod units;
mod upgrade;
pub mod validate;
pub(crate) mod values;
mod walls;
mod wanted;

pub use crate::formula::Function;
pub use expression::{Coefficient, Expression};
pub use family::{MachineSceneFamily, SceneFamily};
pub use format::SceneFormat;
pub(crate) use hidden::is_hidden;
pub use keys::StopName;
pub use machine::MachineScene;
pub use matrix::CoordinateList;
pub use measured::MeasuredForce;
pub use quantity::WrittenUnit;
pub use reference::reference;
#[doc(hidden)]
pub use scene::phase;
pub use scene::{Body, Engine, Scene};
pub(crate) use sections::StartAxis;
pub use sections::{BasinsTask, Frame, SectionTask, Values};
pub use system::{Accuracy, EngineKey};
pub use task::{Kind, Task};
pub use tolerance::{Tolerance, Tolerances};
pub use values::WrittenMachine;
