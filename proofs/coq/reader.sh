#!/bin/sh
# Builds `grazing-proved`, the reader of certificates whose decisions Coq has proved, in a folder:
#
#     sh proofs/coq/reader.sh FOLDER
#
# Coq compiles what the functions need, and extracts them; the OCaml compiler makes programs of them, with reader.ml
# and, to compare single answers, oracle.ml. Needs coqc, coqdep and ocamlopt or ocamlc; takes half a minute. The
# sources stay as they are. That the theorems about these functions hold is check.sh's matter.
set -eu
[ $# -eq 1 ] || { echo "usage: sh reader.sh FOLDER" >&2; exit 2; }
mkdir -p "$1"
to=$(cd "$1" && pwd)
cd "$(dirname "$0")"
compiler=$(command -v ocamlopt || command -v ocamlc) || {
  echo "reader.sh: no ocamlopt or ocamlc on the PATH (Debian: apt install ocaml-nox)" >&2
  exit 2
}
files=$(coqdep -sort -Q . Grazing Oracle.v)
if [ "$to" != "$(pwd)" ]; then cp $files oracle.ml reader.ml "$to"; fi
cd "$to"
for file in $files; do coqc -q -Q . Grazing "$file"; done
"$compiler" -w -a decide.mli decide.ml oracle.ml -o oracle
"$compiler" -w -a decide.mli decide.ml reader.ml -o grazing-proved
