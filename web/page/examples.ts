// The certificates that the page brings along: the checker's own samples, and one of them damaged.

import branch from "../../crates/checker/tests/data/branch-frequency.txt";
import chaos from "../../crates/checker/tests/data/chaos-12.txt";
import cover from "../../crates/checker/tests/data/cover.txt";
import event from "../../crates/checker/tests/data/event-gr3.txt";
import machine from "../../crates/checker/tests/data/machine-masses.txt";
import orbit from "../../crates/checker/tests/data/orbit-4.txt";
import range from "../../crates/checker/tests/data/range-12.txt";
import share from "../../crates/checker/tests/data/share.txt";
import theorem2 from "../../crates/checker/tests/data/theorem2.txt";
import wordByTheorem from "../../crates/checker/tests/data/word-by-theorem.txt";
import word from "../../crates/checker/tests/data/word.txt";

/** A certificate with its name in links and in the list. */
export interface Example {
  id: string;
  title: string;
  text: string;
}

/** The first line of a certificate that begins with `from`, changed; it must be there. */
function damaged(text: string, from: RegExp, to: string): string {
  const changed = text.replace(from, to);
  if (changed === text) throw new Error(`no line ${from} in the example`);
  return changed;
}

export const EXAMPLES: readonly Example[] = [
  { id: "theorem2", title: "Theorem 2 for n = 1 to 14", text: theorem2 },
  { id: "cover", title: "Conjecture 1 for n = 3 to 8: a cover", text: cover },
  { id: "orbit", title: "A periodic orbit of an oscillator", text: orbit },
  { id: "branch", title: "An orbit at every value of a range", text: branch },
  { id: "event", title: "A grazing bifurcation of an orbit", text: event },
  { id: "machine", title: "A periodic orbit of two masses and a stop", text: machine },
  { id: "chaos", title: "Chaos: every sequence of two letters", text: chaos },
  { id: "range", title: "Chaos, from the touch to 1000 times the drive", text: range },
  { id: "word", title: "The word at a point, by signs", text: word },
  { id: "word-by-theorem", title: "The word at a point, by the theorem", text: wordByTheorem },
  { id: "share", title: "In which share of a tolerance chaos is born", text: share },
  { id: "false", title: "Theorem 2 with one sign changed: false", text: damaged(theorem2, /\+ \+$/m, "- +") },
  { id: "malformed", title: "A cover without its last line: malformed", text: cover.replace(/[^\n]*\n$/, "") },
];
