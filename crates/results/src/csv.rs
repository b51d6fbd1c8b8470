//! Results as comma-separated values: one header row with the names, then one row per output.
//!
//! Numbers are the shortest text that reads back to the same bits (at most 17 significant digits).
//! Units are not in the file, so that any reader takes it as it is; Parquet keeps them.

use std::io::{self, Read, Write};

use crate::Table;

/// Writes a table row by row and flushes each row, so that an interrupted run keeps what it has.
pub struct CsvStream<W: Write> {
    writer: csv::Writer<W>,
    text: Vec<String>,
}

impl<W: Write> CsvStream<W> {
    /// Writes the header.
    pub fn new<'a>(out: W, names: impl IntoIterator<Item = &'a str>) -> io::Result<Self> {
        let mut writer = csv::Writer::from_writer(out);
        let names: Vec<&str> = names.into_iter().collect();
        writer.write_record(&names)?;
        writer.flush()?;
        Ok(CsvStream { writer, text: vec![String::new(); names.len()] })
    }

    pub fn push(&mut self, row: &[f64]) -> io::Result<()> {
        let mut buffer = ryu::Buffer::new();
        for (text, value) in self.text.iter_mut().zip(row) {
            text.clear();
            text.push_str(buffer.format(*value));
        }
        self.writer.write_record(&self.text)?;
        self.writer.flush()
    }
}

/// Writes a whole table.
pub fn write(table: &Table, out: impl Write) -> io::Result<()> {
    let mut stream = CsvStream::new(io::BufWriter::new(out), table.series.iter().map(|s| s.name.as_str()))?;
    let mut row = vec![0.0; table.series.len()];
    for index in 0..table.rows() {
        for (value, series) in row.iter_mut().zip(&table.series) {
            *value = series.values[index];
        }
        stream.push(&row)?;
    }
    Ok(())
}

/// Reads a table; a cell that is no number is an error that names its row and column.
pub fn read(input: impl Read) -> io::Result<Table> {
    let mut reader = csv::Reader::from_reader(input);
    let mut table = Table::with_columns(reader.headers()?.iter().map(|name| (name.to_string(), String::new())));
    for (number, record) in reader.records().enumerate() {
        let record = record?;
        for (series, text) in table.series.iter_mut().zip(record.iter()) {
            let value = text.trim().parse().map_err(|_| not_a_number(text, number + 2, &series.name))?;
            series.values.push(value);
        }
    }
    Ok(table)
}

fn not_a_number(text: &str, line: usize, column: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("line {line}, column {column}: `{text}` is not a number"))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_number_reads_back_to_the_same_bits(values in proptest::collection::vec(any::<f64>().prop_filter("finite", |x| x.is_finite()), 1..40)) {
            let mut table = Table::with_columns([("time".into(), "second".into()), ("a,b.\"X\"".into(), String::new())]);
            for x in &values {
                table.push(&[*x, -*x]);
            }
            let mut bytes = Vec::new();
            write(&table, &mut bytes).unwrap();
            let back = read(bytes.as_slice()).unwrap();
            prop_assert_eq!(&back.series[1].name, "a,b.\"X\"");
            let bits = |t: &Table| t.series[0].values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&back), bits(&table));
        }
    }

    #[test]
    fn rows_are_readable_before_the_stream_is_closed() {
        let mut bytes = Vec::new();
        let mut stream = CsvStream::new(&mut bytes, ["time", "x"]).unwrap();
        stream.push(&[0.0, 1.5]).unwrap();
        std::mem::forget(stream);
        assert_eq!(String::from_utf8(bytes).unwrap(), "time,x\n0.0,1.5\n");
    }

    #[test]
    fn a_word_among_the_numbers_is_named_with_its_place() {
        let error = read("time,x\n0,1\n1,one\n".as_bytes()).unwrap_err();
        assert_eq!(error.to_string(), "line 3, column x: `one` is not a number");
    }
}
