//! Writing to the standard output: what a command was asked for goes there, everything else to stderr.

use crate::failure::{Exit, Failure};
use crate::report::Report;
use std::io::{self, Write};

/// Prints a text as it is.
///
/// # Errors
/// When the output cannot be written. A reader that went away (`vitrine schema | head`) ends the command in silence.
pub fn print(text: impl AsRef<[u8]>) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_ref()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => Failure::silent(Exit::Done),
        _ => {
            Failure::new(Exit::Failed, Report::error(format!("cannot write to the standard output: {error}")))
        }
    })
}

/// Tells the person something on stderr.
pub fn tell(text: &str) {
    // Nobody is left to tell when stderr itself fails.
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Columns of text under one another, two spaces apart; the last column is as wide as it likes.
pub fn table(rows: &[Vec<String>], right_aligned: bool) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter().filter_map(|r| r.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<_> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells: Vec<_> = row
            .iter()
            .zip(&widths)
            .map(
                |(cell, &width)| {
                    if right_aligned { format!("{cell:>width$}") } else { format!("{cell:<width$}") }
                },
            )
            .collect();
        text.push_str(cells.join("  ").trim_end());
        text.push('\n');
    }
    text
}

/// A number with its thousands apart: "12 345 678".
pub fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let groups = digits.as_bytes().rchunks(3).rev().map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up() {
        let rows = [vec!["шар".into(), "1".into()], vec!["b".into(), "200".into()]];
        assert_eq!(table(&rows, false), "шар  1\nb    200\n");
        assert_eq!(table(&rows, true), "шар    1\n  b  200\n");
    }

    #[test]
    fn thousands_stand_apart() {
        assert_eq!([0, 999, 1000, 12_345_678].map(thousands), ["0", "999", "1 000", "12 345 678"]);
    }
}
