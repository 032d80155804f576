//! # Games of two players in mixed strategies
//!
//! The player of rows chooses row `i` with probability `x_i`, the player of columns column `j` with
//! probability `y_j`; they are paid `a_ij` and `b_ij`. A choice is made only if none pays more, and
//! what the best pays is the value of the game for its player:
//!
//! ```text
//! v − Σ_j a_ij y_j >= 0   ⟂   x_i >= 0        Σ_i x_i = 1   ⟂   v free
//! w − Σ_i b_ij x_i >= 0   ⟂   y_j >= 0        Σ_j y_j = 1   ⟂   w free
//! ```
//!
//! This is the linear complementarity problem of Lemke & Howson, *Equilibrium points of bimatrix
//! games*, J. SIAM 12 (1964) 413–423, with the probabilities and values kept as such.
//!
//! Two games are played. On a tram a ticket costs 3, an inspection costs the company 2, and who is
//! caught without a ticket pays 60. Nothing but a mixture is stable: the company inspects with
//! probability 3/60, so that riders do not mind to pay, and they dodge with probability 2/60, so
//! that the company does not mind to inspect.
//!
//! The second game is the 3 × 2 example of B. von Stengel, *Equilibrium computation for two-player
//! games in strategic and extensive form*, chapter 3 of *Algorithmic Game Theory*, edited by Nisan,
//! Roughgarden, Tardos & Vazirani, Cambridge 2007. It has three equilibria:
//!
//! ```text
//! x = (1, 0, 0)       y = (1, 0)
//! x = (4/5, 1/5, 0)   y = (2/3, 1/3)
//! x = (0, 1/3, 2/3)   y = (1/3, 2/3)
//! ```
//!
//! Which one a solve finds depends on the start; from the six starts at sure choices `newton_fb`
//! finds them all. (Random games are not so kind: there it fails from many such starts.)
//!
//! Every answer is checked by best replies: no row and no column pays more than the mixture.
//! `tests/gallery/bimatrix.rs` finds the equilibria by trying all supports.
#![allow(clippy::print_stdout, reason = "an example prints its results")]

use mcp_core::{AdProblem, Method, ModelError, Options, Report, mcp, solve};
use std::error::Error;

mcp! {
    /// Two players choose rows and columns.
    pub(crate) model Bimatrix {
        data {
            rows: Set, columns: Set,
            /// pay of the player of rows
            a[rows, columns]: f64,
            /// pay of the player of columns
            b[rows, columns]: f64,
        }
        /// probability of a row
        var x[i in rows] >= 0.0 start 1.0 / rows.len() as f64;
        /// probability of a column
        var y[j in columns] >= 0.0 start 1.0 / columns.len() as f64;
        /// value of the game for the player of rows
        var v free;
        /// value of the game for the player of columns
        var w free;

        eq row[i in rows]: v >= sum(columns, |j| a[i, j] * y[j])      complements x[i];
        eq column[j in columns]: w >= sum(rows, |i| b[i, j] * x[i])   complements y[j];
        eq some_row: sum(rows, |i| x[i]) == 1.0                       complements v;
        eq some_column: sum(columns, |j| y[j]) == 1.0                 complements w;
    }
}

impl Bimatrix {
    /// A game with these pays.
    pub(crate) fn game<const M: usize, const N: usize>(
        rows: [&str; M],
        columns: [&str; N],
        a: [[f64; N]; M],
        b: [[f64; N]; M],
    ) -> Result<Self, ModelError> {
        Bimatrix::builder().rows(rows).columns(columns).a(a).b(b).build()
    }
}

/// The tram: riders against the company.
pub(crate) fn inspection() -> Result<Bimatrix, ModelError> {
    Bimatrix::game(
        ["buy", "dodge"],
        ["inspect", "wait"],
        [[-3.0, -3.0], [-60.0, 0.0]],
        [[1.0, 3.0], [58.0, 0.0]],
    )
}

/// The example of von Stengel.
pub(crate) fn published() -> Result<Bimatrix, ModelError> {
    Bimatrix::game(["top", "middle", "bottom"], ["left", "right"], A, B)
}

pub(crate) const A: [[f64; 2]; 3] = [[3.0, 3.0], [2.0, 5.0], [0.0, 6.0]];
pub(crate) const B: [[f64; 2]; 3] = [[3.0, 2.0], [2.0, 6.0], [3.0, 1.0]];

/// Its equilibria: three probabilities of rows, two of columns.
pub(crate) const EQUILIBRIA: [[f64; 5]; 3] = [
    [1.0, 0.0, 0.0, 1.0, 0.0],
    [4.0 / 5.0, 1.0 / 5.0, 0.0, 2.0 / 3.0, 1.0 / 3.0],
    [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0],
];

/// What the players could gain by their best replies.
pub(crate) fn regrets(view: &BimatrixView) -> [f64; 2] {
    let (x, y) = (view.x.values(), view.y.values());
    let (a, b) = (view.a.values(), view.b.values());
    let (rows, columns) = (0..x.len(), 0..y.len());
    let at = |i: usize, j: usize| i * y.len() + j;
    let row = |i: usize| columns.clone().map(|j| a[at(i, j)] * y[j]).sum::<f64>();
    let column = |j: usize| rows.clone().map(|i| b[at(i, j)] * x[i]).sum::<f64>();
    let paid = rows.clone().map(|i| x[i] * row(i)).sum::<f64>();
    let other = columns.clone().map(|j| y[j] * column(j)).sum::<f64>();
    [
        rows.clone().map(row).fold(f64::NEG_INFINITY, f64::max) - paid,
        columns.clone().map(column).fold(f64::NEG_INFINITY, f64::max) - other,
    ]
}

/// Starts at the point where both players are sure of their choices, which pay `v` and `w`.
pub(crate) fn start_sure(
    game: &mut Bimatrix,
    [row, column]: [&str; 2],
    [v, w]: [f64; 2],
) -> Result<(), ModelError> {
    for (name, start) in [("x", 0.0), ("y", 0.0), ("v", v), ("w", w)] {
        game.set_start_of(name, start)?;
    }
    game.set_start_of(&format!("x[{row}]"), 1.0)?;
    game.set_start_of(&format!("y[{column}]"), 1.0)
}

fn main() -> Result<(), Box<dyn Error>> {
    let tram = inspection()?;
    let solution = solve(&tram, &Options::default())?.solved()?;
    println!("{}", Report::new(&mut AdProblem::new(&tram)?, &solution)?.named("tram"));
    let view = tram.view(&solution)?;
    close(view.y["inspect"], 1.0 / 20.0);
    close(view.x["dodge"], 1.0 / 30.0);
    close(view.v, -3.0);
    close(view.w, 3.0 * 29.0 / 30.0);
    check_best_replies(&view);

    let mut game = published()?;
    let mut found = [false; 3];
    println!("start          top middle bottom   left  right     v      w");
    for (i, row) in ["top", "middle", "bottom"].into_iter().enumerate() {
        for (j, column) in ["left", "right"].into_iter().enumerate() {
            start_sure(&mut game, [row, column], [A[i][j], B[i][j]])?;
            let solution = solve(&game, &Options::new(Method::NewtonFb))?.solved()?;
            let view = game.view(&solution)?;
            check_best_replies(&view);
            print!("{row:<6} {column:<5}");
            solution.z.iter().for_each(|z| print!("{:>7.3}", z + 0.0));
            println!();
            let near = |z: &[f64; 5]| z.iter().zip(&solution.z).all(|(a, b)| (a - b).abs() < 1e-9);
            let k = EQUILIBRIA.iter().position(near).ok_or("not a published equilibrium")?;
            found[k] = true;
        }
    }
    assert_eq!(found, [true; 3]);
    Ok(())
}

fn check_best_replies(view: &BimatrixView) {
    assert!(regrets(view).into_iter().all(|gain| gain < 1e-8));
}

fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
}
