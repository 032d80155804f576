//! [`Parts`]: what the segments of a file say, checked one by one.
//!
//! | letter | content | used |
//! | --- | --- | --- |
//! | `F` | an imported function | error |
//! | `S` | values of a suffix | read over |
//! | `V` | a defined variable: linear terms and an expression | definition |
//! | `C` | nonlinear part of a row | row |
//! | `L` | a logical row | error |
//! | `O` | an objective | error unless constant |
//! | `d` | starts of dual values | read over |
//! | `x` | starts of variables | start |
//! | `r` | bounds of rows, or the variables they complement | pairs |
//! | `b` | bounds of variables | bounds |
//! | `k`, `K` | lengths of the columns of the Jacobian | read over |
//! | `J` | linear terms of a row; coefficient 0 where a variable is only in its expression | row |
//! | `G` | linear terms of an objective | error unless 0 |

use super::error::{NlError, Place, Segment};
use super::expression::{self, Names};
use super::header::Header;
use super::input::{Form, Input};
use super::tape::{Expression, Tape};
use std::collections::HashMap;
use std::ops::Range;

/// From here on a bound is infinite.
const INFINITE: f64 = 1e20;

/// What segment `r` says about a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RowKind {
    /// `lower <= g(z) <= upper`.
    Between { lower: f64, upper: f64 },
    /// `g(z)` complements a variable, counted from 0, whose finite bounds are told by two bits: 1
    /// for the lower, 2 for the upper one.
    Complements { bits: u8, variable: usize },
}

impl RowKind {
    /// Whether the row is `g(z) = c`.
    pub(super) fn is_equation(self) -> bool {
        matches!(self, RowKind::Between { lower, upper } if lower == upper && lower.is_finite())
    }
}

/// An expression plus linear terms.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    pub(super) expression: Expression,
    /// Where the linear terms stand among all.
    pub(super) linear: Range<usize>,
}

/// The segments of a file.
#[derive(Debug, Default)]
pub(super) struct Parts {
    pub(super) header: Header,
    pub(super) tape: Tape,
    /// Linear terms, variable and coefficient, of everything.
    pub(super) linear: Vec<(u32, f64)>,
    pub(super) definitions: Vec<Sum>,
    /// Number of the definition that an index stands for.
    definition_of: HashMap<usize, u32>,
    /// Rows, where their segments stand, and their expressions, in the order of the file.
    pub(super) expressions: Vec<(usize, usize, Expression)>,
    /// Rows, where their segments stand, and their linear terms, in the order of the file.
    pub(super) terms: Vec<(usize, usize, Range<usize>)>,
    pub(super) start: Vec<(usize, f64)>,
    pub(super) bounds: Vec<(f64, f64)>,
    pub(super) rows: Vec<RowKind>,
    /// Where an objective is not constant.
    pub(super) objective: Option<(Place, Segment)>,
}

impl Parts {
    /// Reads header and segments.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, NlError> {
        let mut input = Input::new(bytes);
        let header = Header::read(&mut input)?;
        let mut parts = Parts { header, ..Parts::default() };
        loop {
            let at = input.at();
            let Some(letter) = input.segment_letter() else { break };
            parts.segment(&mut input, letter, at)?;
        }
        let expressions = parts.expressions.iter().map(|&(row, at, _)| (row, at));
        let terms = parts.terms.iter().map(|&(row, at, _)| (row, at));
        for (letter, repeated) in [('C', repeated(expressions)), ('J', repeated(terms))] {
            if let Some((row, at)) = repeated {
                input.segment = Segment::Body(letter, Some(row));
                return Err(input.error(at, format!("one segment {letter}{row} only")));
            }
        }
        for (letter, expected, found) in [
            ('b', parts.header.variables, parts.bounds.len()),
            ('r', parts.header.rows, parts.rows.len()),
        ] {
            if expected != found {
                return Err(input.error(bytes.len(), format!("a segment {letter}")));
            }
        }
        Ok(parts)
    }

    fn segment(&mut self, input: &mut Input<'_>, letter: u8, at: usize) -> Result<(), NlError> {
        let body = |number| Segment::Body(char::from(letter), number);
        match letter {
            b'F' | b'S' | b'V' | b'C' | b'L' | b'O' | b'J' | b'G' => {
                input.segment = body(None);
                let limit = match letter {
                    b'F' => self.header.functions,
                    b'S' => 8,
                    b'V' => self.header.variables + self.header.defined,
                    b'O' | b'G' => self.header.objectives,
                    b'L' => usize::MAX,
                    _ => self.header.rows,
                };
                let number = input.index("the number of the segment", limit)?;
                input.segment = body(Some(number));
                match letter {
                    b'F' => Self::function(input, at),
                    b'S' => Self::suffix(input, number),
                    b'V' => self.definition(input, number, at),
                    b'C' => {
                        let read = self.expression(input)?;
                        self.expressions.push((number, at, read));
                        Ok(())
                    }
                    b'L' => Err(input.unsupported(at, "a logical row")),
                    b'O' => self.objective(input, at),
                    b'J' => {
                        let terms = self.terms(input)?;
                        self.terms.push((number, at, terms));
                        Ok(())
                    }
                    _ => self.gradient(input, at),
                }
            }
            b'd' | b'x' | b'r' | b'b' | b'k' | b'K' => {
                input.segment = body(None);
                match letter {
                    b'd' => Self::pairs(input, self.header.rows, |_, _| ()),
                    b'x' => {
                        let start = &mut self.start;
                        Self::pairs(input, self.header.variables, |j, z| start.push((j, z)))
                    }
                    b'r' => self.row_kinds(input, at),
                    b'b' => self.variable_bounds(input, at),
                    _ => self.column_lengths(input),
                }
            }
            _ => {
                let letters = "one of the segments F S V C L O d x r b k K J G";
                Err(input.error(at, letters))
            }
        }
    }

    fn expression(&mut self, input: &mut Input<'_>) -> Result<Expression, NlError> {
        let Header { variables, defined, .. } = self.header;
        let names = Names { variables, definitions: &self.definition_of, all: variables + defined };
        expression::read(input, &names, &mut self.tape)
    }

    /// `F<i> <kind> <arguments> <name>`.
    fn function(input: &mut Input<'_>, at: usize) -> Result<(), NlError> {
        input.integer("the kind of a function")?;
        input.integer("the number of its arguments")?;
        let (place, segment, name) = (input.place(at), input.segment, input.name()?);
        Err(NlError::ImportedFunction { place, segment, name })
    }

    /// `S<kind> <n> <name>`, then `n` times an index and a value; real values if `kind` has bit 4.
    fn suffix(input: &mut Input<'_>, kind: usize) -> Result<(), NlError> {
        let count = input.count("how many values follow")?;
        input.name()?;
        for _ in 0..count {
            input.count("an index")?;
            if kind & 4 == 0 {
                input.integer("an integer")?;
            } else {
                input.number("a number")?;
            }
        }
        Ok(())
    }

    /// `V<i> <n> <where>`, `n` linear terms, an expression.
    fn definition(
        &mut self,
        input: &mut Input<'_>,
        index: usize,
        at: usize,
    ) -> Result<(), NlError> {
        if index < self.header.variables || self.definition_of.contains_key(&index) {
            return Err(input.error(at, "the index of a new defined variable"));
        }
        let linear = self.linear_terms(input, |input| input.count("where it is used").map(drop))?;
        let expression = self.expression(input)?;
        let number = u32::try_from(self.definitions.len()).expect("below 2^31 of the header");
        self.definitions.push(Sum { expression, linear });
        self.definition_of.insert(index, number);
        Ok(())
    }

    /// `n`, what `between` reads, then `n` times a variable and its coefficient.
    fn linear_terms(
        &mut self,
        input: &mut Input<'_>,
        between: impl FnOnce(&mut Input<'_>) -> Result<(), NlError>,
    ) -> Result<Range<usize>, NlError> {
        let count = input.count("how many linear terms follow")?;
        between(input)?;
        let start = self.linear.len();
        for _ in 0..count {
            let variable = input.index("the number of a variable", self.header.variables)?;
            let coefficient = input.finite("a finite coefficient")?;
            let variable = u32::try_from(variable).expect("the header allows 2^31 variables");
            self.linear.push((variable, coefficient));
        }
        Ok(start..self.linear.len())
    }

    /// `J<i> <n>`, then the terms.
    fn terms(&mut self, input: &mut Input<'_>) -> Result<Range<usize>, NlError> {
        self.linear_terms(input, |_| Ok(()))
    }

    /// `O<i> <sense>`, then an expression.
    fn objective(&mut self, input: &mut Input<'_>, at: usize) -> Result<(), NlError> {
        input.count("0 to minimise or 1 to maximise")?;
        let read = self.expression(input)?;
        if self.tape.constant(&read).is_none() {
            self.objective.get_or_insert((input.place(at), input.segment));
        }
        Ok(())
    }

    /// `G<i> <n>`, then the terms.
    fn gradient(&mut self, input: &mut Input<'_>, at: usize) -> Result<(), NlError> {
        let terms = self.terms(input)?;
        if self.linear.drain(terms).any(|(_, coefficient)| coefficient != 0.0) {
            self.objective.get_or_insert((input.place(at), input.segment));
        }
        Ok(())
    }

    /// `x<n>` and `d<n>`: `n` times an index and a value.
    fn pairs(
        input: &mut Input<'_>,
        below: usize,
        mut take: impl FnMut(usize, f64),
    ) -> Result<(), NlError> {
        for _ in 0..input.count("how many values follow")? {
            let index = input.index("an index", below)?;
            take(index, input.finite("a finite number")?);
        }
        Ok(())
    }

    /// `b`: a kind and its numbers for every variable.
    fn variable_bounds(&mut self, input: &mut Input<'_>, at: usize) -> Result<(), NlError> {
        if !self.bounds.is_empty() {
            return Err(input.error(at, "one segment b only"));
        }
        for _ in 0..self.header.variables {
            let at = input.at();
            let kind = bound_kind(input)?;
            let bounds = between(input, kind)?;
            self.bounds.push(bounds.ok_or_else(|| input.error(at, "a kind of bounds, 0 to 4"))?);
        }
        Ok(())
    }

    /// `r`: a kind and its numbers for every row; kind 5 is `5 <bits> <variable>`, counted from 1.
    fn row_kinds(&mut self, input: &mut Input<'_>, at: usize) -> Result<(), NlError> {
        if !self.rows.is_empty() {
            return Err(input.error(at, "one segment r only"));
        }
        for _ in 0..self.header.rows {
            let at = input.at();
            let kind = bound_kind(input)?;
            if let Some((lower, upper)) = between(input, kind)? {
                self.rows.push(RowKind::Between { lower, upper });
            } else if kind == b'5' {
                let bits = input.index("which bounds are finite,", 4)?;
                let at = input.at();
                let variable = input.integer("the number of a variable")?;
                let variable = usize::try_from(variable).ok().and_then(|j| j.checked_sub(1));
                let variable = variable.filter(|&j| j < self.header.variables);
                let variable = variable.ok_or_else(|| {
                    let count = self.header.variables;
                    input.error(at, format!("the number of a variable from 1 to {count}"))
                })?;
                #[allow(clippy::cast_possible_truncation, reason = "0 to 3")]
                self.rows.push(RowKind::Complements { bits: bits as u8, variable });
            } else {
                return Err(input.error(at, "a kind of row, 0 to 5"));
            }
        }
        Ok(())
    }

    /// `k<n−1>`, then sums of lengths; `K<n−1>`, then lengths.
    fn column_lengths(&mut self, input: &mut Input<'_>) -> Result<(), NlError> {
        let at = input.at();
        let expected = self.header.variables.saturating_sub(1);
        let count = input.count("the number of columns less one")?;
        if count != expected {
            return Err(input.error(at, format!("{expected}, the number of columns less one")));
        }
        for _ in 0..count {
            input.count("the length of a column")?;
        }
        Ok(())
    }
}

/// The first row in order that has two segments, and where the second stands.
fn repeated(segments: impl Iterator<Item = (usize, usize)>) -> Option<(usize, usize)> {
    let mut segments: Vec<(usize, usize)> = segments.collect();
    segments.sort_unstable();
    segments.windows(2).find(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1])
}

/// The digit of a kind of bounds; in text it stands alone.
fn bound_kind(input: &mut Input<'_>) -> Result<u8, NlError> {
    const EXPECTED: &str = "a kind of bounds, 0 to 5";
    if input.form == Form::Text {
        let at = input.at();
        let kind = input.integer(EXPECTED)?;
        let digit = u8::try_from(kind).ok().filter(|kind| *kind <= 5);
        digit.map(|kind| b'0' + kind).ok_or_else(|| input.error(at, EXPECTED))
    } else {
        input.letter(EXPECTED)
    }
}

/// The numbers of kinds 0 to 4: both bounds, upper, lower, none, equal.
fn between(input: &mut Input<'_>, kind: u8) -> Result<Option<(f64, f64)>, NlError> {
    const LOWER: &str = "a lower bound";
    const UPPER: &str = "an upper bound";
    let (lower, upper) = match kind {
        b'0' => (input.number(LOWER)?, input.number(UPPER)?),
        b'1' => (f64::NEG_INFINITY, input.number(UPPER)?),
        b'2' => (input.number(LOWER)?, f64::INFINITY),
        b'3' => (f64::NEG_INFINITY, f64::INFINITY),
        b'4' => {
            let value = input.finite("a finite value")?;
            return Ok(Some((value, value)));
        }
        _ => return Ok(None),
    };
    let is_infinite = |bound: f64| bound.abs() >= INFINITE;
    let lower = if is_infinite(lower) { lower.signum() * f64::INFINITY } else { lower };
    let upper = if is_infinite(upper) { upper.signum() * f64::INFINITY } else { upper };
    Ok(Some((lower, upper)))
}
