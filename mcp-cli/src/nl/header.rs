//! [`Header`]: the ten lines every `.nl` file starts with, in text also in binary files.
//!
//! ```text
//!  1  g3 1 1 0               g: text, b: binary; options of AMPL, given back in the .sol file
//!  2  n m …                  variables, rows, objectives, ranges, equations, logical rows
//!  3  …                      nonlinear rows and objectives; complementarity rows by kind
//!  4  …                      network rows
//!  5  …                      nonlinear variables in rows, objectives, both
//!  6  …                      network variables, functions, arithmetic of the binary form, flags
//!  7  …                      discrete variables: binary, integer, nonlinear in both, rows, objectives
//!  8  …                      nonzeros of rows and of objectives
//!  9  …                      longest names of rows and of variables
//! 10  …                      defined variables, five counts
//! ```

use super::error::{NlError, Place, Segment};
use super::input::{Form, Input};

/// Options a header may have.
const MOST_OPTIONS: usize = 9;
/// Variables and rows a file may have: their numbers are kept in 32 bits.
const MOST: usize = 1 << 31;
/// The value of the second option that announces a tolerance behind the options.
const READ_TOLERANCE: i64 = 3;

/// What the ten lines say, as far as it is used.
#[derive(Clone, Debug, Default)]
pub(super) struct Header {
    /// Options that go back to AMPL in the `.sol` file.
    pub(super) options: Vec<i64>,
    /// A tolerance that goes back with them.
    pub(super) tolerance: Option<f64>,
    pub(super) variables: usize,
    pub(super) rows: usize,
    pub(super) objectives: usize,
    /// Defined variables: segments `V`.
    pub(super) defined: usize,
    /// Imported functions: segments `F`.
    pub(super) functions: usize,
    /// Variables that must be integers, and the number of the first.
    pub(super) integers: Option<(usize, usize)>,
}

impl Header {
    /// Reads the ten lines and the form of what follows.
    pub(super) fn read(input: &mut Input<'_>) -> Result<Self, NlError> {
        let mut header = Header::default();
        let is_binary = header.read_options(input)?;
        let sizes = counts::<6>(input, 2, 3)?;
        let [variables, rows, objectives, _, _, logical] = sizes;
        (header.variables, header.rows, header.objectives) = (variables, rows, objectives);
        if logical > 0 {
            return Err(unsupported(
                2,
                format!("{logical} logical rows: a complementarity problem has none"),
            ));
        }
        counts::<6>(input, 3, 0)?;
        counts::<2>(input, 4, 0)?;
        let nonlinear = counts::<3>(input, 5, 0)?;
        let [_, functions, arithmetic, _] = counts::<4>(input, 6, 0)?;
        header.functions = functions;
        let discrete = counts::<5>(input, 7, 0)?;
        header.integers = first_integer(variables, nonlinear, discrete);
        counts::<2>(input, 8, 0)?;
        counts::<2>(input, 9, 0)?;
        header.defined = counts::<5>(input, 10, 0)?.iter().sum();
        input.form = match (is_binary, arithmetic) {
            (false, _) => Form::Text,
            (true, 1) => Form::LittleEndian,
            (true, 2) => Form::BigEndian,
            (true, kind) => {
                let what = format!("arithmetic {kind} of a binary file: only IEEE is read, 1 or 2");
                return Err(unsupported(6, what));
            }
        };
        Ok(header)
    }

    /// Line 1: `g` or `b`, the number of options, the options, perhaps a tolerance.
    fn read_options(&mut self, input: &mut Input<'_>) -> Result<bool, NlError> {
        const LINE: usize = 1;
        let expected = "`g` or `b` and up to 9 options";
        let line = header_line(input, LINE)?;
        let fail = || syntax(LINE, expected, line);
        let (letter, rest) = line.split_at_checked(1).ok_or_else(fail)?;
        let is_binary = match letter {
            "g" => false,
            "b" => true,
            _ => return Err(fail()),
        };
        let mut words = rest.split_ascii_whitespace();
        let count = words.next().map_or(Some(0), |word| word.parse().ok());
        let count = count.filter(|&count| count <= MOST_OPTIONS).ok_or_else(fail)?;
        for word in words.by_ref().take(count) {
            self.options.push(word.parse().map_err(|_| fail())?);
        }
        if self.options.get(1) == Some(&READ_TOLERANCE)
            && let Some(word) = words.next()
        {
            self.tolerance = Some(word.parse().map_err(|_| fail())?);
        }
        Ok(is_binary)
    }
}

/// A line of `N` counts, of which at least `least` must be given; the others default to 0.
fn counts<const N: usize>(
    input: &mut Input<'_>,
    number: usize,
    least: usize,
) -> Result<[usize; N], NlError> {
    let line = header_line(input, number)?;
    let mut counts = [0; N];
    let mut given = 0;
    for (count, word) in counts.iter_mut().zip(line.split_ascii_whitespace()) {
        let parsed = word.parse().ok().filter(|&count| count <= MOST);
        *count = parsed.ok_or_else(|| syntax(number, "counts up to 2^31", word))?;
        given += 1;
    }
    if given < least {
        let expected = format!("at least {least} counts");
        return Err(syntax(number, &expected, line));
    }
    Ok(counts)
}

fn header_line<'a>(input: &mut Input<'a>, number: usize) -> Result<&'a str, NlError> {
    input.segment = Segment::Header(number);
    let at = input.position();
    input.header_line().ok_or_else(|| input.error(at, "ten lines of header"))
}

fn syntax(line: usize, expected: &str, found: &str) -> NlError {
    NlError::Syntax {
        place: Place::Line(line),
        segment: Segment::Header(line),
        expected: expected.to_owned(),
        found: format!("`{}`", found.chars().take(40).collect::<String>().escape_debug()),
    }
}

fn unsupported(line: usize, what: String) -> NlError {
    NlError::Unsupported { place: Place::Line(line), segment: Segment::Header(line), what }
}

/// Number of integer variables and the first of them.
///
/// Variables stand in this order, in each group the continuous ones first: nonlinear in both rows
/// and objectives, in rows only, in objectives only, then linear ones, and at the end the linear
/// binary and integer ones ([Gay97](mcp_core#references), table 4).
fn first_integer(
    variables: usize,
    [in_rows, in_objectives, in_both]: [usize; 3],
    [binary, integer, both, rows, objectives]: [usize; 5],
) -> Option<(usize, usize)> {
    let groups = [
        (both, in_both),
        (rows, in_rows),
        (objectives, in_rows.max(in_objectives)),
        (binary.saturating_add(integer), variables),
    ];
    let count = groups.iter().fold(0_usize, |sum, (count, _)| sum.saturating_add(*count));
    let (size, end) = groups.into_iter().find(|&(count, _)| count > 0)?;
    Some((count, end.saturating_sub(size).min(variables.saturating_sub(1))))
}
