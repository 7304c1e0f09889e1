#!/bin/sh
# Weakens what is stated, one clause at a time: some file Consequences*.v must then no longer compile. Each conjunct
# of the statement files that is no hypothesis and each field of a record (conjuncts.awk) becomes "True or" what it
# was; what else is lost or narrowed stands below. Run check.sh first. Arguments: statement files, and before them
# perhaps "others" for what stands below alone; without, all of them. Only what is compiled from the one that is
# changed is compiled again, without proofs, and then the consequences with theirs, first the one that noticed last.
set -eu
export LC_ALL=C OCAMLRUNPARAM=s=2M,o=400
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
total=0 survived=0 last=
cp -a "$here/." "$work/tree"
cd "$work/tree"
others=; [ "${1-}" != others ] || { others=yes; shift; }
chosen=${*:-Defs.v Headline.v $(echo Statement*.v)}

# A line for each file: its name and those that it requires, in an order in which they can be compiled.
coqdep -Q . Grazing *.v 2>/dev/null | sed -nE 's/^([A-Za-z0-9]+)\.vo .*: /\1 /p' | sed -E 's/([A-Za-z0-9]+)\.vo?/\1/g' |
  awk '
    { file[NR] = $1; for (i = 3; i <= NF; i++) if ($i != $1) need[$1] = need[$1] " " $i }
    function visit(f,  i, n, all) { if (f in seen) return; seen[f]; n = split(need[f], all, " "); for (i = 1; i <= n; i++) visit(all[i]); print f need[f] }
    END { for (i = 1; i <= NR; i++) visit(file[i]) }' >"$work/needs"
# What is compiled from $1 and is needed by $2, in order.
between() {
  awk -v from="$1" -v upto="$2" '
    { file[NR] = $1; for (i = 2; i <= NF; i++) { if ($i == from || $i in after) after[$1]; need[$1, i] = $i }; n[$1] = NF }
    function mark(f,  i) { if (f in wanted) return; wanted[f]; for (i = 2; i <= n[f]; i++) mark(need[f, i]) }
    END { mark(upto); for (i = 1; i <= NR; i++) if (file[i] in wanted && file[i] in after && file[i] != upto) print file[i] }' "$work/needs"
}
# A line for each sentence of the statement files: what it defines, and all words in it.
for file in Defs.v Headline.v Statement*.v; do
  sed -E 's/\(\*([^*]|\*+[^*)])*\*+\)//g' "$file" | awk '{ text = text " " $0 } END { print text }' | sed -E 's/\(\*([^*]|\*+[^*)])*\*+\)//g; s/\.( |$)/\n/g'
done | sed -nE "s/[^A-Za-z0-9_']+/ /g; s/^ *(Module [A-Za-z]+ )?(Definition|Fixpoint|Inductive|Record) /&/p" >"$work/sentences"
# The consequences that mention what $1 defines, or what is defined with it: $2 is the name of a definition.
mentioned() {
  awk -v name="$2" '
    { line[NR] = $0; for (i = 1; i <= NF && $i !~ /^(Definition|Fixpoint|Inductive|Record)$/; i++); def[NR] = $(i + 1); kind[NR] = $i }
    END {
      hit[name]; more = 1
      while (more) {
        more = 0
        for (i = 1; i <= NR; i++) {
          n = split(line[i], word, " "); found = 0
          for (j = 1; j <= n; j++) if (word[j] in hit) found = 1
          if (!found) continue
          if (kind[i] ~ /Record|Inductive/) { for (j = 1; j <= n; j++) if (length(word[j]) > 3 && !(word[j] in hit) && word[j] !~ /^(forall|exists|sign|Prop|Type|list|cons|Definition|Record|Inductive|Module)$/) { hit[word[j]]; more = 1 } }
          else if (!(def[i] in hit)) { hit[def[i]]; more = 1 }
        }
      }
      for (word_ in hit) print word_
    }' "$work/sentences" >"$work/names"
  awk -v from="$1" '{ for (i = 2; i <= NF; i++) if ($i == from || $i in after) after[$1] } END { for (f in after) if (f ~ /^Consequences/) print f ".v" }' "$work/needs" |
    xargs grep -lwFf "$work/names" | sed 's/\.v$//' | sort |
    awk -v last="$last" '$0 == last { print; next } { rest = rest $0 "\n" } END { printf "%s", rest }'
}

# The statement file $1 has been changed, in the definition $2, as $3 says: some consequence must fail.
try() {
  total=$((total + 1)) compiled= noticed=
  if ! coqc -q -w none -vos -Q . Grazing "$1" >"$work/output" 2>&1; then
    echo "clauses.sh: $1 does not compile: $2: $3" >&2; cat "$work/output" >&2; exit 1
  else
    for consequence in $(mentioned "${1%.v}" "$2"); do
      for file in $(between "${1%.v}" "$consequence"); do
        case " $compiled " in *" $file "*) continue ;; esac
        # A definition in a file of proofs may need what is lost; that notices it, too.
        coqc -q -w none -vos -Q . Grazing "$file.v" >"$work/output" 2>&1 || { noticed=yes; break; }
        compiled="$compiled $file"
      done
      [ ! "$noticed" ] || break
      if ! coqc -q -w none -vok -Q . Grazing "$consequence.v" >"$work/output" 2>&1; then
        grep -q "^File \"./$consequence.v\"" "$work/output" || { cat "$work/output"; exit 1; }
        noticed=yes last=$consequence; break
      fi
    done
  fi
  [ "$noticed" ] || { survived=$((survived + 1)); echo "$1: UNNOTICED: $2: $3"; }
  cp -p "$here/$1" "$1"
  for file in "${1%.v}" $compiled; do cp -p "$here/$file.vos" "$file.vos"; done
}
# other FILE DEFINITION WHAT: a sed script on stdin.
other() {
  edit=$(cat)
  case " $(echo $chosen) " in *" $1 "*) ;; *) return 0 ;; esac
  sed -i "$edit" "$1"
  if cmp -s "$1" "$here/$1"; then echo "clauses.sh: $2: $3: nothing changes" >&2; exit 1; fi
  try "$1" "$2" "$3"
}

for said in $chosen; do
  [ ! "$others" ] || break
  awk -f conjuncts.awk "$said" >"$work/conjuncts"
  while read -r at length name text; do
    { head -c $((at - 1)) "$here/$said"; printf '(True \\/ ('; tail -c +"$at" "$here/$said" | head -c "$length"; printf '))'
      tail -c +$((at + length)) "$here/$said"; } >"$said"
    try "$said" "$name" "$text" </dev/null
  done <"$work/conjuncts"
done

# ---- Headline.v: quantifiers in another order, one neighbourhood for another, half a domain ----
other Headline.v e_mu 'mu for e mu in maps' <<'E'
s/Steps _ rate _ => rate \* mu end/Steps _ rate _ => mu end/
E
other Headline.v e_mu 'mu for e mu in nonlinear oscillators' <<'E'
s/Moves _ rate | Bounces/Moves _ _ => mu | Bounces/
E
other Headline.v e_mu 'mu for e mu with other impacts' <<'E'
s/ Bounces _ rate | Steps/ Steps/; s/  match S with Oscillates _ _ => mu | Moves/  match S with Oscillates _ _ | Bounces _ _ => mu | Moves/
E
other Headline.v one 'of motions, some N' <<'E'
s/=> forall N, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z -> one_motion osc m mu d N/=> exists N, (forall i, N (i + 1) = N i + Z.of_nat (n i))%Z \/\\ one_motion osc m mu d N/
E
other Headline.v one 'of motions, nothing' <<'E'
/^  | Oscillates osc m => forall N, .*one_motion osc m mu d N / { N; s/=> .*/=> True/ }
E
other Headline.v one 'of nonlinear motions, nothing' <<'E'
/^  | Moves osc _ => forall N, .*one_nonlinear_motion osc mu d N / { N; s/=> .*/=> True/ }
E
other Headline.v one 'with other impacts, nothing' <<'E'
/^  | Bounces osc _ => forall N, .*one_bouncing_motion osc mu d N / { N; s/=> .*/=> True/ }
E
other Headline.v one 'of maps, some orbit' <<'E'
s/  | Steps M _ _ => one_orbit M Z (fun i => i + 1)%Z n mu d /  | Steps M _ _ => (exists x, orbit_near M Z (fun i => i + 1)%Z n mu d x) /
E
other Headline.v none 'of motions, nothing' <<'E'
/^  | Oscillates osc m => forall N t y v, / { N; s/=> .*/=> True/ }
E
other Headline.v none 'of nonlinear motions, nothing' <<'E'
/^  | Moves osc _ => forall N t y v, / { N; s/=> .*/=> True/ }
E
other Headline.v none 'with other impacts, nothing' <<'E'
/^  | Bounces osc _ => forall N t y v, / { N; s/=> .*/=> True/ }
E
other Headline.v none 'of maps, nothing' <<'E'
s/^  | Steps M _ _ => forall x, ~ .* end\./  | Steps M _ _ => True end./
E
other Headline.v Theorem_1_statement 'a mu0 for each word' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/exists mu0, mu0 > 0 \/\\ forall (n : Z -> nat) e g mu,/forall (n : Z -> nat) e g, exists mu0, mu0 > 0 \/\\ forall mu,/
E
other Headline.v Theorem_1_statement 'motions in d in place of every eps' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/one S mu eps n/one S mu d n/
E
other Headline.v Theorem_1_statement 'none in eps alone' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/none S mu d n/none S mu eps n/
E
other Headline.v Theorem_1_statement 'without the letter 2' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/(1 <= n i <= n_max)%nat/(n i <= 1)%nat \/\\ &/
E
other Headline.v Theorem_1_statement 'none where all fail' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/((exists i, breaks a1 a2 e g/((forall i, breaks a1 a2 e g/
E
other Headline.v Theorem_1_statement 'only gamma > 0' <<'E'
/^Definition Theorem_1_statement/,/^$/ s/sgn g \* gamma > 0 ->/gamma > 0 -> &/
E
other Headline.v born 'in d in place of every eps' <<'E'
/^Definition born/,+1 s/one S mu eps/one S mu d/
E
other Headline.v born 'a mu0 for each mu' <<'E'
/^Definition born/,+1 s/exists mu0, mu0 > 0 \/\\ forall mu, 0/forall mu, exists mu0, mu0 > 0 \/\\ 0/
E
other Headline.v unborn 'd depends on mu' <<'E'
/^Definition unborn/,+1 { s/exists d mu0, d > 0 \/\\ mu0 > 0/exists mu0, mu0 > 0/; s/-> none S mu d/-> exists d, d > 0 \/\\ none S mu d/ }
E
other Headline.v unborn 'mu0 depends on mu' <<'E'
/^Definition unborn/,+1 { s/exists d mu0, d > 0 \/\\ mu0 > 0 \/\\/exists d, d > 0 \/\\/; s/forall mu, 0 </forall mu, exists mu0, mu0 > 0 \/\\ (0 </; s/(fun _ => n)\./(fun _ => n))./ }
E
other Headline.v exactly 'of maps alone' <<'E'
/^Definition exactly/ s/grazes S a1 a2 gamma ->/match S with Steps _ _ _ => True | _ => False end -> &/
E
other Headline.v exactly 'not of nonlinear oscillators' <<'E'
/^Definition exactly/ s/grazes S a1 a2 gamma ->/match S with Moves _ _ => False | _ => True end -> &/
E
other Headline.v exactly 'not with other impacts' <<'E'
/^Definition exactly/ s/grazes S a1 a2 gamma ->/match S with Bounces _ _ => False | _ => True end -> &/
E
other Headline.v exactly 'of one gamma' <<'E'
/^Definition exactly/ s/grazes S a1 a2 gamma ->/sgn g * gamma > 0 -> &/
E
other Headline.v never 'of maps alone' <<'E'
/^Definition never/ s/grazes S a1 a2 gamma ->/match S with Steps _ _ _ => True | _ => False end -> &/
E
other Headline.v never 'of oscillators alone' <<'E'
/^Definition never/ s/grazes S a1 a2 gamma ->/match S with Steps _ _ _ => False | _ => True end -> &/
E
other Headline.v never 'not of nonlinear oscillators' <<'E'
/^Definition never/ s/grazes S a1 a2 gamma ->/match S with Moves _ _ => False | _ => True end -> &/
E
other Headline.v never 'not with other impacts' <<'E'
/^Definition never/ s/grazes S a1 a2 gamma ->/match S with Bounces _ _ => False | _ => True end -> &/
E
other Headline.v never 'for e mu > 0' <<'E'
/^Definition never/ s/unborn S n e\./match e with Plus => unborn S n e | Minus => True end./
E
other Headline.v Theorem_2_statement 'short periods' <<'E'
/^Definition Theorem_2_statement/,/^$/ s/(3 <= n)%nat/(3 <= n <= 7)%nat/
E
other Headline.v Theorem_2_statement 's < 1/4' <<'E'
/^Definition Theorem_2_statement/,/^$/ s/0 < s < 1 \/ 2 ->/0 < s < 1 \/ 4 ->/
E
other Headline.v area 'boundaries may cross' <<'E'
/^Definition area/,/^Definition/ s/b_at r s n j > 0/b_at r s n j >= 0/
E
other Headline.v area 'r > 1/2' <<'E'
/^Definition area/,/^Definition/ s/forall r, 0 < r <= 1/forall r, 1 \/ 2 < r <= 1/
E
other Headline.v area 'r < 1' <<'E'
/^Definition area/,/^Definition/ s/forall r, 0 < r <= 1/forall r, 0 < r < 1/
E
other Headline.v area 'the graph may reach 1' <<'E'
/^Definition area/,/^Definition/ s/0 <= Rad s < 1/0 <= Rad s <= 1/
E
other Headline.v extends 'circles of r > 1/2' <<'E'
/^Definition extends/,/^Definition/ s/forall r, 0 < r < 1/forall r, 1 \/ 2 < r < 1/
E
other Headline.v ends_left 'boundaries may cross' <<'E'
/^Definition ends_left/,/^$/ s/b a1 a2 n j > 0/b a1 a2 n j >= 0/
E
other Headline.v Conjecture_1_statement 'short periods' <<'E'
/^Definition Conjecture_1_statement/ s/(3 <= n)%nat/(3 <= n <= 7)%nat/
E
other Headline.v Conjecture_1_statement 'first area for r > 1/2' <<'E'
/extends to a (-,+) area/,/extends to a (+,+)/ s/forall r s, 0 < r <= 1/forall r s, 1 \/ 2 < r <= 1/
E
other Headline.v Conjecture_1_statement 'Rad = 0 on less' <<'E'
s/s <= 1 \/ (2 \* (N - 1)) -> Rad s = 0/s < 1 \/ (2 * (N - 1)) -> Rad s = 0/
E
other Headline.v Conjecture_1_statement 'second area met by circles of r > 1/2' <<'E'
s/   forall r, 0 < r < 1 -> exists s', /   forall r, 1 \/ 2 < r < 1 -> exists s', /
E
other Headline.v Conjecture_1_statement 'region 4 for a2 > 1/5' <<'E'
s/forall a2, 0 < a2 < 1 -> ends_left/forall a2, 1 \/ 5 < a2 < 1 -> ends_left/
E
other Headline.v Conjecture_1_statement 'fourth not between neighbours of odd n+' <<'E'
s/m_plus F <> 0%nat ->$/(m_plus F <> 0 \/\\ n_plus F < 3)%nat ->/
E
other Headline.v Conjecture_1_statement 'fifth not at 1\/n' <<'E'
s/(2 \* m_minus F <> n_minus F)%nat ->/(m <> 1)%nat -> &/
E
other Headline.v Conjecture_1_statement 'none elsewhere for r > 1/2' <<'E'
/none_in_3/ s/0 < r < 1/1 \/ 2 < r < 1/
E
other Headline.v Conjecture_1_statement 'none in region 4 for a2 > 1/5' <<'E'
/none_in_4/ s/0 < a2 < 1/1 \/ 5 < a2 < 1/
E
other Headline.v Conjecture_1_statement 'none in region 4 but next to it' <<'E'
s/< a1 <= - 2 \* sqrt a2 -> Nat.Even n/< a1 < - 2 * sqrt a2 -> Nat.Even n/
E
other StatementNonlinear.v leg 'moves between impacts alone' <<'E'
s/  leg_moves : forall x, t i <= x <= t j/  leg_moves : forall x, t i < x < t j/
E
other StatementNonlinear.v one_nonlinear_motion 'one by its times' <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i, t' i = t i./
E
other StatementBouncing.v journey 'moves between impacts alone' <<'E'
s/r m <= x <= r (S m) -> runs O (arc O N i m) mu/r m < x < r (S m) -> runs O (arc O N i m) mu/
E
other StatementBouncing.v one_bouncing_motion 'one by its times' <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i, t' i = t i./
E
other StatementBouncing.v linear_impact 'an impact that is not later' <<'E'
s/z + v \* h = 0/h = 0/
E
other StatementBouncing.v linear_impact 'a change of chart that mu does not move' <<'E'
s/place_mu O c 0 \* m + //
E
other StatementRattling.v ride 'moves between impacts alone' <<'E'
s/  ride_moves : forall m x, (m <= n)%nat -> r m <= x <= r (S m)/  ride_moves : forall m x, (m <= n)%nat -> r m < x < r (S m)/
E
other StatementRattling.v one_rattling_motion 'one by its times' <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i, t' i = t i./
E
other StatementRattling.v passes 'a velocity that jumps between the stops' <<'E'
s/else u' = u\.$/else u' = 2 * u./
E
other StatementNonlinearExamples.v driven 'restitution at any speed' <<'E'
s/ \* exp (x \* (sgn z \* (u - w z 1%nat t))))/)/
E
other StatementNonlinearExamples.v driven_facts 'periods from 4 on' <<'E'
s/(1 <= n)%nat -> orbit/(4 <= n)%nat -> orbit/
E
other StatementStops.v flight 'moves between impacts alone' <<'E'
s/  flight_moves : forall x, t i <= x <= t j/  flight_moves : forall x, t i < x < t j/
E
other StatementStops.v one_between 'one by its times' <<'E'
s/^  forall i, t' i = t i \/\\ forall x, .*/  forall i, t' i = t i./
E
other StatementStops.v Stops_statement 'of one motion alone' <<'E'
/^  ((exists t q u, motion_between/,/^   exists/d
E
other StatementStops.v measured 'that the velocity is taken as it is' <<'E'
s/Nonlinear.v0 := fun t => rel P s 0 t (u0 P t)/Nonlinear.v0 := u0 P/
E
other StatementUnstable.v unstable_motion 'an r for each impact' <<'E'
s/exists r, r > 0 \/\\ forall j eps, eps > 0 ->/forall j, exists r, r > 0 \/\\ forall eps, eps > 0 ->/
E
other StatementUnstable.v unstable_motion 'from some impact on' <<'E'
s/forall j eps, eps > 0 -> exists l/exists j, forall eps, eps > 0 -> exists l/
E
other StatementUnstable.v unstable_motion 'not so near' <<'E'
s/forall j eps, eps > 0 -> exists l/forall j eps, eps > 1 -> exists l/
E
other StatementChaos.v chaos_motion 'a wider window' <<'E'
s/(- mu) (6 \/ 5)/(- mu) (7 \/ 5)/
E
other StatementChaos.v chaos_motion 'another restitution' <<'E'
s/(49 \/ 10) 1)/(49 \/ 10) (1 \/ 2))/
E
other Headline.v Words_statement 'only with damping' <<'E'
/^Definition Words_statement/,/^$/ s/first_upper a1 a2 K ->/a2 < 1 \/ 2 -> &/
E
other Headline.v Words_statement 'words that do not end' <<'E'
s/  (a2 < 1 -> exists w i j, path/  (a2 < 0 -> exists w i j, path/
E
other Headline.v Words_statement 'a mu0 for each word' <<'E'
/^Definition Words_statement/,/^$/ { s/exists mu0, mu0 > 0 \/\\$//; s/^  forall (n : Z -> nat \* letter) g mu,/forall (n : Z -> nat * letter) g, exists mu0, mu0 > 0 \/\\ forall mu,/ }
E
other Headline.v Words_statement 'in d in place of every eps' <<'E'
/^Definition Words_statement/,/^$/ s/one S mu eps/one S mu d/
E
other Headline.v Words_statement 'only gamma > 0' <<'E'
/^Definition Words_statement/,/^$/ s/sgn g \* gamma > 0 ->/gamma > 0 -> &/
E
other Headline.v Chaos_statement 'mu > 1' <<'E'
/^Definition Chaos_statement/,/^$/ s/mu > 0/mu > 1/
E
other Headline.v Chaos_statement 'alternating words' <<'E'
/^Definition Chaos_statement/,/^$/ s/one_or_two N ->/& (N 1 <> N 0 + 2)%Z ->/
E
other StatementResonance.v Birth_statement 'a mu0 for each nu' <<'E'
s/^  exists mu0, 0 < mu0 \/\\ forall nu, 0 < nu < mu0 -> birth O n m nu eps/  forall nu, exists mu0, 0 < mu0 \/\\ (0 < nu < mu0 -> birth O n m nu eps)/
E
other StatementResonance.v birth 'one of those near the touch' <<'E'
s/once O n (- nu) PI t' y' v' ->/once O n (- nu) eps t' y' v' ->/
E
other StatementResonance.v exact_iff 'only from the motion to the arc' <<'E'
s/t 0%Z = t0) <->/t 0%Z = t0) ->/
E
other StatementResonance.v births 'n >= 2 alone' <<'E'
s/(n = 1%nat \\\/ m mod/(m mod/
E
other StatementResonance.v curve_one 'at one small speed' <<'E'
s/^    forall y, 0 < y < r -> exists mu x, Rabs mu <= d/    exists y, 0 < y < r \/\\ exists mu x, Rabs mu <= d/
E
other StatementResonance.v Plane_statement 'only by the sign of gamma' <<'E'
s/^  ((2 <= m)%nat \\\/ gamma < 0 -> forall mu x/  (gamma < 0 -> forall mu x/
E
other StatementFold.v turn_one 'a radius for each nu' <<'E'
s/^  turn_one : exists r, 0 < r \/\\ forall nu y, Rabs nu < r ->/  turn_one : forall nu, exists r, 0 < r \/\\ forall y, Rabs nu < r ->/
E
other StatementOneImpact.v Every_mu_statement 'where b is not 0' <<'E'
s/b a1 a2 n k <= 0 ->$/b a1 a2 n k < 0 ->/
E
other StatementOneImpact.v Gap_statement 'k < n' <<'E'
/^Definition Gap_statement/,/^$/ s/(k <= n)%nat/(k < n)%nat/
E
other StatementMultipliers.v Determinant_statement 'a d for each orbit' <<'E'
s/^  let K := \(.*\) in forall eps, 0 < eps -> exists d, 0 < d \/\\$/  let K := \1 in forall eps, 0 < eps ->/
s/^  forall mu x c q P, Rabs mu <= d ->/  forall mu x c q P, exists d, 0 < d \/\\ (Rabs mu <= d ->/
s/D v i = lambda \* v i)\.$/D v i = lambda * v i))./
E
other StatementTraps.v Traps_statement 'of a longer window' <<'E'
s/traps C M (seen C M (hi - lo)) lo hi/traps C M (seen C M (1 + hi - lo)) lo hi/
E
other StatementTraps.v traps 'an exponent at the listed depth alone' <<'E'
s/Q2R nu <= mu T ->/Q2R nu = mu T ->/
E
other StatementTrapped.v few_graze 'a list for each motion' <<'E'
s/exists f : nat -> R, forall y u N t V x v,/forall y u N t V x v, exists f : nat -> R,/
E
other StatementTrapped.v third 'from a trapped contact alone' <<'E'
s/^  forall t2 V2 y u, leg M t1 V1 t2 V2 y u -> trapped M t2 V2\./  forall t2 V2 y u, leg M t1 V1 t2 V2 y u -> trapped M t V -> trapped M t2 V2./
E
other Headline.v Attractor_statement 'at one mu' <<'E'
s/^  exists E Z S mu1, mu1 > 0 \/\\ forall mu, 0 < mu <= mu1 ->/  exists E Z S mu1, mu1 > 0 \/\\ forall mu, mu = mu1 ->/
E

if [ "$survived" != 0 ]; then echo "clauses.sh: $survived of $total changes not noticed" >&2; exit 1; fi
echo "all $total changes are noticed"
