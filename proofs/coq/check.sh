#!/bin/sh
# Checks what the development says and what it rests on, the cheap first:
#   1. the sources: every file listed, no folders, no options, no files but these; nothing assumed or left open, no
#      check of the kernel turned off, nothing said about extraction; the statement files hold definitions alone and
#      require only Coq and each other, and each statement occurs in a file Consequences*.v; Oracle.v is one list of
#      full names;
#   2. every definition of the statement files, printed in full, is as pinned in statements.txt,
#      and the numbers of Consequences*.v follow from the statements;
#   3. everything compiles;
#   4. each statement, by its full name, has a theorem in a file Main*.v, and these theorems rest on the axioms
#      pinned in assumptions.txt, which names them before each list; so is each function that Oracle.v extracts, with
#      the statements that are about it;
#   5. the kernel checks every compiled file again (coqchk), and its summary is as pinned in coqchk.txt; not so
#      with GRAZING_COQCHK=0 in the environment, as in .ci/run (.ci/full has it).
# --pin writes the three files instead of comparing them; --compiled believes the compiled files that are there, as
# mutants.sh asks, which tests this script: otherwise all of them go first, since a compiled file that is newer than its
# source need not be made from it. Needs coq alone.
set -eu
cd "$(dirname "$0")"
export LC_ALL=C
# Coq's own heap of 256 MB is cleared once for each file: a sixth of the time.
export OCAMLRUNPARAM=s=2M,o=400
unset COQPATH COQLIB COQEXTRAFLAGS COQFLAGS COQLIBS COQCHKEXTRAFLAGS OTHERFLAGS MAKEFLAGS MAKEFILES || true
pin= compiled=
for option in "$@"; do
  case "$option" in --pin) pin=yes ;; --compiled) compiled=yes ;; *) echo "check.sh: $option?" >&2; exit 2 ;; esac
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
refuse() { echo "check.sh: $*" >&2; exit 1; }
compare() { # pinned found
  if [ "$pin" ]; then cp "$2" "$1"; fi
  diff "$1" "$2" || refuse "$1 and what was found differ; if that is meant, check.sh --pin"
}

# 1. The sources. Oracle.v extracts a program and is no part of the development.
[ "$(head -n 1 _CoqProject)" = "-Q . Grazing" ] || refuse "_CoqProject must begin with -Q . Grazing"
if sed 1d _CoqProject | grep -vE '^[A-Za-z0-9]+\.v$' >&2; then refuse "_CoqProject: not the name of a file: above"; fi
if sed 1d _CoqProject | sort | uniq -d | grep . >&2; then refuse "_CoqProject: listed twice: above"; fi
sources=$(sed 1d _CoqProject)
for entry in * .[!.]* ..?*; do
  if [ -L "$entry" ]; then refuse "$entry is a link"; fi
  if [ -d "$entry" ]; then refuse "$entry is a folder"; fi
  case "$entry" in
    '*' | '.[!.]*' | '..?*' | _CoqProject | *.v | *.sh | *.awk | *.ml | *.txt) ;;
    *.vo | *.vos | *.vok | *.glob | .*.aux | .?ia.cache | .nra.cache) ;;
    Makefile.coq | Makefile.coq.conf | .Makefile.coq.d) ;;
    *) refuse "$entry has no place here" ;;
  esac
done
# A makefile can hold options.
rm -f Makefile.coq Makefile.coq.conf .Makefile.coq.d
[ "$compiled" ] || rm -f *.vo *.vos *.vok *.glob .*.aux
for file in *.v; do
  case " $(echo $sources) Oracle.v " in *" $file "*) ;; *) refuse "$file is not listed in _CoqProject" ;; esac
done
# Comments (nested) are taken out and each file becomes one line, so that no line break hides a word. As in Coq, "
# begins and ends a string, in a comment, too, and what looks like a comment in a string is none.
plain() {
  awk -v file="$1" '
    { gsub(/[\t\r\f\v]/, " "); text = text " " $0 }
    END {
      n = length(text); depth = 0; quoted = 0; out = ""
      for (i = 1; i <= n; i++) {
        one = substr(text, i, 1); two = substr(text, i, 2)
        if (one == "\"") quoted = !quoted
        else if (!quoted && two == "(*") { depth++; i++; continue }
        else if (!quoted && two == "*)" && depth > 0) { depth--; i++; out = out " "; continue }
        if (depth == 0) out = out one
      }
      print file ": " out
    }' "$1"
}
for file in $sources Oracle.v; do plain "$file"; done >"$work/plain"
word='(Axioms?|Parameters?|Conjectures?|Admitted|admit|give_up|Admit[ ]+Obligations|bypass_check|Declare[ ]+ML|ML|LoadPath|Redirect|Load|[Uu]nsafe|Extract|[Ee]xtraction|Extr[A-Z][A-Za-z]*)'
if grep -v "^Oracle\.v: " "$work/plain" | grep -oE "^[A-Za-z0-9]+\.v|.{0,40}(^|[^A-Za-z0-9_'])$word([^A-Za-z0-9_'].{0,20}|$)|.{0,20}(Unset|Set)[^.]*(Checking|Impredicative)[^.]*\." |
    awk '/^[A-Za-z0-9]+\.v$/ { file = $0; next } { print file ":" $0; bad = 1 } END { exit !bad }' >&2; then
  refuse "assumed, unproved, unchecked or about extraction: above"
fi
statement_files=$(echo "$sources" | grep -E '^(Defs|Headline|Statement[A-Za-z0-9]*)\.v$')
# One sentence per line; what a statement file may hold. Numbers and names have no dot before a blank.
sentences() { grep "^$1: " "$work/plain" | sed -e "s/^$1: //" | sed -E 's/\.([[:space:]]|$)/.\n/g' | sed -E 's/^[[:space:]]+//' | grep . || true; }
# Files come from Coq's library and from here, each by its name.
for file in $sources; do
  if sentences "$file" | grep -E "(^|[^A-Za-z0-9_'])Require([^A-Za-z0-9_']|$)" |
      grep -vE '^From (Coq|Grazing) Require[ ]+((Import|Export)[ ]+)?[A-Za-z0-9_ ]+\.$' >&2; then
    refuse "$file requires files otherwise than From Coq or From Grazing, by name: above"
  fi
done
for file in $statement_files; do
  if sentences "$file" | grep -vE '^(From Coq Require Import|From Grazing Require Import|Open Scope|Definition|Fixpoint|Inductive|Record|Module|Section|Variables|End)[[:space:]]+[^"]*\.$|^Import (ListNotations|Map|Nonlinear|Bouncing|Rattling|Stops)\.$|^Arguments [a-z_]+ [{}a-z ]+\.$' >&2; then
    refuse "$file: a statement file holds definitions alone; not this: above"
  fi
  for name in $(sentences "$file" | sed -nE 's/^From Grazing Require Import[[:space:]]+(.*)\.$/\1/p'); do
    echo "$statement_files" | grep -qx "$name.v" || refuse "$file requires $name, which is no statement file"
  done
done
for file in $sources; do
  if echo "$statement_files" | grep -qx "$file"; then continue; fi
  if grep "^$file: " "$work/plain" | grep -qE "(Definition|Fixpoint|Inductive|Record|Notation|Let)[[:space:]]+\"?[A-Za-z0-9_]*_statement"; then
    refuse "$file states what belongs into Headline.v or a file Statement*.v"
  fi
done
# Each statement has its numbers.
for file in $statement_files; do
  for name in $(sentences "$file" | sed -nE 's/^Definition[[:space:]]+([A-Za-z0-9_]*_statement[a-z_]*)[[:space:]:].*/\1/p'); do
    grep -E '^Consequences[A-Za-z0-9]*\.v: ' "$work/plain" | grep -qE "(^|[^A-Za-z0-9_'.]|[^A-Za-z0-9_']${file%.v}\.)$name([^A-Za-z0-9_']|$)" ||
      refuse "$name of $file occurs in no Consequences*.v: no numbers follow from it"
  done
done
# Oracle.v is three sentences, and what it extracts has full names.
if [ "$(sentences Oracle.v | sed -E 's/ +/ /g' | sed -E '2s/^(From Grazing Require)( [A-Za-z]+)+\.$/\1 FILES./; 3s/( (Grazing\.[A-Za-z]+\.[A-Za-z_]+|Coq\.ZArith\.BinInt\.Z\.(add|mul|opp|gcd)))+ ?\.$/ NAMES./')" != \
  'From Coq Require Extraction ExtrOcamlBasic ZArith.
From Grazing Require FILES.
Extraction "decide.ml" NAMES.' ]; then
  refuse "Oracle.v must require Coq's extraction, then files from here, and then extract functions by their full names"
fi
extracted=$(sentences Oracle.v | sed 1,2d | grep -oE 'Grazing\.[A-Za-z]+\.[A-Za-z_]+' | sed 's/^Grazing\.//')

# 2. The statements in full.
# Names as defined; those in a module after its name.
defined() {
  sentences "$1" | awk '
    $1 == "Module" { module = $2; sub(/\.$/, "", module); module = module "."; next }
    $1 == "End" { module = ""; next }
    $1 == "Definition" || $1 == "Fixpoint" || $1 == "Inductive" || $1 == "Record" { print module $2 }'
}
coq_makefile -f _CoqProject -o Makefile.coq
jobs=$(nproc 2>/dev/null || echo 1)
make --no-print-directory -f Makefile.coq -j "$jobs" $(for f in $statement_files $(echo "$sources" | grep '^Consequences'); do echo "${f}o"; done)
{
  echo "From Coq Require Import Reals List. Open Scope R_scope. Set Printing Width 110."
  for file in $statement_files; do
    module=${file%.v}
    echo "From Grazing Require $module."
    defined "$file" |
      while read -r name; do echo "Print Grazing.$module.$name."; done
  done
} >"$work/Statements.v"
coqc -q -Q . Grazing "$work/Statements.v" >"$work/statements"
compare statements.txt "$work/statements"

# 3. The proofs.
sh build.sh -j "$jobs"

# 4. The main theorems, and per file the axioms that they rest on together: each walk through the library
# takes Coq a second.
mains=$(echo "$sources" | grep '^Main')
{
  echo "From Coq Require Import Reals List. Open Scope R_scope. Set Printing Width 110."
  for file in $mains; do
    module=${file%.v}
    echo "From Grazing Require $module."
    names=$(sed -nE 's/^Theorem ([A-Za-z0-9_]+).*/\1/p' "$file")
    for name in $names; do echo "Check Grazing.$module.$name."; done
    echo "Definition all_of_$module := (I$(for name in $names; do echo ", Grazing.$module.$name"; done))."
    echo "Print Assumptions all_of_$module."
  done
} >"$work/Theorems.v"
coqc -q -Q . Grazing "$work/Theorems.v" >"$work/assumptions"
# A function that is extracted stands in a statement, by its full name, and the statement among the theorems.
for name in $extracted; do
  about=$(
    awk -v name="$name" '
      function holds(text) { return (" " text " ") ~ ("[^A-Za-z0-9_.\047]" pattern "[^A-Za-z0-9_.\047]") }
      BEGIN { pattern = name; gsub(/\./, "[.]", pattern) }
      FNR == NR { if (/^[A-Za-z0-9]+(\.[A-Za-z0-9_]+)+ =/) statement = $1; else if (/^ +: /) statement = ""
                  if (statement ~ /_statement[a-z_]*$/ && holds($0)) about[statement]; next }
      /^Axioms:/ { theorem = "" }
      /^Main[A-Za-z]*\./ { theorem = $1 }
      theorem { words = split($0, word, /[ ():]+/)
                for (i = 1; i <= words; i++) if (word[i] in about || word[i] == name && word[i - 1] ~ /_statement$/) print theorem }
    ' "$work/statements" "$work/assumptions" | sort -u
  )
  [ "$about" ] || refuse "Oracle.v extracts $name, which no theorem is about"
  echo "extracted: $name, of" $about
done >"$work/extracted"
cat "$work/extracted" >>"$work/assumptions"
compare assumptions.txt "$work/assumptions"
cp Oracle.v "$work"
here=$PWD
(cd "$work" && coqc -q -Q "$here" Grazing Oracle.v >"$work/extraction" 2>&1 && ! grep . "$work/extraction" >&2) ||
  refuse "Oracle.v extracts nothing, or with warnings: above"
for file in $statement_files; do
  for name in $(defined "$file" | grep -E '_statement'); do
    grep -qE "(^|[ (])${file%.v}\.$name([ )]|$)" "$work/assumptions" || refuse "$name of $file has no theorem in" $mains
  done
done

# 5. The kernel once more, on every file.
if [ "${GRAZING_COQCHK:-1}" = 0 ]; then
  echo "check.sh: the compiled files were not checked again by coqchk, as GRAZING_COQCHK=0 asks" >&2
  exit 0
fi
coqchk -silent -o -Q . Grazing $(for f in $sources; do echo "Grazing.${f%.v}"; done) >"$work/coqchk" 2>&1
# coqchk prints the axioms in no fixed order, on stderr.
grep -v "^ *$" "$work/coqchk" | sort >"$work/summary"
compare coqchk.txt "$work/summary"
