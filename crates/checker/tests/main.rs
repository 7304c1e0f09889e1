//! The checker from outside: what is written passes, what is forged or damaged is refused or true, second
//! readers agree. One program, so that its tests share the cores to the end; `command` and `text`, which are
//! tried of a release build too, are two more.

mod common;
#[path = "../../../tests/samples/mod.rs"]
mod samples;

mod attractor;
mod branch;
mod chaos;
mod cover;
mod details;
mod entropy;
mod event;
mod free;
mod machine;
mod mirrored;
mod nothing;
mod orbit;
mod parameter;
mod range;
mod range_damage;
mod reference;
mod share;
mod single;
mod theorem2;
mod units;
mod word;
