//! The hash of the sources (`grazing-sources`).

fn main() {
    grazing_sources::tell(&["src"]);
}
