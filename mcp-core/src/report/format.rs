//! Numbers, names and aligned columns as text.

use std::fmt;
use std::io::{self, Write};
use std::ops::RangeInclusive;

/// Six significant digits without trailing zeros: `0`, `2.8`, `0.466667`, `1.5e-9`, `inf`, `NaN`.
///
/// Plain notation from 10⁻⁴ to 10⁹, where digits before the point are never cut. Never `-0`.
pub(crate) fn number(x: f64) -> String {
    rounded(x, 6, -4..=8)
}

/// Two significant digits for sizes of errors: `4.4e-16`, `0.5`, `13`, `0`, `NaN`.
pub(crate) fn size(x: f64) -> String {
    rounded(x, 2, -3..=4)
}

/// So many significant digits, in plain notation for these decimal exponents.
fn rounded(x: f64, digits: i32, plain: RangeInclusive<i32>) -> String {
    if x == 0.0 || !x.is_finite() {
        return special(x);
    }
    let most = usize::try_from(digits - 1).unwrap_or(0);
    let text = format!("{x:.most$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match exponent.parse::<i32>() {
        Ok(exponent) if plain.contains(&exponent) => {
            let decimals = usize::try_from(digits - 1 - exponent).unwrap_or(0);
            trimmed(&format!("{x:.decimals$}")).to_owned()
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

/// As C's `%.4e`: `1.2649e+01`, for columns of fixed width.
pub(super) fn scientific(x: f64) -> String {
    if !x.is_finite() {
        return special(x);
    }
    let text = format!("{:.4e}", x + 0.0);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (sign, digits) = exponent.strip_prefix('-').map_or(('+', exponent), |rest| ('-', rest));
    format!("{mantissa}e{sign}{digits:0>2}")
}

/// Every digit needed to read the same number back; infinities as `inf` and `-inf`.
#[cfg(feature = "serde")]
pub(crate) fn exact(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        special(x)
    } else if (1e-5..1e16).contains(&x.abs()) {
        x.to_string()
    } else {
        format!("{x:e}")
    }
}

/// Zeros without sign, infinities and NaN.
pub(super) fn special(x: f64) -> String {
    if x.is_nan() {
        "NaN".to_owned()
    } else if x == 0.0 {
        "0".to_owned()
    } else {
        format!("{}inf", if x < 0.0 { "-" } else { "" })
    }
}

/// Without zeros at the end of a fraction.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// `1 iteration`, `2 iterations`.
pub(super) fn count(n: usize, noun: &str) -> String {
    format!("{n} {noun}{}", if n == 1 { "" } else { "s" })
}

/// Columns a text takes on a terminal: 2 for East Asian wide characters and emoji, 0 for combining
/// marks, 1 otherwise.
pub(super) fn width(text: &str) -> usize {
    text.chars().map(char_width).sum()
}

fn char_width(c: char) -> usize {
    match u32::from(c) {
        0x0300..=0x036f
        | 0x0483..=0x0489
        | 0x0591..=0x05bd
        | 0x0610..=0x061a
        | 0x064b..=0x065f
        | 0x1ab0..=0x1aff
        | 0x1dc0..=0x1dff
        | 0x200b..=0x200f
        | 0x20d0..=0x20ff
        | 0xfe00..=0xfe0f
        | 0xfe20..=0xfe2f => 0,
        0x1100..=0x115f
        | 0x2e80..=0x303e
        | 0x3041..=0xa4cf
        | 0xac00..=0xd7a3
        | 0xf900..=0xfaff
        | 0xfe30..=0xfe6f
        | 0xff00..=0xff60
        | 0xffe0..=0xffe6
        | 0x1_f300..=0x1_f64f
        | 0x1_f900..=0x1_f9ff
        | 0x2_0000..=0x3_fffd => 2,
        _ => 1,
    }
}

/// A name fit for one line: control characters are replaced by `�`.
pub(crate) fn clean(name: &str) -> String {
    name.replace(char::is_control, "\u{fffd}")
}

/// Where the cells of a column stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Align {
    /// Names and words.
    Left,
    /// Counts.
    Right,
    /// Numbers, with their decimal points in one line.
    Point,
}

/// A table that aligns its columns by display width.
#[derive(Debug, Default)]
pub(crate) struct Grid {
    columns: Vec<(String, Align)>,
    /// For each cell of a row, whether its column is shown.
    shown: Vec<bool>,
    lines: Vec<Line>,
}

#[derive(Debug)]
enum Line {
    Cells(Vec<String>),
    Note(String),
}

/// Widest part before and from the decimal point.
#[derive(Clone, Copy, Debug, Default)]
struct Extent {
    before: usize,
    after: usize,
}

impl Grid {
    /// A table with these column headers.
    pub(crate) fn new<'a>(columns: impl IntoIterator<Item = (&'a str, Align)>) -> Self {
        Self::with_shown(columns.into_iter().map(|(header, align)| (header, align, true)))
    }

    /// A table with these column headers, of which only some are shown.
    pub(crate) fn with_shown<'a>(
        columns: impl IntoIterator<Item = (&'a str, Align, bool)>,
    ) -> Self {
        let mut grid = Grid { columns: Vec::new(), shown: Vec::new(), lines: Vec::new() };
        for (header, align, shown) in columns {
            grid.shown.push(shown);
            grid.columns.extend(shown.then(|| (clean(header), align)));
        }
        grid
    }

    /// Adds a row: one cell for each column, shown or not.
    pub(crate) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let cells: Vec<String> = cells.into_iter().collect();
        debug_assert_eq!(cells.len(), self.shown.len());
        let shown = cells.iter().zip(&self.shown).filter(|(_, shown)| **shown);
        let cells: Vec<String> = shown.map(|(cell, _)| clean(cell)).collect();
        self.lines.push(Line::Cells(cells));
    }

    /// Adds a line of text that takes no part in the alignment.
    pub(crate) fn note(&mut self, text: String) {
        self.lines.push(Line::Note(text));
    }

    /// Writes header and rows, indented by one space, columns two spaces apart.
    pub(crate) fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let mut extents = vec![Extent::default(); self.columns.len()];
        for line in &self.lines {
            let Line::Cells(cells) = line else { continue };
            for (extent, (cell, column)) in extents.iter_mut().zip(cells.iter().zip(&self.columns))
            {
                let (before, after) = split(cell, column.1);
                extent.before = extent.before.max(before);
                extent.after = extent.after.max(after);
            }
        }
        for (extent, (header, _)) in extents.iter_mut().zip(&self.columns) {
            extent.before = extent.before.max(width(header).saturating_sub(extent.after));
        }
        let headers = self.columns.iter().map(|(header, align)| (header, no_point(*align)));
        write_cells(out, headers, &extents)?;
        for line in &self.lines {
            match line {
                Line::Cells(cells) => {
                    let cells = cells.iter().zip(self.columns.iter().map(|column| column.1));
                    write_cells(out, cells, &extents)?;
                }
                Line::Note(text) => writeln!(out, " {text}")?,
            }
        }
        Ok(())
    }
}

impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = Vec::new();
        self.write(&mut text).map_err(|_| fmt::Error)?;
        f.write_str(&String::from_utf8_lossy(&text))
    }
}

/// Headers of numbers stand to the right.
fn no_point(align: Align) -> Align {
    if align == Align::Point { Align::Right } else { align }
}

/// Width before the point, and from the point on.
fn split(cell: &str, align: Align) -> (usize, usize) {
    let point = match align {
        Align::Point => cell.find(['.', 'e']).unwrap_or(cell.len()),
        _ => cell.len(),
    };
    (width(&cell[..point]), width(&cell[point..]))
}

fn write_cells<'a>(
    out: &mut impl Write,
    cells: impl Iterator<Item = (&'a String, Align)>,
    extents: &[Extent],
) -> io::Result<()> {
    let mut line = String::new();
    for ((cell, align), extent) in cells.zip(extents) {
        let total = extent.before + extent.after;
        let used = width(cell);
        let left = match align {
            Align::Left => 0,
            Align::Right => total.saturating_sub(used),
            Align::Point => extent.before.saturating_sub(split(cell, align).0),
        };
        line.extend(std::iter::repeat_n(' ', left + if line.is_empty() { 1 } else { 2 }));
        line.push_str(cell);
        line.extend(std::iter::repeat_n(' ', total.saturating_sub(left + used)));
    }
    writeln!(out, "{}", line.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_have_six_significant_digits_and_no_negative_zero() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (2.8, "2.8"),
            (-50.0, "-50"),
            (1.4 / 3.0, "0.466667"),
            (1.0 - 1e-12, "1"),
            (999_999.7, "1000000"),
            (123_456_789.4, "123456789"),
            (9_999_999_999.0, "1e10"),
            (0.000_123_456_78, "0.000123457"),
            (-1.5e-9, "-1.5e-9"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::NAN, "NaN"),
            (-f64::NAN, "NaN"),
        ];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn sizes_have_two_significant_digits() {
        let cases =
            [(4.44e-16, "4.4e-16"), (0.5, "0.5"), (12.96, "13"), (1234.5, "1234"), (-0.0, "0")];
        for (x, text) in cases {
            assert_eq!(size(x), text);
        }
    }

    #[test]
    fn scientific_numbers_look_as_in_c() {
        assert_eq!(scientific(12.649_11), "1.2649e+01");
        assert_eq!(scientific(4.4e-16), "4.4000e-16");
        assert_eq!(scientific(-0.0), "0.0000e+00");
        assert_eq!(scientific(1e-200), "1.0000e-200");
        assert_eq!(scientific(f64::NAN), "NaN");
    }

    proptest! {
        #[test]
        fn rounding_is_monotone(x in -1e9..1e9_f64, scale in -12..3_i32, step in 0.0..1e-4_f64) {
            let x = x * 10_f64.powi(scale);
            let y = x + step * x.abs();
            let shown = |v: f64| number(v).parse::<f64>().unwrap();
            prop_assert!(shown(x) <= shown(y), "{} {}", number(x), number(y));
        }

        #[cfg(feature = "serde")]
        #[test]
        fn exact_numbers_read_back_bit_by_bit(x in proptest::num::f64::NORMAL) {
            prop_assert_eq!(exact(x).parse::<f64>().unwrap().to_bits(), x.to_bits());
        }
    }

    #[test]
    fn columns_align_by_display_width_and_decimal_point() {
        let mut grid =
            Grid::new([("name", Align::Left), ("level", Align::Point), ("n", Align::Right)]);
        grid.row(["東京".to_owned(), "12.5".to_owned(), "1".to_owned()]);
        grid.row(["e\u{301}".to_owned(), "0.25".to_owned(), "100".to_owned()]);
        grid.note("a note".to_owned());
        grid.row(["a\nb".to_owned(), "inf".to_owned(), "2".to_owned()]);
        let mut out = Vec::new();
        grid.write(&mut out).unwrap();
        let expected = [
            " name   level    n",
            " 東京   12.5     1",
            " e\u{301}       0.25  100",
            " a note",
            " a\u{fffd}b   inf       2",
            "",
        ];
        assert_eq!(String::from_utf8(out).unwrap(), expected.join("\n"));
    }
}
