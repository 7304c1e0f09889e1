#!/bin/sh
# Breaks a copy of the development in one way after the other; check.sh must refuse each, for the reason given here.
# Run check.sh first: the copies begin with what it has compiled. Names as arguments run those alone.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -a "$here/." "$work/original"
total=0 survived=
chosen=" $* "

# mutant NAME REASON OPTION FILE: the edit is a sed script on stdin, or, after the word "append" or "new", text, or,
# after "sh", a shell script. OPTION --stale: the file seems older than what was compiled.
mutant() {
  name=$1 reason=$2 option=$3 file=$4
  edit=$(cat)
  case "$chosen" in "  " | *" $name "*) ;; *) return 0 ;; esac
  total=$((total + 1))
  rm -rf "$work/mutant"
  cp -a "$work/original" "$work/mutant"
  cd "$work/mutant"
  mkdir -p "$(dirname "$file")"
  case "$edit" in
    append*) printf '%s\n' "$edit" | sed 1d >>"$file" ;;
    new*) printf '%s\n' "$edit" | sed 1d >"$file" ;;
    sh*) printf '%s\n' "$edit" | sed 1d | sh ;;
    *) sed -i "$edit" "$file" ;;
  esac
  if [ -e "$work/original/$file" ] && cmp -s "$file" "$work/original/$file"; then echo "mutants.sh: $name changes nothing" >&2; exit 1; fi
  case "$option" in --stale) touch -d '2000-01-01' "$file"; set -- ;; *) set -- --compiled $option ;; esac
  if sh check.sh "$@" >"$work/output" 2>&1; then
    survived="$survived $name"; echo "$name: ACCEPTED"
  elif ! grep -qE "$reason" "$work/output"; then
    survived="$survived $name"; echo "$name: refused for another reason:"; tail -5 "$work/output"
  else
    echo "$name: refused"
  fi
}

# What is assumed or not proved.
mutant unused-axiom 'assumed, unproved' '' Sine.v <<'E'
append
Local Axiom cheat : False.
E
mutant admitted-with-a-space 'assumed, unproved' '' Sine.v <<'E'
append
Lemma cheat : False. Proof. Admitted .
E
mutant admitted-on-two-lines 'assumed, unproved' '' Sine.v <<'E'
append
Lemma cheat : False. Proof. Admitted
.
E
mutant admit-after-a-comment 'assumed, unproved' '' Sine.v <<'E'
append
Lemma cheat : False. Proof. (* (* *) *)admit. Defined.
E
mutant guard-off 'assumed, unproved' '' Reverse.v <<'E'
append
Unset Guard Checking.
E
mutant guard-bypassed 'assumed, unproved' '' Reverse.v <<'E'
append
#[bypass_check(guard)] Fixpoint loop (n : nat) : False := loop n.
E
mutant file-not-listed 'not listed' '' Cheat.v <<'E'
new
Lemma cheat : True. Proof. exact I. Qed.
E
mutant top-level-variable 'coqchk.txt and what was found differ' '' Reverse.v <<'E'
append
Variable cheat : False.
E
mutant another-axiom 'coqchk.txt and what was found differ' '' Reverse.v <<'E'
append
From Coq Require ClassicalEpsilon.
E

# What is extracted. The word list knows strings, which hide no words.
mutant constant-replaced 'about extraction' --pin RangesCheck.v <<'E'
append
From Coq Require ExtrOcamlBasic.
Extract Constant check_range => "(fun _ -> true)".
E
mutant constant-replaced-between-strings 'about extraction' --pin RangesCheck.v <<'E'
append
From Coq Require Import String.
Definition opens := "(*"%string.
From Coq Require ExtrOcamlBasic.
Extract Constant check_range => "(fun _ -> true)".
Definition closes := "*)"%string.
E
mutant constant-replaced-after-a-string-in-a-comment 'about extraction' --pin RangesCheck.v <<'E'
append
(* "(*" *) From Coq Require ExtrOcamlBasic. Extract Inlined Constant check_range => "(fun _ -> true)". (* "*)" *)
E
mutant integers-replaced 'about extraction' --pin PathsCheck.v <<'E'
append
From Coq Require ExtrOcamlZInt.
E
mutant library-from-elsewhere 'otherwise than From Coq or From Grazing' --pin PathsCheck.v <<'E'
append
Require Import Elsewhere.
E
mutant namesake-extracted 'extracts RangesExample.check_range, which no theorem is about' --pin Oracle.v <<'E'
sh
sed -i 's/Grazing\.RangesCheck\.check_range/Grazing.RangesExample.check_range/; s/ RangesCheck\.$/ RangesExample./' Oracle.v
echo 'Definition check_range (C : StatementRanges.Range.t) := true.' >>RangesExample.v
E
mutant extracted-by-a-short-name 'must require' --pin Oracle.v <<'E'
s/Grazing\.RangesCheck\.check_range/check_range/; s/^From Grazing Require /&Import /
E
mutant replaced-in-the-oracle 'must require' --pin Oracle.v <<'E'
/^Extraction/i Extract Constant Grazing.RangesCheck.check_range => "(fun _ -> true)".
E
mutant extracted-not-as-pinned 'assumptions.txt and what was found differ' '' Oracle.v <<'E'
s/Grazing\.StatementZ\.uZ //
E

# What is stated. With --pin the texts are taken as they are: the hand-worked numbers must notice.
mutant notation-of-its-own 'definitions alone' --pin Statement.v <<'E'
s/^Open Scope R_scope\.$/&\nLocal Notation "x > y" := (x >= y) (at level 70, only parsing) : R_scope./
E
mutant said-otherwise 'statements.txt and what was found differ' '' Statement.v <<'E'
/S4_section_statement/,/^$/ s/(3 <= n)%nat/(2 < n)%nat/
E
mutant sections-weakened 'File "./ConsequencesAreas' --pin Statement.v <<'E'
/S4_section_statement/,/^$/ s/0 < r < 1 ->/1 \/ 2 < r < 1 ->/
E
mutant orbit-not-strict 'File "./(Consequences|OrbitZ)' --pin Defs.v <<'E'
s/sgn emu \* b a1 a2 n k > 0/sgn emu * b a1 a2 n k >= 0/
E
mutant period-2-for-small-a2 'File "./Consequences' --pin StatementPlane.v <<'E'
s/^Definition Period2_statement : Prop := forall a1 a2 e g, 0 < a2 ->/Definition Period2_statement : Prop := forall a1 a2 e g, 0 < a2 <= 3 ->/
E
mutant double-zero-for-small-k 'File "./Consequences' --pin StatementB.v <<'E'
/B_double_zero_statement/,/^$/ s/(1 <= k <= n - 1)%nat/(1 <= k <= 2)%nat/
E
mutant outside-dropped 'File "./Consequences' --pin Statement.v <<'E'
s/(outside n s -> u_at 1 s n <> 0 -> no_orbit_at 1 s n)\./True./
E
mutant area-without-its-graph 'File "./Consequences' --pin Headline.v <<'E'
s/^  (Rad s < r -> exactly (trace r s) (r ^ 2) n Plus g) \/\\ /  /
E
mutant chaos-in-no-box 'File "./Consequences' --pin StatementChaos.v <<'E'
s/615 \/ 1000 \* mu <= v i (t i)/0 <= v i (t i)/
E
mutant theorem-dropped 'assumptions.txt and what was found differ' '' Main.v <<'E'
/^Theorem S4 :/d
E
mutant theorem-dropped-and-pinned 'S4_statement of Statement.v has no theorem' --pin Main.v <<'E'
/^Theorem S4 :/d
E

# Where Coq and this script look for files.
mutant statement-in-a-folder 'is a folder' '' evil/StatementChaos.v <<'E'
new
Definition Chaos_distinct_statement : Prop := True.
E
mutant folder-listed 'not the name of a file' '' _CoqProject <<'E'
append
evil/StatementChaos.v
E
mutant option-in-the-project 'not the name of a file' '' _CoqProject <<'E'
append
-arg -type-in-type
E
mutant another-root 'must begin with' '' _CoqProject <<'E'
1s/.*/-Q . Evil/
E
mutant blank-after-a-name 'not the name of a file' '' _CoqProject <<'E'
s/^StatementChaos\.v$/& /
E
mutant listed-twice 'listed twice' '' _CoqProject <<'E'
append
Sine.v
E
mutant options-for-make 'has no place' '' Makefile.coq.local <<'E'
new
COQEXTRAFLAGS = -type-in-type
E
mutant options-for-make-at-its-end 'has no place' '' Makefile.coq.local-late <<'E'
new
COQEXTRAFLAGS = -type-in-type
E
mutant options-in-the-list-of-dependencies 'File "./Reverse.v"' --pin Reverse.v <<'E'
sh
echo 'Definition cheat : Set := Type.' >>Reverse.v
echo 'override COQFLAGS := -q -type-in-type' >>.Makefile.coq.d
touch -d '+1 hour' .Makefile.coq.d
E
mutant compiled-after-a-change 'File "./Farey.v"' --stale Farey.v <<'E'
append
Lemma cheat : False. Proof. exact I. Qed.
E
mutant universes-off 'assumed, unproved' '' Reverse.v <<'E'
append
Unset Universe Checking.
E
mutant universes-bypassed 'assumed, unproved' '' Reverse.v <<'E'
append
#[bypass_check(universes)] Definition large : Prop := True.
E
mutant obligations-admitted 'assumed, unproved' '' Reverse.v <<'E'
append
Admit  Obligations.
E

# Statements that are not what they seem.
mutant blank-before-a-definition 'Hidden_statement of StatementChaos.v' '' StatementChaos.v <<'E'
append
  Definition Hidden_statement : Prop := True.
E
mutant definition-on-two-lines 'Hidden_statement of StatementChaos.v' '' StatementChaos.v <<'E'
append
Definition
Hidden_statement : Prop := True.
E
mutant stated-in-a-proof-file 'belongs into Headline.v or a file Statement' '' ChaosContinuous.v <<'E'
append
Definition Chaos_continuous_statement : Prop := True.
E
mutant stated-by-a-notation 'belongs into Headline.v or a file Statement' '' ChaosContinuous.v <<'E'
append
Notation Chaos_continuous_statement := True.
E
mutant statement-after-a-proof 'no statement file' '' StatementChaos.v <<'E'
s/^Open Scope R_scope\.$/From Grazing Require Import Algebra.\n&/
E
mutant statement-with-a-coercion 'definitions alone' '' StatementChaos.v <<'E'
s/^Open Scope R_scope\.$/&\nCoercion INR : nat >-> R./
E
mutant statement-with-a-lemma 'definitions alone' '' StatementChaos.v <<'E'
append
Lemma small : True. Proof. exact I. Qed.
E

# Lengths and times of return.
mutant lengths-of-short-periods 'File "./ConsequencesNumbers' --pin StatementMeasure.v <<'E'
s/(3 <= n)%nat -> NoDup L/(3 <= n <= 7)%nat -> NoDup L/
E
mutant returns-slowly-repelled 'File "./ConsequencesNumbers' --pin StatementReturns.v <<'E'
s/T_beyond : 1 < r ->/T_beyond : 1 < r < 2 ->/
E

mutant entropy-for-small-mu 'File "./ConsequencesNumbers' --pin StatementEntropy.v <<'E'
/^Definition Entropy_statement/ s/mu > 0 ->/mu > 0 -> mu < 1 ->/
E
mutant growth-of-long-periods 'File "./ConsequencesNumbers' --pin StatementEntropy.v <<'E'
s/(1 <= P)%nat ->/(4 <= P)%nat ->/
E
mutant period-map-for-small-mu 'File "./ConsequencesNumbers' --pin StatementEntropy.v <<'E'
/^Definition Period_map_statement/ s/mu > 0 ->/mu > 0 -> mu < 1 ->/
E

mutant uniform-in-one-flight 'File "./ConsequencesNumbers' --pin StatementUniform.v <<'E'
s/contracting M letters L ->/contracting M letters L -> (L <= 1)%nat ->/
E

# Statements weakened, the texts taken as they are.
mutant only-with-a-bounce 'File "./ConsequencesSystems' --pin StatementOscillator.v <<'E'
s/is_restitution : 0 <= Oscillator.tau O/is_restitution : 0 < Oscillator.tau O/
E
mutant not-the-only-motion 'File "./ConsequencesSystems' --pin StatementOscillator.v <<'E'
s/^  forall i x, t' i = t i .*/  forall i x : R, True./
E
mutant one-stop-only 'File "./ConsequencesSystems' --pin StatementOscillator.v <<'E'
s/forall a1 a2, 0 < a2 -> a1 <= - 2 \* sqrt a2 ->/forall a1 a2, 0 < a2 -> a1 <= - 2 -> a1 <= - 2 * sqrt a2 ->/
E
mutant wall-of-another-shape 'File "./Consequences' --pin StatementNordmark.v <<'E'
s/y i (t i) = (1 + mu) \* cos (t i) - 1/y i (t i) = (1 + mu) * cos (t j) - 1/
E
mutant statement-without-numbers 'Det_D_statement of StatementImpacts.v occurs in no Consequences' --pin ConsequencesAreas.v <<'E'
/^Lemma Det_D_numbers/,/^Proof/d
E
mutant neighbours-not-unique 'File "./ConsequencesAreas' --pin Statement.v <<'E'
/^Definition Neighbours_statement/,/^$/ s/m_plus F' = m_plus F/m_plus F' = m_plus F'/
E
mutant section-of-two-pieces 'File "./ConsequencesAreas' --pin Statement.v <<'E'
/^Definition S4_section_statement/,/^$/ s/(orbit_at r s n e g <-> lo' < s < hi')/(lo' < s < hi' -> orbit_at r s n e g)/
E
mutant no-periods-left-of-the-area 'File "./ConsequencesAreas' --pin StatementPlane.v <<'E'
/^Definition Joined_statement/,/^$/ s/forall a1, a1 < trace/forall a1, a1s < a1 < trace/
E
mutant edges-one-way 'File "./ConsequencesWords' --pin StatementWords.v <<'E'
/^Definition W5_neighbours_statement/,/^$/ s/(p j < q i <-> member/(p j < q i -> member/
E
mutant any-number-of-orbits 'File "./ConsequencesMaps' --pin StatementOrbits.v <<'E'
s/    forall x', orbit_near M J next n mu d x' -> forall j i, (i < N M)%nat -> x' j i = x j i) \/\\/    True) \/\\/
E
mutant theorem-of-reach-dropped 'Reach_statement of StatementOscillator.v has no theorem' --pin MainOscillators.v <<'E'
/^Theorem Reach :/d
E

mutant kick-merely-Lipschitz 'File "./(ConsequencesMaps|OrbitRemainder)' --pin StatementOrbits.v <<'E'
s/(y - y') \* B M i) <= eps \* t\./(y - y') * B M i) <= 9 * t./
E
mutant orbit-that-meets-the-stop 'File "./ConsequencesNonlinear' --pin StatementNonlinear.v <<'E'
s/^  open_elsewhere : .*/  open_elsewhere : True;/
E
mutant touch-at-any-acceleration 'File "./ConsequencesNonlinear' --pin StatementNonlinear.v <<'E'
s/^  aG : 0 < a O (tG O) 0 0 0;/  aG : 0 <> a O (tG O) 0 0 0;/
E
mutant force-not-C1 'File "./(ConsequencesNonlinear|NonlinearSmooth)' --pin StatementNonlinear.v <<'E'
s/continuous D f3 \/\\ continuous D f4 }/continuous D f4 }/
E
mutant law-of-any-slope 'File "./ConsequencesNonlinear' --pin StatementNonlinear.v <<'E'
s/f3 (tG O) 0 0 0 = - tau O/f3 (tG O) 0 0 0 <= 0/
E
mutant linearized-elsewhere 'File "./(ConsequencesNonlinear|NonlinearSmooth)' --pin StatementNonlinear.v <<'E'
s/: R := f t (y0 O t) (v0 O t) 0\./: R := f t (y0 O t) 0 0./
E
mutant any-number-of-nonlinear-motions 'File "./ConsequencesNonlinear' --pin StatementNonlinear.v <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i : Z, True./
E
mutant headline-without-nonlinear-motions 'File "./Consequences' --pin Headline.v <<'E'
/^  | Moves osc _ => forall N, .*one_nonlinear_motion osc mu d N / { N; s/=> .*/=> True/ }
E
mutant other-stop-anywhere 'File "./ConsequencesStops' --pin StatementStops.v <<'E'
s/~ (t = tG P \/\\ z = s) -> 0 < off P z 0 t/~ t = tG P -> z = s -> 0 < off P z 0 t/
E
mutant touch-from-outside 'File "./ConsequencesStops' --pin StatementStops.v <<'E'
s/^  a_G : 0 < sgn s \* /  a_G : 0 <> sgn s * /
E
mutant stops-not-smooth 'File "./ConsequencesStops' --pin StatementStops.v <<'E'
s/forall z k, (k <= 2)%nat -> C1/forall z k, (k <= 1)%nat -> C1/
E
mutant law-at-rest-only 'File "./ConsequencesStops' --pin StatementStops.v <<'E'
s/^  law_at : 0 <= tau P \/\\ (forall mu t, U P s mu t (Q P s 1 t mu) = Q P s 1 t mu) \/\\/  law_at : 0 <= tau P \/\\/
E
mutant upper-stop-seen-from-above 'File "./(ConsequencesStops|NonlinearStops|NonlinearExamples)' --pin StatementStops.v <<'E'
s/^Definition off .*/Definition off (P : Stops.t) (s : sign) (mu t q : R) : R := q - Q P s 0 t mu./
E
mutant any-number-between-stops 'File "./ConsequencesStops' --pin StatementStops.v <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i : Z, True./
E
mutant chart-that-stays 'File "./ConsequencesBouncing' --pin StatementBouncing.v <<'E'
s/y' = place O c mu + face O c \* y/y' = y/
E
mutant impact-before-the-stop 'File "./ConsequencesBouncing' --pin StatementBouncing.v <<'E'
s/then y0 O c t = 0 \/\\ v0/then v0/
E
mutant mirror-that-keeps-stops 'File "./ConsequencesRattling' --pin StatementRattling.v <<'E'
s/Minus, Plus => Minus | Minus, Minus => Plus/Minus, Plus => Plus | Minus, Minus => Minus/
E
mutant other-stop-in-reach 'File "./ConsequencesRattling' --pin StatementRattling.v <<'E'
s/^  off_the_other : .*/  off_the_other : True;/
E
mutant arc-through-its-stop 'File "./ConsequencesRattling' --pin StatementRattling.v <<'E'
/^  off_its_stop/ { N; s/.*/  off_its_stop : True;/ }
E
mutant velocity-jumps-between-stops 'File "./ConsequencesRattling' --pin StatementRattling.v <<'E'
s/else u' = u\.$/else u' = 2 * u./
E
mutant any-number-of-rattling-motions 'File "./ConsequencesRattling' --pin StatementRattling.v <<'E'
s/^  forall i, t' i = t i .*/  forall i x : R, True./
E
mutant shapes-that-meet 'File "./ConsequencesStops' --pin StatementNonlinearExamples.v <<'E'
s/^  shape_open : .*/  shape_open : True;/
E
mutant duffing-of-smaller-amplitude 'File "./ConsequencesStops' --pin StatementNonlinearExamples.v <<'E'
s/0 < A <= 1 \/ 60 ->/0 < A <= 1 \/ 600 ->/
E
mutant driven-near-no-linear-one 'File "./ConsequencesStops' --pin StatementNonlinearExamples.v <<'E'
s/^    Rabs (a1' - a1) <= eps/    True/
E

# The readers of certificates: what they say, and what they decide.
mutant reader-says-nothing 'File "./ConsequencesReaders' --pin StatementReaders.v <<'E'
s/^    says n s t) \/\\/    True) \/\\/
E
mutant reader-of-a-part 'File "./ConsequencesReaders' --pin StatementReaderWords.v <<'E'
s/  forall n, member a1 a2 Plus n -> In n (map fst (vertices K w))/  forall n, member a1 a2 Plus n -> (n <= j)%nat/
E
mutant reader-with-a-wrong-edge 'File "./(ConsequencesReaders|ReaderWords)' --pin StatementReaderWords.v <<'E'
s/isS g (timesS (on_N T (fst i + fst j) (fst i))/isS g (timesS (on_N T (fst i + fst j) (fst j))/
E
mutant reader-with-a-wrong-cosine 'File "./(ConsequencesReaders|ReaderCircle)' --pin StatementReaders.v <<'E'
s/Z.odd ((floorZ (2 \* n) h + 1) \/ 2)/Z.odd (floorZ (2 * n) h \/ 2)/
E
mutant path-without-the-law-of-impact 'File "./(Consequences(Readers|Ranges)|Paths|Motions)' --pin StatementPaths.v <<'E'
s/= - Machine.tau M \* (v i (t j) - g1 M (t j)) }/= v j (t j) - g1 M (t j) }/
E
mutant range-of-any-strengths 'File "./ConsequencesRanges' --pin StatementRanges.v <<'E'
s/  in_interval (Edge.strengths e) s \/\\ g1 M/  True \/\\ g1 M/
E
mutant range-of-some-motions 'File "./ConsequencesRanges' --pin StatementRanges.v <<'E'
s/^  forall i x, t' i = t i \/\\ y' i x = y i x \/\\ v' i x = v i x\./  True./
E
mutant range-of-cells-apart 'File "./ConsequencesRanges' --pin StatementRanges.v <<'E'
s/  let cell K := In K (Range.cells C) \/\\/  let cell K := nth_error (Range.cells C) 0 = Some K \/\\/
E
mutant range-reader-without-a-neighbour 'File "./RangesSteps' '' RangesCheck.v <<'E'
s/(times (size (later x y)) (weight_of (to y)))/zero/
E
mutant range-reader-without-links 'File "./RangesLinks' '' RangesCheck.v <<'E'
s/if match L with \[\] => true | K' :: _ => links X D K K' end then/if true then/
E
mutant range-reader-of-all-parts-but-the-first 'File "./RangesChecked' '' RangesCheck.v <<'E'
s/| S k => Some (l, l + w)%Z :: pieces k/| S k => pieces k/
E
mutant range-reader-with-a-hole-in-a-range 'File "./RangesChecked' '' RangesCheck.v <<'E'
s/:: pieces k (l + w)%Z w h/:: pieces k (l + 2 * w)%Z w h/
E
mutant range-gap-that-may-turn-after-an-open-piece 'File "./RangesGaps' '' RangesCheck.v <<'E'
s/^    Some false else$/    Some true else/
E
mutant range-gap-convex-at-any-slope 'File "./RangesGaps' '' RangesCheck.v <<'E'
s/  if b && positive (bend_of t x) then/  if positive (bend_of t x) then/
E
mutant range-gap-whose-pieces-need-not-meet 'File "./RangesGaps' '' RangesCheck.v <<'E'
s/    if (h <=? z)%Z then true else/    if (l <=? z)%Z then true else/
E
mutant range-gap-with-the-first-velocity-of-the-middle 'File "./RangesChecked' '' RangesCheck.v <<'E'
s/then \[all_a (snd x)\] else \[\]) fl)\./then [mid_a (snd x)] else []) fl)./
E
mutant three-periods-at-any-speed 'File "./Consequences' --pin StatementChaos.v <<'E'
s/169 \/ 10 \* mu <= v i (t i)/0 * mu <= v i (t i)/
E

# How fast words grow.
mutant words-of-a-graph-without-a-bound 'File "./ConsequencesNumbers' --pin StatementGraphs.v <<'E'
s/  at_most (finite N p E) (- ln z) \/\\ at_least/  True \/\\ at_least/
E
mutant supremum-of-one-K 'File "./ConsequencesNumbers' --pin StatementSuprema.v <<'E'
s/forall a1 a2 K, first_upper a1 a2 K -> below/forall a1 a2 K, (K <= 5)%nat -> first_upper a1 a2 K -> below/
E
mutant supremum-attained 'File "./ConsequencesNumbers' --pin StatementSuprema.v <<'E'
s/exists h', h' < h \/\\/exists h', h' <= h \/\\/
E
mutant supremum-not-approached 'File "./ConsequencesNumbers' --pin StatementSuprema.v <<'E'
s/forall h', h' < h -> exists a1 K/forall h', h' < h \/ 2 -> exists a1 K/
E

# Beyond a touch in region 2: weaker, and a consequence notices; too strong, and a proof does.
mutant attractor-for-l1-above-4/5 'File "./ConsequencesAttractor' --pin StatementAttractor.v <<'E'
/^Definition Wedge_statement/ s/2 \/ 3 < l1 < 1/4 \/ 5 < l1 < 1/
E
mutant attractor-that-grows-too-fast 'File "./Attractor.v' --pin StatementAttractor.v <<'E'
s/1 < E < l1 \/ (2 \* (1 - l1)) ->/1 < E < l1 \/ (1 - l1) ->/
E
mutant attractor-in-a-narrow-cone 'File "./(Consequences)?Attractor' --pin StatementAttractor.v <<'E'
s/<= 2 \* l2 \/ (l1 - l2) \* Rabs (change v)/<= l2 \/ (l1 - l2) * Rabs (change v)/
E
mutant gaps-of-a-half 'File "./ConsequencesAttractor' --pin StatementAttractor.v <<'E'
s/g1 <= g2 < 3 \/ 4 ->/g1 <= g2 < 13 \/ 20 ->/
E
mutant gaps-into-the-windows 'File "./AttractorGaps' --pin StatementAttractor.v <<'E'
s/g1 <= g2 < 3 \/ 4 ->/g1 <= g2 < 4 \/ 5 ->/
E
mutant windows-of-a-half 'File "./ConsequencesAttractor' --pin StatementAttractor.v <<'E'
s/g1 <= g2 < (1 - l1) \/ l1 ^ 2/g1 <= g2 < 1/
E
mutant windows-into-the-gaps 'File "./AttractorWindows' --pin StatementAttractor.v <<'E'
s/  3 \/ 4 < g1 -> g1 <= g2 < (1/  2 \/ 3 < g1 -> g1 <= g2 < (1/
E
mutant trapped-at-half-the-speed 'File "./Trapped' --pin StatementTrapped.v <<'E'
s/sqrt (2 \* alM \* deep)/sqrt (alM * deep \/ 2)/
E
mutant trapped-without-a-bend 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/al0 M <= - Q2 M t <= al1 M/- Q2 M t <= al1 M/
E
mutant trapped-at-any-width 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/^  narrow : W M < p M;/  narrow : W M <= p M;/
E
mutant stable-motions-of-one-contact 'File "./ConsequencesAttractor' --pin StatementTrapped.v <<'E'
s/forall K P N t V x v, (1 <= K)%nat ->/forall K P N t V x v, (2 <= K)%nat ->/
E
mutant stable-motions-without-a-bounce 'File "./TrappedAll' --pin StatementTrapped.v <<'E'
/^Definition No_stable_statement/ s/chaotic M lo hi E -> 0 < tau M ->/chaotic M lo hi E -> 0 <= tau M ->/
E
mutant derivative-of-half-a-jump 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/  Rabs (W t - U t - (- tau M \* w + jump M t V \* d \/ V)) <=/  Rabs (W t - U t - (- tau M * w + jump M t V * d \/ (2 * V))) <=/
E
mutant derivative-at-a-graze 'File "./(Consequences|TrappedDerivative)' --pin StatementTrapped.v <<'E'
s/  V = v t - Q1 M t -> V < 0 -> forall eps/  V = v t - Q1 M t -> forall eps/
E
mutant trapped-with-half-the-slip 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/^Definition least_slip : R := mu M/Definition least_slip : R := mu M \/ 2/
E
mutant trapped-with-any-slip 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/opens_before : 0 < alb M \/\\ least_slip M <= zm M/opens_before : 0 < alb M/
E
mutant trapped-from-anywhere 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/opens M lo hi -> begins M z -> Q M s <= 0 ->/opens M lo hi -> Q M s <= 0 ->/
E
mutant trapped-from-below 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/opens M lo hi -> begins M z -> Q M s <= 0 ->/opens M lo hi -> begins M z ->/
E
mutant few-grazes-from-the-stop 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/  Q M s <= 0 <= q -> Q M s < q -> few_graze/  Q M s <= 0 <= q -> few_graze/
E
mutant few-motions 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/^  (exists i, V i = 0) -> exists n, u s = f n\./  exists n, u s = f n./
E
mutant brief-after-the-pass 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/is_low : let T := p M \* IZR m - W M in/is_low : let T := p M * IZR m + W M in/
E
mutant attractor-from-anywhere 'File "./(Consequences|TrappedAttracts)' --pin Headline.v <<'E'
s/chaotic M lo hi E -> begins M starts -> attracts/chaotic M lo hi E -> attracts/
E
mutant attractor-at-a-graze 'File "./(Consequences|TrappedAttracts)' --pin Headline.v <<'E'
s/^  D_stretches : \(.*\), trapped M t V -> V < 0 ->/  D_stretches : \1, trapped M t V ->/
E
mutant attractor-without-a-bounce 'File "./(Consequences|TrappedAttracts)' --pin Headline.v <<'E'
s/^  D_unstable : 0 < tau M ->/  D_unstable :/
E
mutant attractor-in-any-order 'File "./(Consequences|TrappedAttracts)' --pin Headline.v <<'E'
s/let s := t' (S i) in t (S i) <= s -> 0 <= x' i s - x i s ->/let s := t' (S i) in t (S i) <= s ->/
E
mutant attractor-of-half 'File "./(Consequences|TrappedAttracts)' --pin Headline.v <<'E'
s/0 <= tau -> 2 \/ 3 < exp/0 <= tau -> 1 \/ 2 < exp/
E
mutant exponent-but-for-the-first-pass 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/forall n, (1 <= n <= m)%Z -> stretches M (exp/forall n, (2 <= n <= m)%Z -> stretches M (exp/
E
mutant checked-but-for-the-first-pass 'File "./(Consequences|TrappedRange)' --pin StatementTrapped.v <<'E'
s/first_ones : forall n, (1 <= n < m)%Z/first_ones : forall n, (2 <= n < m)%Z/
E
mutant worse-but-for-its-width 'File "./(Consequences|TrappedRange)' --pin StatementTrapped.v <<'E'
s/  more_W : W M <= W L;/  more_W : W M <= W L + 1;/
E
mutant example-that-grows-too-fast 'File "./(Consequences|Trapped)' --pin StatementTrapped.v <<'E'
s/(acos (\/ (1 + mu))) (201 \/ 200)\./(acos (\/ (1 + mu))) (203 \/ 200)./
E
mutant example-of-small-mu 'File "./ConsequencesAttractor' --pin StatementTrapped.v <<'E'
/^Definition Example_statement/ s/0 < mu <= 1 \/ 10/0 < mu <= 1 \/ 11/
E
mutant unstable-for-large-kicks 'File "./ConsequencesAttractor' --pin StatementUnstable.v <<'E'
s/kappa > 0 -> exists d/kappa > 1 -> exists d/
E
mutant unstable-without-a-kick 'File "./OrbitsUnstable' --pin StatementUnstable.v <<'E'
s/Rabs (crossing M (n j)) >= kappa/Rabs (crossing M (n j)) >= 0/
E
mutant unstable-without-end 'File "./(Consequences|OrbitsUnstable)' --pin StatementUnstable.v <<'E'
s/finite J ->$/True ->/
E
mutant unstable-by-what-is-no-motion 'File "./ConsequencesHeadline' --pin StatementUnstable.v <<'E'
s/(forall i, (j <= i < l)%Z -> leg/(forall i, (j < i < l)%Z -> leg/
E
mutant eigenvalue-of-half-the-speed 'File "./ConsequencesAttractor' --pin StatementUnstable.v <<'E'
s/Rabs (lambda j \* (2 \* y) + crossing/Rabs (lambda j * y + crossing/
E
mutant eigenvalue-by-a-rough-derivative 'File "./ConsequencesAttractor' --pin StatementUnstable.v <<'E'
s/: Prop := forall eps, eps > 0 ->$/: Prop := forall eps, eps > 1 ->/
E
mutant eigenvalue-without-a-kick 'File "./OrbitsEigenvalue' --pin StatementUnstable.v <<'E'
/^Definition Eigenvalue_statement/,$ s/Rabs (crossing M (n j)) >= kappa/Rabs (crossing M (n j)) >= 0/
E
mutant eigenvector-anywhere 'File "./ConsequencesAttractor' --pin StatementUnstable.v <<'E'
s/forall j, within (Map.N M) eps (minus (V j) (Map.B M)) \/\\$/forall j, True \/\\/
E
mutant resonance-of-any-angle 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/^  res_angle : .*/  res_angle : True }./
E
mutant resonance-with-an-arc-of-another-height 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/^  (1 + Oscillator.tau O) \/ (1 + Oscillator.tau O/  (1 - Oscillator.tau O) \/ (1 + Oscillator.tau O/
E
mutant resonance-without-its-exceptions 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
/^Definition regular/,/^$/ s/q O n m <> 1 \/\\ Oscillator.tau O \* q O n m <> -1/True/
E
mutant resonance-with-other-multipliers 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/  let a := - Oscillator.tau O \* q O n m in/  let a := Oscillator.tau O * q O n m in/
E
mutant resonance-stable-without-a-bounce 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
/^Definition Stable_statement/,/^$/ s/0 < Oscillator.tau O -> //
E
mutant resonance-born-at-any-angle 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/(n = 1%nat \\\/ m mod (2 \* n) = 1)%nat/(1 <= n)%nat/
E
mutant resonance-of-maps-at-every-angle 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/^  ((2 <= m)%nat \\\/ gamma < 0 -> forall mu x/  (forall mu x/
E
mutant resonance-curve-of-another-slope 'File "./(Consequences)?Resonance' --pin StatementResonance.v <<'E'
s/Rabs (mu + across M V n/Rabs (mu - across M V n/
E
mutant one-impact-of-another-gap 'File "./(Consequences)?(OneImpact|Systems)' --pin StatementOneImpact.v <<'E'
s/    - (1 + Oscillator.tau O) \* V/    - (1 - Oscillator.tau O) * V/
E
mutant one-impact-that-does-not-come-again 'File "./(Consequences)?(OneImpact|Systems)' --pin StatementOneImpact.v <<'E'
s/^  again_velocity : .*/  again_velocity : True }./
E
mutant one-impact-at-another-phase 'File "./(Consequences)?(OneImpact|Systems)' --pin StatementOneImpact.v <<'E'
s/^  again_phase : .*/  again_phase : t i < t (i + 1)%Z;/
E
mutant one-impact-without-the-sign-of-c 'File "./(Consequences)?(OneImpact|Systems)' --pin StatementOneImpact.v <<'E'
s/u a1 a2 n <> 0 -> c a1 a2 n <> 0 ->$/u a1 a2 n <> 0 ->/
E
mutant one-impact-of-a-negative-restitution 'File "./(Consequences)?(OneImpact|Systems)' --pin StatementOneImpact.v <<'E'
s/a1 a2 gamma -> 0 <= Oscillator.tau O ->$/a1 a2 gamma ->/
E
mutant multipliers-of-the-other-sign 'File "./(ConsequencesMultipliers|ResonanceMultipliers)' --pin StatementMultipliers.v <<'E'
s/Rabs (det_less N D + rate \* K/Rabs (det_less N D - rate * K/
E
mutant multipliers-at-any-slope 'File "./(ConsequencesMultipliers|ResonanceMultipliers)' --pin StatementMultipliers.v <<'E'
s/second_order M w V rate n Qh Q -> across M V n = 0 ->/second_order M w V rate n Qh Q ->/
E
mutant multipliers-without-a-second-order 'File "./(ConsequencesMultipliers|ResonanceMultipliers)' --pin StatementMultipliers.v <<'E'
s/^  second_order M w V rate n Qh Q -> across/  across/
E
mutant multipliers-of-any-derivatives 'File "./(ConsequencesMultipliers|ResonanceMultipliers)' --pin StatementMultipliers.v <<'E'
s/^  flight_slopes M n mu y (x tt) c q P -> let D/  let D/
E
mutant multipliers-of-the-plane-alone 'File "./ConsequencesMultipliers' --pin StatementMultipliers.v <<'E'
s/smooth M -> let N := Map.N M in$/smooth M -> Map.N M = 2%nat -> let N := Map.N M in/
E
mutant determinant-without-signs 'File "./ConsequencesMultipliers' --pin StatementMultipliers.v <<'E'
s/dot N (fun j => (-1) ^ j \* det n/dot N (fun j => det n/
E
mutant multipliers-real-above-two 'File "./(ConsequencesMultipliers|ResonanceMultipliers)' --pin StatementMultipliers.v <<'E'
s/exists lambda v, 1 < lambda/exists lambda v, 2 < lambda/
E
mutant fold-at-another-speed 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/let s := - (nu \* S) \/ (2 \* K) in/let s := - (nu * S) \/ K in/
E
mutant fold-of-any-slope 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/^  mixed_order F w V rate n ph Qh p Q -> across M V n = 0 ->/  mixed_order F w V rate n ph Qh p Q ->/
E
mutant fold-without-a-second-order 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/^  mixed_order F w V rate n ph Qh p Q -> across/  across/
E
mutant fold-of-what-meets-before 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/ -> (forall k, (0 < k < n)%nat -> 0 < across M V k) ->$/ ->/
E
mutant fold-of-a-family-that-grazes-elsewhere 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/^    Family.h F nu x 0 = 0 \/\\/    True \/\\/
E
mutant fold-of-a-rough-family 'File "./(ConsequencesMultipliers|ResonanceFamily)' --pin StatementFold.v <<'E'
s/^  family_smooth : .*/  family_smooth : smooth (member F 0);/
E

# The reader of attractors.
mutant trap-of-any-machines 'File "./(ConsequencesTraps|TrapsChecked)' --pin StatementTraps.v <<'E'
s/^  trap_nu : 0 < Machine.nu M <= Q2R (Trap.depth C);/  trap_nu : 0 < Machine.nu M;/
E
mutant trap-above-a-wall-with-any-top 'File "./(ConsequencesTraps|TrapsChecked)' --pin StatementTraps.v <<'E'
s/^  trap_level : g1 M 0 = 0 }\./  trap_level : True }./
E
mutant trap-with-an-exponent-at-any-depth 'File "./(ConsequencesTraps|TrapsChecked)' --pin StatementTraps.v <<'E'
s/Q2R nu <= mu T ->/True ->/
E
mutant trap-reader-without-starts 'File "./TrapsChecked' '' TrapsCheck.v <<'E'
s/ && starts I//
E
mutant trap-reader-without-exponents 'File "./TrapsChecked' '' TrapsCheck.v <<'E'
s/ && exponent_is I\././
E
mutant trap-reader-of-any-returns 'File "./TrapsNumbers' '' TrapsCheck.v <<'E'
s/^  positive (minus unit (plus (restI T).*/  true \&\&/
E
mutant trap-reader-without-the-slip 'File "./TrapsNumbers' '' TrapsCheck.v <<'E'
s/positive (ellI 1) && slip_holds &&/positive (ellI 1) \&\&/
E
mutant trap-reader-with-rates-in-the-middle 'File "./TrapsNumbers' '' TrapsCheck.v <<'E'
s/^Definition reachI (T : itv) : itv := let x := high (aI I)/Definition reachI (T : itv) : itv := let x := low (aI I)/
E
mutant trap-reader-of-all-returns-but-the-last 'File "./TrapsNumbers' '' TrapsCheck.v <<'E'
s/^  by_B s h (times E w) last\./  true./
E
mutant trap-reader-with-a-window-too-short 'File "./TrapsChecked' '' TrapsCheck.v <<'E'
s/low_at false (fraction (fst (Trap.window X))) && low_at true h'/low_at false (fraction (fst (Trap.window X)))/
E
mutant trap-reader-with-a-sine-too-great 'File "./TrapsChecked' '' TrapsCheck.v <<'E'
s/times Y (step 6 (step 20 (step 42 X)))/times Y (step 7 (step 20 (step 42 X)))/
E

if [ "$survived" ]; then echo "mutants.sh: not refused:$survived" >&2; exit 1; fi
echo "all $total mutants refused"
