//! `grazing completions` and `grazing man`: what a shell and a manual know of the command line, made from its
//! definition.

use std::path::PathBuf;

use clap::{Command, Parser};
use clap_complete::Shell;

use super::Outcome;
use crate::{
    error::Result,
    output::{Destination, FileRegistry, make_folder, say_to},
};

/// Write the completions of a shell to standard output.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing completions bash
  grazing completions fish -o grazing.fish

Put the file where your shell looks: for bash ~/.local/share/bash-completion/completions/grazing, for fish
~/.config/fish/completions/grazing.fish, for zsh _grazing in a folder of $fpath.")]
pub(super) struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    shell: Shell,
    /// Write to a file, which appears only when complete.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

pub(super) fn completions(args: &CompletionsArgs, files: &FileRegistry, mut cli: Command) -> Result<Outcome> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut cli, "grazing", &mut script);
    files.destination(args.output.as_deref())?.write(|out| Ok(out.write_all(&script)?))?;
    Ok(Outcome::Done)
}

/// Write the manual pages, one per command.
///
/// Exit code 0: done; 2: wrong usage or a file that cannot be written.
#[derive(Debug, Parser)]
#[command(after_help = "Examples:
  grazing man -o man1

Then `man -l man1/grazing-verify.1` shows a page; a folder man1 inside one that MANPATH names shows all.")]
pub(super) struct ManArgs {
    /// The folder for the pages.
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

pub(super) fn man(args: &ManArgs, files: &FileRegistry, cli: Command) -> Result<Outcome> {
    make_folder(&args.output)?;
    let mut pages = 0;
    let mut rest = vec![cli];
    while let Some(command) = rest.pop() {
        let name = command.get_display_name().unwrap_or(command.get_name()).to_string();
        for inner in command.get_subcommands().filter(|inner| inner.get_name() != "help") {
            let inner_name = format!("{name}-{}", inner.get_name());
            rest.push(inner.clone().display_name(inner_name));
        }
        let mut page = Vec::new();
        // As it is written on the command line, not the page's name.
        let command = command.bin_name(name.replace('-', " ")).disable_help_subcommand(true);
        let source = concat!("grazing ", env!("CARGO_PKG_VERSION"));
        clap_mangen::Man::new(command).source(source).render(&mut page)?;
        let file = files.write("-o", &args.output.join(format!("{name}.1")))?;
        file.write(|out| Ok(out.write_all(&page)?))?;
        pages += 1;
    }
    let folder = args.output.display();
    Destination::Stdout.write(|out| say_to(out, format_args!("wrote {pages} pages into {folder}")))?;
    Ok(Outcome::Done)
}
