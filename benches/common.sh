# What scripts here share; they source it from the root of the repository.

# Sets GRAZING, the program that is measured: by default the release build.
find_grazing() {
    [ -z "${GRAZING:-}" ] || return 0
    cargo build --quiet --release --package grazing-shell
    GRAZING="${CARGO_TARGET_DIR:-target}/release/grazing"
}

# With FLINT=DIR, FLINT is that in DIR/include and DIR/lib, in place of the system's. A newer one than Debian's stable
# distribution has comes without a compiler from packages: headers from libflint-dev of a newer distribution, the library of the
# same version (and its libgmp) from the wheel of python-flint, with links libflint.so and libgmp.so.
if [ -n "${FLINT:-}" ]; then
    export CPATH="$FLINT/include" LIBRARY_PATH="$FLINT/lib" LD_LIBRARY_PATH="$FLINT/lib"
fi

# compile_with_arb PROGRAM FILE.c: Arb is in FLINT, or beside it.
compile_with_arb() {
    local beside=
    [ -n "${FLINT:-}" ] || [ ! -e /usr/include/arb.h ] || beside=-lflint-arb
    # shellcheck disable=SC2086
    gcc -O2 -o "$1" "$2" $beside -lflint -lgmp
}
