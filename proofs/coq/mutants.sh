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

# mutant NAME REASON OPTION FILE: the edit is a sed script on stdin, or, after the word "append" or "new", text.
mutant() {
  name=$1 reason=$2 option=$3 file=$4
  edit=$(cat)
  case "$chosen" in "  " | *" $name "*) ;; *) return 0 ;; esac
  total=$((total + 1))
  rm -rf "$work/mutant"
  cp -a "$work/original" "$work/mutant"
  cd "$work/mutant"
  case "$edit" in
    append*) printf '%s\n' "$edit" | sed 1d >>"$file" ;;
    new*) printf '%s\n' "$edit" | sed 1d >"$file" ;;
    *) sed -i "$edit" "$file" ;;
  esac
  if cmp -s "$file" "$work/original/$file"; then echo "mutants.sh: $name changes nothing" >&2; exit 1; fi
  if sh check.sh $option >"$work/output" 2>&1; then
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

# What is stated. With --pin the texts are taken as they are: the hand-worked numbers must notice.
mutant notation-of-its-own 'must not depend on notations' --pin Statement.v <<'E'
s/^Open Scope R_scope\.$/&\nLocal Notation "x > y" := (x >= y) (at level 70, only parsing) : R_scope./
E
mutant sections-weakened 'statements.txt and what was found differ' '' Statement.v <<'E'
/S4_section_statement/,/^$/ s/0 < r < 1 ->/1 \/ 2 < r < 1 ->/
E
mutant orbit-not-strict 'Consequences|OrbitZ|Error' --pin Defs.v <<'E'
s/sgn emu \* b a1 a2 n k > 0/sgn emu * b a1 a2 n k >= 0/
E
mutant period-2-for-small-a2 'Consequences.v' --pin StatementPlane.v <<'E'
s/^Definition Period2_statement : Prop := forall a1 a2 e g, 0 < a2 ->/Definition Period2_statement : Prop := forall a1 a2 e g, 0 < a2 <= 3 ->/
E
mutant double-zero-for-small-k 'Consequences.v' --pin StatementB.v <<'E'
/B_double_zero_statement/,/^$/ s/(1 <= k <= n - 1)%nat/(1 <= k <= 2)%nat/
E
mutant outside-dropped 'Consequences.v' --pin Statement.v <<'E'
s/(outside n s -> u_at 1 s n <> 0 -> no_orbit_at 1 s n)\./True./
E
mutant area-without-its-graph 'Consequences.v' --pin StatementConjecture.v <<'E'
s/^  above n k g lo hi Rad \/\\ tends_to_1 Rad lo hi lo/  tends_to_1 Rad lo hi lo/
E
mutant chaos-in-no-box 'Consequences.v' --pin StatementChaos.v <<'E'
s/615 \/ 1000 \* mu <= v i (t i)/0 <= v i (t i)/
E
mutant theorem-dropped 'assumptions.txt and what was found differ' '' Main.v <<'E'
/^Theorem S4 :/d
E
mutant theorem-dropped-and-pinned 'S4_statement has no theorem' --pin Main.v <<'E'
/^Theorem S4 :/d
E

if [ "$survived" ]; then echo "mutants.sh: not refused:$survived" >&2; exit 1; fi
echo "all $total mutants refused"
