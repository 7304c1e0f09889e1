//! Writes the table of all keys of a scene into docs/scenes.md.

use std::{fs, io};

const MARKS: [&str; 2] = [
    "<!-- keys: written by `cargo run -p grazing-scenes --example scene_reference` -->\n\n",
    "<!-- end of keys -->\n",
];

fn main() -> io::Result<()> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/scenes.md");
    let page = fs::read_to_string(path)?;
    let missing = || io::Error::other("docs/scenes.md has lost the marks around its table of keys");
    let (head, rest) = page.split_once(MARKS[0]).ok_or_else(missing)?;
    let (_, tail) = rest.split_once(MARKS[1]).ok_or_else(missing)?;
    let [begin, end] = MARKS;
    fs::write(path, format!("{head}{begin}{}{end}{tail}", grazing_scenes::scene::reference()))
}
