//! What leaves the program, for every part: tables in six formats, files that are whole or absent, journals,
//! shards, rounded decimals; and samples over time, which come in.

mod bounds;
mod destination;
mod early;
mod escape;
mod file;
mod fraction;
mod hash;
mod journal;
mod lock;
mod registry;
mod row;
mod samples;
mod shard;
mod table;

/// A program, as its shards and saved states name it: the version, and a hash of the hashes of the chapters
/// whose sources decide results. Programs from the same sources agree in it, whatever built them.
pub fn program(chapters: &[&str]) -> String {
    format!("{}+{:016x}", env!("CARGO_PKG_VERSION"), fnv64(chapters.concat().as_bytes()))
}

pub use bounds::{decimal_above, decimal_below, decimal_near, decimal_or_fraction};
pub use destination::stdout_is_untouched;
pub use destination::{Destination, OutputFile, say, say_to};
pub use escape::{latex, latex_numbers};
pub use file::remove_temporaries;
pub use file::{LONGEST_INPUT, LONGEST_SCENE, make_folder, read_text, write_file};
pub use fraction::serialize_fraction;
pub use hash::{fingerprint, fnv64};
pub use journal::{Journal, SavedRun, torn};
pub use registry::MADE;
pub use registry::{Clash, FileRegistry, FileUse, NamedFile};
pub use row::{Numbers, RowSetter};
pub use samples::{SampleColumns, SampleLine, WrongLine, samples};
pub use shard::{Shard, ShardFile, ShardWriter, ShardedTask, TaskInput};
pub use table::{Caption, Column, Print, Setting, TableCell, TableFormat, TableWriter, decimal};
