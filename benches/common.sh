# What scripts here share; they source it from the root of the repository.

# Sets GRAZING, the program that is measured: by default the release build.
find_grazing() {
    [ -z "${GRAZING:-}" ] || return 0
    cargo build --quiet --release
    GRAZING="${CARGO_TARGET_DIR:-target}/release/grazing"
}

# compile_with_arb PROGRAM FILE.c: Debian has Arb in FLINT, or beside it.
compile_with_arb() {
    local beside=
    [ ! -e /usr/include/arb.h ] || beside=-lflint-arb
    # shellcheck disable=SC2086
    gcc -O2 -o "$1" "$2" $beside -lflint -lgmp
}
