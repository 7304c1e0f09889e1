//! Which graph is born on one side of a touch: the word theorem at E(2π).

use num_rational::BigRational;
use num_traits::ToPrimitive;

use crate::{
    chaos::{LetterGraph, map::Cell, profile::Profile, span::Span},
    error::Result,
    monitor::Monitor,
    word::{Edge, Rectangle, Relation, Word},
};

/// The most letters of a word that are followed.
const LETTERS: usize = 100;

/// What is born on one side of a touch.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Born {
    /// The periods that are certain, with the edges that are: those on paths without end. None if there are
    /// no such paths.
    pub graph: Option<LetterGraph>,
    /// Whether these are all: no period is left out, and no edge is open.
    pub whole: bool,
}

/// The graph that the word theorem has for q″ = −c q′ − k q at the touch, beyond it (σ = 1, eµ < 0) or
/// before, of periods up to `longest`; between mirrored walls, of half periods, at −E(π). c and k are taken
/// as floats, a₁ and a₂ as known to 10⁻¹²; none where the theorem does not apply.
///
/// Cost: that of [`Word::in_rectangle`].
///
/// # Errors
/// The monitor's interruption.
pub fn born(
    mirrored: bool,
    [damping, stiffness]: [&BigRational; 2],
    behind: bool,
    longest: u64,
    monitor: &dyn Monitor,
) -> Result<Option<Born>> {
    let point = |x: &BigRational| Span::point(x.to_f64().unwrap_or(f64::NAN));
    let (zero, one) = (Span::point(0.0), Span::point(1.0));
    let parameters = [point(damping), point(stiffness), zero, one, zero];
    let cell = Cell::new(mirrored, parameters, 1.0, &std::rc::Rc::new(Profile::new(&[])));
    let [trace, determinant] = cell.invariants().map(Span::middle);
    // The sign of γ is that of E₁₂.
    let gamma = cell.turned(1).b.middle();
    let Some(rectangle) = Rectangle::about(trace, determinant).filter(|_| gamma != 0.0) else {
        return Ok(None);
    };
    let word = Word::in_rectangle(&rectangle, !behind, LETTERS, monitor)?;
    born_of(&word, gamma > 0.0, determinant > 1.0, longest).map(Some)
}

/// The graph of a word, for γ > 0 or γ < 0; with time reversed if a₂ > 1.
///
/// # Errors
/// As [`Relation::new`].
pub fn born_of(word: &Word, gamma: bool, reversed: bool, longest: u64) -> Result<Born> {
    let relation = Relation::new(word, gamma, reversed, longest)?;
    let certain = |row: &Vec<Edge>| (0..row.len()).filter(|&j| row[j] == Edge::Yes).collect();
    let graph = LetterGraph {
        letters: relation.periods().to_vec(),
        next: relation.edges().iter().map(certain).collect(),
    };
    Ok(Born { graph: endless(graph), whole: relation.is_whole() && !relation.is_open() })
}

/// What is left of a graph where every letter is followed and preceded, its letters by increasing periods.
pub(super) fn endless(mut graph: LetterGraph) -> Option<LetterGraph> {
    let mut order: Vec<usize> = (0..graph.letters.len()).collect();
    order.sort_by_key(|&v| graph.letters[v]);
    graph = sorted(graph.part(&order));
    loop {
        let followed = |v: usize| graph.next.iter().any(|next| next.contains(&v));
        let keep: Vec<usize> =
            (0..graph.letters.len()).filter(|&v| !graph.next[v].is_empty() && followed(v)).collect();
        if keep.len() == graph.letters.len() {
            return (!keep.is_empty()).then_some(graph);
        }
        graph = sorted(graph.part(&keep));
    }
}

/// With each letter's successors in order.
fn sorted(mut graph: LetterGraph) -> LetterGraph {
    graph.next.iter_mut().for_each(|next| next.sort_unstable());
    graph
}
