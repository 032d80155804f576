//! Reading expressions: prefix notation in the file, operations in their order on the [`Tape`].
//!
//! A list of the operators that still wait for operands takes the place of recursion, so that an
//! expression may be nested as deep as a file is long.

use super::error::NlError;
use super::input::Input;
use super::operator::{Action, Binary, Unary};
use super::tape::{Expression, Op, Tape};
use std::collections::HashMap;

/// An operator that waits for operands.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    action: Action,
    /// Operands read so far.
    read: usize,
    /// Operands it takes.
    wanted: usize,
}

/// What `v<i>` may stand for.
#[derive(Debug)]
pub(super) struct Names<'a> {
    /// Variables of the file.
    pub(super) variables: usize,
    /// Indices from `variables` on, and the definitions they stand for.
    pub(super) definitions: &'a HashMap<usize, u32>,
    /// Indices of variables and definitions together.
    pub(super) all: usize,
}

impl Names<'_> {
    /// The variable or definition behind the letter `v`.
    fn read(&self, input: &mut Input<'_>) -> Result<Op, NlError> {
        let at = input.position();
        let index = input.index("the number of a variable", self.all)?;
        if index < self.variables {
            return Ok(Op::Variable(small(index)));
        }
        match self.definitions.get(&index) {
            Some(&definition) => Ok(Op::Definition(definition)),
            None => Err(input.error(at, format!("a segment V{index} before its first use"))),
        }
    }
}

/// Indices of variables stay below 2^31, which the header checks.
fn small(index: usize) -> u32 {
    u32::try_from(index).expect("the header allows 2^31 variables")
}

/// Reads one expression onto the tape.
pub(super) fn read(
    input: &mut Input<'_>,
    names: &Names<'_>,
    tape: &mut Tape,
) -> Result<Expression, NlError> {
    let start = tape.len();
    let mut waiting: Vec<Waiting> = Vec::new();
    loop {
        let at = input.at();
        match input.letter("an expression")? {
            letter @ (b'n' | b's' | b'l') => tape.push(Op::Constant(input.constant(letter)?)),
            b'v' => tape.push(names.read(input)?),
            b'o' => match read_operator(input, at)? {
                Waiting { action: Action::Piecewise, .. } => read_piecewise(input, names, tape)?,
                operator => {
                    waiting.push(operator);
                    continue;
                }
            },
            b'f' => {
                let number = input.count("the number of a function")?;
                return Err(input.unsupported(at, format!("a call of imported function {number}")));
            }
            b'h' => return Err(input.unsupported(at, "a string, which has no value")),
            _ => return Err(input.error(at, "one of `n`, `s`, `l`, `v`, `o`")),
        }
        // An operand is complete; it may complete operators.
        loop {
            let Some(operator) = waiting.last_mut() else {
                return Ok(tape.expression_from(start));
            };
            take_operand(operator, tape);
            if operator.read < operator.wanted {
                break;
            }
            finish(*operator, tape);
            waiting.pop();
        }
    }
}

/// The number behind the letter `o`, and how many operands follow.
fn read_operator(input: &mut Input<'_>, at: usize) -> Result<Waiting, NlError> {
    let code = input.count("the number of an operator")?;
    let Some(action) = Action::of_code(code) else {
        return Err(input.error(at, "the number of an operator"));
    };
    let wanted = match action {
        Action::Unary(_) | Action::Square => 1,
        Action::Binary(_) => 2,
        Action::If | Action::Implies => 3,
        Action::Piecewise => 0,
        Action::Fold(_) | Action::Count | Action::NumberOf => {
            let at = input.at();
            let wanted = input.count("how many operands follow")?;
            if wanted == 0 {
                return Err(input.error(at, "at least one operand"));
            }
            wanted
        }
        Action::Unsupported(why) => {
            return Err(input.unsupported(at, format!("operator o{code}: {why}")));
        }
    };
    Ok(Waiting { action, read: 0, wanted })
}

/// Counts the operand on the tape, makes it logical where it must be, and folds it.
fn take_operand(operator: &mut Waiting, tape: &mut Tape) {
    let Waiting { action, read, .. } = *operator;
    if action.takes_truth(read) && !tape.last().is_some_and(Op::is_logical) {
        tape.push(Op::Unary(Unary::Truth));
    }
    operator.read += 1;
    if read > 0 {
        match action {
            Action::Fold(binary) => tape.push(Op::Binary(binary)),
            Action::Count => tape.push(Op::Binary(Binary::Add)),
            _ => {}
        }
    }
}

/// Appends the operation of an operator whose operands are on the tape.
fn finish(operator: Waiting, tape: &mut Tape) {
    match operator.action {
        Action::Unary(unary) => tape.push(Op::Unary(unary)),
        Action::Binary(binary) => tape.push(Op::Binary(binary)),
        Action::Square => tape.push(Op::IntegerPower(2)),
        Action::If | Action::Implies => tape.push(Op::If),
        Action::NumberOf => tape.push(Op::NumberOf(small(operator.wanted))),
        Action::Fold(_) | Action::Count | Action::Piecewise | Action::Unsupported(_) => {}
    }
}

/// `o64`: the number of slopes, slopes and breakpoints in turn, and a variable.
fn read_piecewise(
    input: &mut Input<'_>,
    names: &Names<'_>,
    tape: &mut Tape,
) -> Result<(), NlError> {
    let at = input.at();
    let slopes = input.count("the number of slopes")?;
    if slopes == 0 {
        return Err(input.error(at, "at least one slope"));
    }
    let mut pieces: Vec<(f64, f64)> = Vec::new();
    for _ in 1..slopes {
        let slope = read_constant(input)?;
        let at = input.at();
        let breakpoint = read_constant(input)?;
        if pieces.last().is_some_and(|&(_, before)| breakpoint < before) {
            return Err(input.error(at, "breakpoints in increasing order"));
        }
        pieces.push((slope, breakpoint));
    }
    let last_slope = read_constant(input)?;
    let at = input.at();
    if input.letter("a variable")? != b'v' {
        return Err(input.error(at, "a variable"));
    }
    tape.push(names.read(input)?);
    tape.push_piecewise(&pieces, last_slope);
    Ok(())
}

fn read_constant(input: &mut Input<'_>) -> Result<f64, NlError> {
    let at = input.at();
    match input.letter("a constant")? {
        letter @ (b'n' | b's' | b'l') => input.constant(letter),
        _ => Err(input.error(at, "a constant")),
    }
}
