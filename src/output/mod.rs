//! What leaves the program, for every part: tables in six formats, files that are whole or absent, journals,
//! shards, rounded decimals.

mod bounds;
mod destination;
mod early;
#[cfg(feature = "cli")]
mod escape;
mod file;
mod fraction;
mod hash;
mod journal;
mod lock;
mod registry;
#[cfg(feature = "cli")]
mod row;
mod shard;
#[cfg(feature = "cli")]
mod table;

/// This program, as its shards and saved states name it: the version, and a hash of the sources that decide
/// results (`build.rs` has the list). Programs from the same sources agree in it, whatever built them.
pub(crate) const PROGRAM: &str = concat!(env!("CARGO_PKG_VERSION"), "+", env!("GRAZING_SOURCES"));

pub use bounds::{decimal_above, decimal_below, decimal_near};
pub(crate) use destination::stdout_is_untouched;
pub use destination::{Destination, OutputFile, say, say_to};
#[cfg(feature = "cli")]
pub use escape::{latex, latex_numbers};
pub(crate) use file::remove_temporaries;
pub use file::{LONGEST_INPUT, LONGEST_SCENE, make_folder, read_text, write_file};
pub use fraction::serialize_fraction;
#[cfg(feature = "cli")]
pub(crate) use hash::{fingerprint, fnv64};
pub(crate) use journal::torn;
pub use journal::{Journal, SavedRun};
pub(crate) use registry::MADE;
pub use registry::{Clash, FileRegistry, FileUse, NamedFile};
#[cfg(feature = "cli")]
pub use row::RowSetter;
pub use shard::{Shard, ShardFile, ShardWriter, ShardedTask, TaskInput};
#[cfg(feature = "cli")]
pub use table::{Caption, Column, Print, Setting, TableCell, TableFormat, TableWriter, decimal};
