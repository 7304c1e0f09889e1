//! What leaves the program, for every part: tables in six formats, files that are whole or absent, journals,
//! shards, rounded decimals.

mod bounds;
mod destination;
mod early;
#[cfg(feature = "cli")]
mod escape;
mod file;
mod hash;
mod journal;
mod lock;
#[cfg(feature = "cli")]
mod row;
mod shard;
#[cfg(feature = "cli")]
mod table;

pub use bounds::{decimal_above, decimal_below, decimal_near};
pub(crate) use destination::stdout_is_untouched;
pub use destination::{Destination, OutputFile, say};
#[cfg(feature = "cli")]
pub use escape::latex;
pub(crate) use file::remove_temporaries;
pub use file::{LONGEST_INPUT, distinct, make_folder, probe, read_text, write_file};
#[cfg(feature = "cli")]
pub(crate) use hash::{fingerprint, fnv64};
pub(crate) use journal::torn;
pub use journal::{Journal, SavedRun};
#[cfg(feature = "cli")]
pub use row::RowSetter;
pub use shard::{Shard, ShardFile, ShardWriter, ShardedTask, TaskInput};
#[cfg(feature = "cli")]
pub use table::{Caption, Column, Print, Setting, TableCell, TableFormat, TableWriter, decimal};
