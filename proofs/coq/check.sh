#!/bin/sh
# Checks what the development says and what it rests on, the cheap first:
#   1. the sources: every file listed, no folders, no options; nothing assumed or left open, no check of the kernel
#      turned off; the statement files hold definitions alone and require only Coq and each other, and each
#      statement occurs in a file Consequences*.v;
#   2. every definition of the statement files, printed in full, is as pinned in statements.txt,
#      and the numbers of Consequences*.v follow from the statements;
#   3. everything compiles;
#   4. each statement, by its full name, has a theorem in a file Main*.v, and these theorems rest on the axioms
#      pinned in assumptions.txt, which names them before each list;
#   5. the kernel checks every compiled file again (coqchk), and its summary is as pinned in coqchk.txt; not so
#      with GRAZING_COQCHK=0 in the environment, as in .ci/run (.ci/full has it).
# --pin writes the three files instead of comparing them. Needs coq alone. mutants.sh tests this script.
set -eu
cd "$(dirname "$0")"
export LC_ALL=C
# Coq's own heap of 256 MB is cleared once for each file: a sixth of the time.
export OCAMLRUNPARAM=s=2M,o=400
unset COQPATH COQLIB COQEXTRAFLAGS COQFLAGS COQLIBS COQCHKEXTRAFLAGS OTHERFLAGS MAKEFLAGS MAKEFILES || true
pin=; [ "${1-}" = --pin ] && pin=yes
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
for entry in * .[!.]*; do
  if [ -L "$entry" ]; then refuse "$entry is a link"; fi
  if [ -d "$entry" ]; then refuse "$entry is a folder"; fi
  case "$entry" in *.local | *.mllib | *.ml4 | *.mlg | *.cmxs) refuse "$entry has no place here" ;; esac
done
for file in *.v; do
  case " $(echo $sources) Oracle.v " in *" $file "*) ;; *) refuse "$file is not listed in _CoqProject" ;; esac
done
# Comments (nested) are taken out and each file becomes one line, so that no line break hides a word.
for file in $sources; do
  awk -v file="$file" '
    { text = text " " $0 }
    END {
      n = length(text); depth = 0; out = ""
      for (i = 1; i <= n; i++) {
        two = substr(text, i, 2)
        if (two == "(*") { depth++; i++ }
        else if (two == "*)" && depth > 0) { depth--; i++; out = out " " }
        else if (depth == 0) out = out substr(text, i, 1)
      }
      print file ": " out
    }' "$file"
done >"$work/plain"
word='(Axioms?|Parameters?|Conjectures?|Admitted|admit|give_up|Admit[ ]+Obligations|bypass_check|Declare[ ]+ML|Redirect|Load|Extraction|[Uu]nsafe)'
if grep -oE "^[A-Za-z0-9]+\.v|.{0,40}(^|[^A-Za-z0-9_'])$word([^A-Za-z0-9_'].{0,20}|$)|.{0,20}(Unset|Set)[^.]*(Checking|Impredicative)[^.]*\." \
    "$work/plain" | awk '/^[A-Za-z0-9]+\.v$/ { file = $0; next } { print file ":" $0; bad = 1 } END { exit !bad }' >&2; then
  refuse "assumed, unproved or unchecked: above"
fi
statement_files=$(echo "$sources" | grep -E '^(Defs|Headline|Statement[A-Za-z0-9]*)\.v$')
# One sentence a line; what a statement file may hold. Numbers and names have no dot before a blank.
sentences() { grep "^$1: " "$work/plain" | sed -e "s/^$1: //" | sed -E 's/\.([[:space:]]|$)/.\n/g' | sed -E 's/^[[:space:]]+//' | grep . || true; }
for file in $statement_files; do
  if sentences "$file" | grep -vE '^(From Coq Require Import|From Grazing Require Import|Open Scope|Definition|Fixpoint|Inductive|Record|Module|Section|Variables|End)[[:space:]]+[^"]*\.$|^Import (ListNotations|Map)\.$|^Arguments [a-z_]+ [{}a-z ]+\.$' >&2; then
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
# What Oracle.v extracts is what statements are about, and nothing else is in it.
extracted=$(tr '\n' ' ' <Oracle.v | sed -nE 's/.*Extraction "decide\.ml"([^.]*( Z\.(add|mul|opp|gcd))*)\.[[:space:]]*$/\1/p')
[ "$extracted" ] || refuse "Oracle.v must end with its one Extraction"
if grep -E '(Definition|Fixpoint|Let|Notation|Extract|Axiom)[[:space:]]' Oracle.v >&2; then refuse "Oracle.v defines or replaces: above"; fi
decided=$(for file in StatementZ StatementWordsZ StatementCircleZ StatementReaders StatementReaderWords StatementPaths StatementRanges; do
  sentences $file.v; done | grep -E '^Definition [A-Za-z0-9_]*_statement ')
for name in $extracted; do
  case "$name" in Z.add | Z.mul | Z.opp | Z.gcd) continue ;; esac
  for file in StatementZ StatementWordsZ StatementCircleZ StatementReaders StatementReaderWords StatementPaths StatementRanges; do sentences $file.v; done | grep -E '^Definition [A-Za-z0-9_]*_statement ' | grep -qw "$name" ||
    refuse "Oracle.v extracts $name, which no statement is about"
done

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
compare assumptions.txt "$work/assumptions"
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
