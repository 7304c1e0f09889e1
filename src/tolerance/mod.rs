//! Machines as measured: parameters known up to tolerances, and what is true of all that they allow.
//!
//! A [`ParameterBox`] is a rectangle of parameters: natural over drive frequency and damping ratio, or r and
//! s, or a₁ and a₂; or it has any number of parameters, of which damping and stiffness are functions
//! ([`Coefficients`]). Its image in the plane of the word theorem is a curved strip, thinner than the
//! rectangle around it. So no sign is decided on that rectangle: boxes are cut into cells, and on each cell a
//! sign is decided in the box's own parameters, by Taylor's formula of second order (`expansion`).
//!
//! [`ParameterBox::word`] is what the words of all points have in common. [`Partition`] cuts a box where
//! words differ and bounds the share of the box in which a statement holds: the cells where it certainly
//! does, and those where it certainly does not. [`Statement`]s are three-valued on a cell; on the box they
//! hold everywhere, nowhere or in a part of it ([`Spread`]), or are open. [`Excursion`]s say how far one
//! parameter may go from a point before a statement changes. A [`ChaosChart`] says where in a plane of
//! machines chaos is born. A [`Decay`] finds frequency and damping ratio with their deviations in a record:
//! floating point, without proof.
//!
//! ```
//! use grazing::{number::parse_rational, tolerance::{ParameterBox, Partition, Statement, Spread}};
//! let q = |text| parse_rational(text);
//! // 0.6 to 0.61 times the drive's frequency, damping ratio 0.1 up to 10 %.
//! let machine = ParameterBox::machine([q("0.6")?, q("0.61")?], [q("0.09")?, q("0.11")?])?;
//! let word = machine.word(true, 100, &())?;
//! assert_eq!((word.letters().as_str(), word.is_whole()), ("DUD", true));
//! // γ < 0: chaos is born for eµ > 0, whatever the machine is within these bounds.
//! let partition = Partition::new(&machine, 100, &())?;
//! assert_eq!(partition.share(Statement::ChaosAt { positive: true }).spread(), Spread::Everywhere);
//! # Ok::<(), grazing::Error>(())
//! ```
//!
//! Not here: how tolerances are written (the command line), and maps with more than two dimensions.

mod cell;
mod change;
mod chart;
mod decay;
mod expansion;
mod normal;
mod oscillator;
mod parameters;
mod partition;
mod sloped;
mod tube;
mod verdicts;

pub use change::{Change, Excursion, Toward};
pub use chart::{ChaosChart, ChartCell};
pub use decay::{Decay, Estimate};
pub use normal::{DEVIATIONS, NormalParameters};
pub use oscillator::Coefficients;
pub use parameters::ParameterBox;
pub use partition::{Leaf, Partition, Share, Spread, Statement};
pub use sloped::Sloped;
pub use verdicts::{CaseSigns, LAST_PERIOD, MOST_CELLS, Subject, SubjectVerdict};
