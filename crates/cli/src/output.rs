//! Where results go, and how reports are printed.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

use flexure::RunHeader;
use flexure::results::{Table, csv};

/// Where results of runs go.
#[derive(Clone, Debug)]
pub enum Target {
    /// One file a run, named after model and run, in a folder.
    Folder(PathBuf),
    /// One file.
    File(PathBuf),
}

impl Target {
    /// A path with a known extension is a file, everything else a folder.
    pub fn of(path: &Path) -> Target {
        match extension(path).as_str() {
            "csv" | "parquet" => Target::File(path.to_path_buf()),
            _ => Target::Folder(path.to_path_buf()),
        }
    }

    /// Where the stream of a run goes while it runs.
    pub fn csv_path(&self, header: &RunHeader) -> PathBuf {
        match self {
            Target::Folder(folder) => folder.join(format!("{}_{}.csv", header.model, header.name)),
            Target::File(path) => path.with_extension("csv"),
        }
    }

    /// Where the results are in the end.
    pub fn final_path(&self, stream: &Path) -> PathBuf {
        match self {
            Target::File(path) => path.clone(),
            Target::Folder(_) => stream.to_path_buf(),
        }
    }
}

/// Extension in lower case; empty if there is none.
pub fn extension(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

pub fn write_table(table: &Table, path: &Path) -> io::Result<()> {
    let file = BufWriter::new(File::create(path)?);
    match extension(path).as_str() {
        "parquet" => flexure::parquet::write(table, file),
        _ => csv::write(table, file),
    }
}

pub fn read_table(path: &Path) -> io::Result<Table> {
    let file = File::open(path)?;
    match extension(path).as_str() {
        "parquet" => flexure::parquet::read(file),
        _ => csv::read(io::BufReader::new(file)),
    }
}
