//! Results as Parquet: one DOUBLE column for each series, its unit in the file's key-value
//! metadata under `unit:<name>`. In a room of its own because the format's library is large.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{Repetition, Type as PhysicalType};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::Field;
use parquet::schema::types::Type;
use results::{Series, Table};

/// Rows of one row group.
const GROUP: usize = 65_536;

fn other(error: ParquetError) -> io::Error {
    io::Error::other(error)
}

/// Writes a table.
pub fn write(table: &Table, out: impl Write + Send) -> io::Result<()> {
    let column = |series: &Series| {
        let column = Type::primitive_type_builder(&series.name, PhysicalType::DOUBLE)
            .with_repetition(Repetition::REQUIRED)
            .build()?;
        Ok(Arc::new(column))
    };
    let columns = table.series.iter().map(column).collect::<Result<Vec<_>, _>>().map_err(other)?;
    let schema = Type::group_type_builder("results").with_fields(columns).build().map_err(other)?;
    let units = table.series.iter().map(|s| KeyValue::new(format!("unit:{}", s.name), s.unit.clone())).collect();
    let properties = WriterProperties::builder().set_key_value_metadata(Some(units)).set_dictionary_enabled(false);
    let mut file = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties.build())).map_err(other)?;
    let mut from = 0;
    while from < table.rows() {
        let to = (from + GROUP).min(table.rows());
        let mut group = file.next_row_group().map_err(other)?;
        for series in &table.series {
            if let Some(mut column) = group.next_column().map_err(other)? {
                column.typed::<DoubleType>().write_batch(&series.values[from..to], None, None).map_err(other)?;
                column.close().map_err(other)?;
            }
        }
        group.close().map_err(other)?;
        from = to;
    }
    file.close().map_err(other)?;
    Ok(())
}

/// Reads a table of DOUBLE columns.
pub fn read(file: std::fs::File) -> io::Result<Table> {
    let reader = SerializedFileReader::new(file).map_err(other)?;
    let meta = reader.metadata().file_metadata();
    let units = meta.key_value_metadata().cloned().unwrap_or_default();
    let unit = |name: &str| {
        let key = format!("unit:{name}");
        units.iter().find(|u| u.key == key).and_then(|u| u.value.clone()).unwrap_or_default()
    };
    let names: Vec<String> = meta.schema().get_fields().iter().map(|f| f.name().to_string()).collect();
    let mut table = Table::with_columns(names.into_iter().map(|n| (n.clone(), unit(&n))));
    for row in reader.get_row_iter(None).map_err(other)? {
        let row = row.map_err(other)?;
        let values: Vec<f64> = row
            .get_column_iter()
            .map(|(name, field)| match field {
                Field::Double(x) => Ok(*x),
                _ => Err(io::Error::new(io::ErrorKind::InvalidData, format!("column `{name}` is not of type DOUBLE"))),
            })
            .collect::<io::Result<_>>()?;
        table.push(&values);
    }
    Ok(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_units_read_back() {
        let columns = [("time", "second"), ("beam_1.FX", "newton")];
        let mut table = Table::with_columns(columns.map(|(n, u)| (n.to_string(), u.to_string())));
        for k in 0..100 {
            table.push(&[f64::from(k) * 0.1, f64::from(k).sqrt()]);
        }
        let path = std::env::temp_dir().join(format!("flexure-parquet-{}.parquet", std::process::id()));
        write(&table, std::fs::File::create(&path).unwrap()).unwrap();
        let back = read(std::fs::File::open(&path).unwrap()).unwrap();
        std::fs::remove_file(&path).unwrap();
        assert_eq!(back, table);
    }
}
