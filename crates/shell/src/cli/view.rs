//! Options that say what part of its plane a picture shows.

use clap::Args;

use super::range::Span;
use crate::{
    error::{Error, Result},
    figure::View,
    number::{Plain, Real},
};

/// What pictures of sections, diagrams and branches show.
#[derive(Debug, Clone, Default, Args)]
pub(super) struct ViewArgs {
    /// Across, show this part in pictures of sections, diagrams and branches; the data beside them are whole.
    #[arg(long, value_name = "A..=B")]
    x_limits: Option<Span>,
    /// Up, show this part in them.
    #[arg(long, value_name = "A..=B")]
    y_limits: Option<Span>,
    /// In them show displacements q modulo 2 pi, for what turns round.
    #[arg(long)]
    q_modulo_2pi: bool,
}

impl ViewArgs {
    /// Whether a picture shows all, as it is.
    pub fn is_whole(&self) -> bool {
        self.x_limits.is_none() && self.y_limits.is_none() && !self.q_modulo_2pi
    }

    /// What a picture shows.
    ///
    /// # Errors
    /// An input error for limits that are one number.
    pub fn view(&self) -> Result<View> {
        let ends = |name: &str, span: &Option<Span>| match span {
            Some(span) if !span.is_interval() => {
                Err(Error::input(format!("--{name}-limits: two different ends are needed, as in 0..=1")))
            }
            span => Ok(span
                .as_ref()
                .map(|Span([low, high], _)| (Plain::ratio(low, &()).0, Plain::ratio(high, &()).0))),
        };
        Ok(View { x: ends("x", &self.x_limits)?, y: ends("y", &self.y_limits)?, turns: self.q_modulo_2pi })
    }
}
