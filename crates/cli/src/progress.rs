//! What a terminal shows while a run goes on: time, step size, remaining time.

use std::fs::File;
use std::io::{BufWriter, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use flexure::results::Table;
use flexure::results::csv::CsvStream;
use flexure::{Control, Progress, Run, RunHeader, RunObserver};
use indicatif::{ProgressBar, ProgressStyle};

use crate::interrupt;
use crate::output::{Target, write_table};

/// Streams results to files and shows progress.
pub struct Watcher {
    target: Target,
    stream: Option<(PathBuf, CsvStream<BufWriter<File>>)>,
    bar: Option<ProgressBar>,
    quiet: bool,
    log: Arc<Mutex<Log>>,
}

/// Files written, and troubles met while writing them.
#[derive(Debug, Default)]
pub struct Log {
    pub written: Vec<PathBuf>,
    pub troubles: Vec<String>,
    pub interrupted: bool,
}

impl Watcher {
    /// A watcher and the log it keeps.
    pub fn new(target: Target) -> (Watcher, Arc<Mutex<Log>>) {
        let quiet = !std::io::stderr().is_terminal();
        let log = Arc::new(Mutex::new(Log::default()));
        (Watcher { target, stream: None, bar: None, quiet, log: log.clone() }, log)
    }

    /// Says something beside the progress.
    pub fn aside(&self, say: impl FnOnce()) {
        match &self.bar {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }

    fn note(&self, write: impl FnOnce(&mut Log)) {
        write(&mut self.log.lock().unwrap_or_else(PoisonError::into_inner));
    }

    fn open(&mut self, header: &RunHeader) -> std::io::Result<()> {
        let path = self.target.csv_path(header);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        let file = BufWriter::new(File::create(&path)?);
        let stream = CsvStream::new(file, header.columns.iter().map(|(name, _)| name.as_str()))?;
        self.stream = Some((path, stream));
        Ok(())
    }

    fn trouble(&self, path: &Path, error: &std::io::Error) {
        self.note(|log| log.troubles.push(format!("cannot write {}: {error}", path.display())));
    }
}

impl RunObserver for Watcher {
    fn begin(&mut self, header: &RunHeader) {
        if let Err(error) = self.open(header) {
            let path = self.target.csv_path(header);
            self.trouble(&path, &error);
        }
        if self.quiet {
            eprintln!("{}: {}", header.model, header.title);
            return;
        }
        let bar = ProgressBar::new(1000);
        if let Ok(style) = ProgressStyle::with_template("{prefix} {bar:30} {percent:>3}% {msg} [{elapsed} left {eta}]")
        {
            bar.set_style(style);
        }
        bar.set_prefix(header.title.clone());
        self.bar = Some(bar);
    }

    fn row(&mut self, row: &[f64]) {
        if let Some((path, stream)) = &mut self.stream
            && let Err(error) = stream.push(row)
        {
            let path = path.clone();
            self.trouble(&path, &error);
            self.stream = None;
        }
    }

    fn progress(&mut self, progress: &Progress) -> Control {
        if let Some(bar) = &self.bar {
            bar.set_position((progress.fraction() * 1000.0) as u64);
            bar.set_message(progress.to_string());
        }
        if interrupt::requested() { Control::Stop } else { Control::Continue }
    }

    fn message(&mut self, text: &str) {
        self.aside(|| eprintln!("{text}"));
    }

    fn listing(&mut self, line: &str) {
        self.aside(|| println!("{line}"));
    }

    fn end(&mut self, run: &Run) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
        self.note(|log| log.interrupted |= run.interrupted);
        // Who asked for a run that failed is told these with the reason.
        if !run.diagnostics.is_empty() && !run.failed {
            let colours = text::use_colours(std::io::stderr().is_terminal());
            let form = text::Format::Terminal { colours };
            eprint!("{}", text::render(&text::Sources::default(), &run.diagnostics, form));
        }
        let reached = run.table.series.first().and_then(|time| time.values.last().copied());
        if let Some((path, stream)) = self.stream.take() {
            drop(stream);
            let Some(reached) = reached else {
                eprintln!("{}: no output was reached; {} is not written", run.header.title, path.display());
                if let Err(error) = std::fs::remove_file(&path) {
                    self.trouble(&path, &error);
                }
                return;
            };
            if run.interrupted {
                let target = self.target.final_path(&path);
                eprintln!("{}: stopped at {reached} s; {} ends there", run.header.title, target.display());
            }
            let target = self.target.final_path(&path);
            if target == path {
                self.note(|log| log.written.push(path));
                return;
            }
            match finish(&run.table, &path, &target) {
                Ok(()) => self.note(|log| log.written.push(target)),
                Err(error) => {
                    self.trouble(&target, &error);
                    self.note(|log| log.written.push(path));
                }
            }
        }
    }
}

/// Writes the results in their final format and takes the stream's file away.
fn finish(table: &Table, stream: &Path, target: &Path) -> std::io::Result<()> {
    write_table(table, target)?;
    std::fs::remove_file(stream)
}
