#!/bin/sh
# Checks what the development says and what it rests on, the cheap first:
#   1. the sources: every file listed, nothing assumed or left open, no check of the kernel turned off;
#   2. every definition of the statement files, printed in full, is as pinned in statements.txt,
#      and the numbers of Consequences.v follow from the statements;
#   3. everything compiles;
#   4. each statement has a theorem in a file Main*.v, and these theorems rest on the axioms pinned
#      in assumptions.txt, which names them before each list;
#   5. the kernel checks every compiled file again (coqchk), and its summary is as pinned in coqchk.txt.
# --pin writes the three files instead of comparing them. Needs coq alone. mutants.sh tests this script.
set -eu
cd "$(dirname "$0")"
export LC_ALL=C
pin=; [ "${1-}" = --pin ] && pin=yes
sources=$(grep '\.v$' _CoqProject)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
refuse() { echo "check.sh: $*" >&2; exit 1; }
compare() { # pinned found
  if [ "$pin" ]; then cp "$2" "$1"; fi
  diff "$1" "$2" || refuse "$1 and what was found differ; if that is meant, check.sh --pin"
}

# 1. The sources. Oracle.v extracts a program and is no part of the development.
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
statement_files=$(grep -lE '^Definition [A-Za-z0-9_]+_statement|^\(\*\* \* Definitions:' $sources)
for file in $(echo "$statement_files" | grep -E '^(Defs|Statement)'); do
  if grep "^$file: " "$work/plain" | grep -qE "(^|[ .])(Notation|Infix|Coercion|Canonical|Arguments[^.]*:)[ ]"; then
    refuse "$file: a statement must not depend on notations or coercions of its own"
  fi
done

# 2. The statements in full.
coq_makefile -f _CoqProject -o Makefile.coq
jobs=$(nproc 2>/dev/null || echo 1)
make --no-print-directory -f Makefile.coq -j "$jobs" $(for f in $statement_files; do echo "${f}o"; done) Consequences.vo
{
  echo "From Coq Require Import Reals List. Open Scope R_scope. Set Printing Width 110."
  for file in $statement_files; do
    module=${file%.v}
    echo "From Grazing Require $module."
    sed -nE -e 's/^(Definition|Fixpoint|Inductive|Record|CoInductive) ([A-Za-z0-9_]+).*/\2/p' \
      -e 's/^Module ([A-Za-z0-9_]+)\. (Definition|Record) ([A-Za-z0-9_]+).*/\1.\3/p' "$file" |
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
for name in $(cat $statement_files | sed -nE 's/^Definition ([A-Za-z0-9_]*_statement[A-Za-z0-9_]*).*/\1/p'); do
  grep -qwE "$name" "$work/assumptions" || refuse "$name has no theorem in $(echo $mains)"
done

# 5. The kernel once more, on every file.
coqchk -silent -o -Q . Grazing $(for f in $sources; do echo "Grazing.${f%.v}"; done) >"$work/coqchk" 2>&1
# coqchk prints the axioms in no fixed order, on stderr.
grep -v "^ *$" "$work/coqchk" | sort >"$work/summary"
compare coqchk.txt "$work/summary"
