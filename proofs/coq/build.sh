#!/bin/sh
# Compiles the development: sh build.sh [-j N]. Needs only coq (8.16).
set -eu
cd "$(dirname "$0")"
export OCAMLRUNPARAM=${OCAMLRUNPARAM-s=2M,o=400}
coq_makefile -f _CoqProject -o Makefile.coq
make --no-print-directory -f Makefile.coq "$@"
