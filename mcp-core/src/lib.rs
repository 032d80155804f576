//! Mixed complementarity problems: find `z` with `l <= z <= u` such that, for every `i`,
//!
//! ```text
//! F_i(z) >= 0  where z_i = l_i,     F_i(z) = 0  where l_i < z_i < u_i,     F_i(z) <= 0  where z_i = u_i.
//! ```
//!
//! Economic equilibria, contact and friction, obstacle problems, games and KKT systems have this
//! form. A model is Rust code over generic numbers, written once; exact Jacobians come from that
//! text and feed Fischer–Burmeister Newton methods; an independent certificate judges the answer.
//!
//! ```
//! use mcp_core::{Options, Real, Scalar, mcp_fn, solve};
//!
//! /// Two firms with cost 1 a unit face the price 10 − q1 − q2:
//! /// marginal cost − marginal revenue ⟂ quantity >= 0.
//! #[mcp_fn(lower = 0.0)]
//! fn duopoly<D: Scalar>([q1, q2]: [Real<D>; 2]) -> [Real<D>; 2] {
//!     [1.0 - (10.0 - 2.0 * q1 - q2), 1.0 - (10.0 - q1 - 2.0 * q2)]
//! }
//!
//! let solution = solve(&Duopoly::new()?, &Options::default())?.solved()?;
//! assert!((solution.z[0] - 3.0).abs() < 1e-9 && (solution.z[1] - 3.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! From here, [`Report`] shows the answer by name, as text, CSV or JSON (feature `serde`);
//! [`check_derivatives`] checks every entry of the Jacobian in a one-line test, [`check_point`]
//! whether a benchmark is a solution; [`Options`] sets method and tolerances; a [`Solver`] is for many
//! solves; [`mcp!`](macro@mcp) is for models over index sets, whose sizes come from data.
//!
//! # Where to read on
//!
//! [`mcp!`](macro@mcp) the modelling language · [`language`] what its models are made of: data, sets,
//! views · [`kkt`] nonlinear programs by their optimality conditions ·
//! [`dynamics`] systems with contacts, friction, diodes and relays, step by step ·
//! [`economics`] cost functions, accounts, laws of economies · [`scalar`] numbers inside a model and their corners · [`model`] what the language and a
//! hand-written model become · [`problem`] exact derivatives and their pattern · [`solver`] methods, options, statuses, the
//! certificate · [`ncp`] complementarity functions · [`globalise`] line searches · [`linalg`]
//! linear systems · [`certify`](mod@certify) proofs that a solution is near · [`report`] tables by name · [`study`] sweeps over a parameter and comparisons.
//!
//! # References
//!
//! | key | source |
//! | --- | --- |
//! | \[AB08\] | V. Acary, B. Brogliato (2008), Numerical Methods for Nonsmooth Dynamical Systems. Springer |
//! | \[ADD89\] | M. Arioli, J. W. Demmel, I. S. Duff (1989), Solving sparse linear systems with sparse backward error. SIAM J. Matrix Anal. Appl. 10 |
//! | \[Ahn83\] | B.-H. Ahn (1983), Iterative methods for linear complementarity problems with upper bounds on primary variables. Math. Prog. 26 |
//! | \[Bar68\] | E. H. Bareiss (1968), Sylvester's identity and multistep integer-preserving Gaussian elimination. Math. Comp. 22 |
//! | \[Ber82\] | D. P. Bertsekas (1982), Projected Newton methods for optimization problems with simple constraints. SIAM J. Control Optim. 20 |
//! | \[BG12\] | I. Ben Gharbia, J. C. Gilbert (2012), Nonconvergence of the plain Newton-min algorithm for linear complementarity problems with a P-matrix. Math. Prog. 134 |
//! | \[BHM00\] | W. L. Briggs, V. E. Henson, S. F. McCormick (2000), A Multigrid Tutorial, 2nd ed. SIAM |
//! | \[Bil95\] | S. C. Billups (1995), Algorithms for complementarity problems and generalized equations. PhD thesis, Wisconsin |
//! | \[CCK00\] | B. Chen, X. Chen, C. Kanzow (2000), A penalized Fischer–Burmeister NCP-function. Math. Prog. 88 |
//! | \[CPR74\] | A. R. Curtis, M. J. D. Powell, J. K. Reid (1974), On the estimation of sparse Jacobian matrices. IMA J. Appl. Math. 13 |
//! | \[CPS92\] | R. W. Cottle, J.-S. Pang, R. E. Stone (1992), The Linear Complementarity Problem. Academic Press |
//! | \[CR72\] | A. R. Curtis, J. K. Reid (1972), On the automatic scaling of matrices for Gaussian elimination. IMA J. Appl. Math. 10 |
//! | \[DF95\] | S. P. Dirkse, M. C. Ferris (1995), MCPLIB: a collection of nonlinear mixed complementarity problems. Optim. Methods Softw. 5 |
//! | \[DF97\] | S. P. Dirkse, M. C. Ferris (1997), Crash techniques for large-scale complementarity problems. In: Complementarity and Variational Problems: State of the Art, SIAM |
//! | \[DFK96\] | T. De Luca, F. Facchinei, C. Kanzow (1996), A semismooth equation approach to the solution of nonlinear complementarity problems. Math. Prog. 75 |
//! | \[DM02\] | E. D. Dolan, J. J. Moré (2002), Benchmarking optimization software with performance profiles. Math. Prog. 91 |
//! | \[DS96\] | J. E. Dennis, R. B. Schnabel (1996), Numerical Methods for Unconstrained Optimization and Nonlinear Equations. SIAM (first 1983) |
//! | \[EW96\] | S. C. Eisenstat, H. F. Walker (1996), Choosing the forcing terms in an inexact Newton method. SIAM J. Sci. Comput. 17 |
//! | \[Fat79\] | Y. Fathi (1979), Computational complexity of LCPs associated with positive definite symmetric matrices. Math. Prog. 17 |
//! | \[FFG99\] | M. C. Ferris, R. Fourer, D. M. Gay (1999), Expressing complementarity problems in an algebraic modeling language and communicating them to solvers. SIAM J. Optim. 9 |
//! | \[Fis92\] | A. Fischer (1992), A special Newton-type optimization method. Optimization 24 |
//! | \[FKM99\] | M. C. Ferris, C. Kanzow, T. S. Munson (1999), Feasible descent algorithms for mixed complementarity problems. Math. Prog. 86 |
//! | \[FP03\] | F. Facchinei, J.-S. Pang (2003), Finite-Dimensional Variational Inequalities and Complementarity Problems. Springer |
//! | \[Gay05\] | D. M. Gay (2005), Writing .nl files. Sandia National Laboratories SAND2005-7907P |
//! | \[Gay97\] | D. M. Gay (1997), Hooking your solver to AMPL. Bell Laboratories Technical Report 97-4-06 |
//! | \[GLL86\] | L. Grippo, F. Lampariello, S. Lucidi (1986), A nonmonotone line search technique for Newton's method. SIAM J. Numer. Anal. 23 |
//! | \[GV13\] | G. H. Golub, C. F. Van Loan (2013), Matrix Computations, 4th ed. Johns Hopkins |
//! | \[GW08\] | A. Griewank, A. Walther (2008), Evaluating Derivatives, 2nd ed. SIAM |
//! | \[Hig88\] | N. J. Higham (1988), FORTRAN codes for estimating the one-norm of a real or complex matrix, with applications to condition estimation. ACM Trans. Math. Softw. 14 |
//! | \[HK73\] | J. E. Hopcroft, R. M. Karp (1973), An n^(5/2) algorithm for maximum matchings in bipartite graphs. SIAM J. Comput. 2 |
//! | \[HS81\] | W. Hock, K. Schittkowski (1981), Test Examples for Nonlinear Programming Codes. Springer |
//! | \[Jean99\] | M. Jean (1999), The non-smooth contact dynamics method. Comput. Methods Appl. Mech. Eng. 177 |
//! | \[JMP17\] | M. Joldes, J.-M. Muller, V. Popescu (2017), Tight and rigorous error bounds for basic building blocks of double-word arithmetic. ACM Trans. Math. Softw. 44 |
//! | \[Jos79\] | N. H. Josephy (1979), Newton's method for generalized equations. MRC Technical Summary Report 1965, Wisconsin |
//! | \[Kan96\] | C. Kanzow (1996), Some noninterior continuation methods for linear complementarity problems. SIAM J. Matrix Anal. Appl. 17 |
//! | \[KK98\] | C. Kanzow, H. Kleinmichel (1998), A new class of semismooth Newton-type methods for nonlinear complementarity problems. Comput. Optim. Appl. 11 |
//! | \[Kor94\] | R. Kornhuber (1994), Monotone multigrid methods for elliptic variational inequalities I. Numer. Math. 69 |
//! | \[KP04\] | C. Kanzow, S. Petra (2004), On a semismooth least squares formulation of complementarity problems with gap reduction. Optim. Methods Softw. 19 |
//! | \[Kra69\] | R. Krawczyk (1969), Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken. Computing 4 |
//! | \[Mat85\] | L. Mathiesen (1985), Computation of economic equilibria by a sequence of linear complementarity problems. Math. Prog. Study 23 |
//! | \[MGH81\] | J. J. Moré, B. S. Garbow, K. E. Hillstrom (1981), Testing unconstrained optimization software. ACM Trans. Math. Softw. 7 |
//! | \[Moo66\] | R. E. Moore (1966), Interval Analysis. Prentice-Hall |
//! | \[Mor88\] | J. J. Moreau (1988), Unilateral contact and dry friction in finite freedom dynamics. In: Nonsmooth Mechanics and Applications, CISM 302, Springer |
//! | \[Mur78\] | K. G. Murty (1978), Computational complexity of complementary pivot methods. Math. Prog. Study 7 |
//! | \[MW09\] | J. J. Moré, S. M. Wild (2009), Benchmarking derivative-free optimization algorithms. SIAM J. Optim. 20 |
//! | \[Neu90\] | A. Neumaier (1990), Interval Methods for Systems of Equations. Cambridge |
//! | \[NW06\] | J. Nocedal, S. J. Wright (2006), Numerical Optimization, 2nd ed. Springer |
//! | \[Rob80\] | S. M. Robinson (1980), Strongly regular generalized equations. Math. Oper. Res. 5 |
//! | \[Rui01\] | D. Ruiz (2001), A scaling algorithm to equilibrate both rows and columns norms in matrices. RAL-TR-2001-034 |
//! | \[Rut99\] | T. F. Rutherford (1999), Applied general equilibrium modeling with MPSGE as a GAMS subsystem. Comput. Econ. 14 |
//! | \[Sch86\] | A. Schrijver (1986), Theory of Linear and Integer Programming. Wiley |
//! | \[SLF14\] | G. L. Steele, D. Lea, C. H. Flood (2014), Fast splittable pseudorandom number generators. OOPSLA |
//! | \[Van95\] | R. J. Vanderbei (1995), Symmetric quasidefinite matrices. SIAM J. Optim. 5 |
//! | \[ZH04\] | H. Zhang, W. W. Hager (2004), A nonmonotone line search technique and its application to unconstrained optimization. SIAM J. Optim. 14 |

// Generated code and doctests name this crate from outside and from inside alike.
extern crate self as mcp_core;

#[doc(hidden)]
#[path = "private.rs"]
pub mod __private;
#[cfg(feature = "testing")]
pub mod accuracy;
mod apart;
pub mod certify;
pub mod dynamics;
pub mod economics;
pub mod error;
mod generic;
pub mod globalise;
pub mod kkt;
pub mod language;
pub mod linalg;
pub mod model;
pub mod ncp;
pub mod problem;
pub mod report;
pub mod scalar;
pub mod solver;
pub mod study;
#[cfg(feature = "testing")]
pub mod testing;

pub use certify::{Accuracy, Degeneracy, Infeasible, Proof, Refusal, Weakest, certify, infeasible};
pub use error::ModelError;
pub use globalise::{Armijo, Nonmonotone, Stall};
pub use linalg::{Grid, Linear, LinearError, LinearSolver, MultigridCg};
pub use model::{
    Block, BoundKind, Bounds, Definition, Equation, Family, Model, Parameter, Reader, Set, Shape,
    ShapeBuilder, Values, Variable,
};
pub use problem::{
    AdProblem, Comparison, Counting, DerivativeReport, Derived, Engine, Passes, Pattern, Problem,
    WrongDerivative, check_derivatives,
};
pub use report::{
    DerivedKind, DerivedRow, IterationLog, IterationRecord, IterationTable, Report, ReportError,
    ReportRow, State, Statement, Statistics,
};
pub use scalar::{
    Counted, Interval, Jet, Magnitude, OperationCounts, Real, Scalar, Tally, Total, Trace, atan2,
    external, hypot, logsumexp, max, min, prod, select, smooth_max, smooth_min, sum, when,
};
pub use solver::{
    Certificate, Criterion, Descent, Diagnosis, Direction, DomainFault, Fill, Iteration, Method,
    Monitor, NotSolved, Options, PointCheck, PointRow, Robust, Solution, Solver, Stage, StageEnd,
    StageRecord, Stats, Status, UnknownMethod, Verdict, Violation, WrongPoint, check_point,
    examine, solve, solve_from, solve_sequence, solve_sequence_with,
};
#[cfg(feature = "rayon")]
pub use solver::{batch, solve_batch};

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
struct Readme;

/// Makes a model of a function of fixed size.
///
/// The function keeps its name and can still be called; the type it adds has the same name in
/// upper camel case, implements [`Model`] and is made by `new()`, which checks the bounds.
/// Variables are named after the pattern, `[x1, x2]`, and their equations `f[x1]`, `f[x2]`; with
/// one name for the whole array, `z`, they are `z[1]`, … and `f[1]`, ….
///
/// Arguments, all optional: `lower`, `upper` (default: free) and `start` (default 0), each a number
/// for all variables or an array with one for each; `crate = path` where this crate has another
/// name.
///
/// ```
/// use mcp_core::{Model, ModelError, Real, Scalar, mcp_fn};
///
/// /// Four equations of Kojima and Shindo with two solutions.
/// #[mcp_fn(lower = 0.0, start = [1, 0.5, 1, 0])]
/// pub fn kojima_shindo<D: Scalar>([x1, x2, x3, x4]: [Real<D>; 4]) -> [Real<D>; 4] {
///     [
///         3 * x1 * x1 + 2 * x1 * x2 + 2 * x2 * x2 + x3 + 3 * x4 - 6,
///         2 * x1 * x1 + x1 + x2 * x2 + 10 * x3 + 2 * x4 - 2,
///         3 * x1 * x1 + x1 * x2 + 2 * x2 * x2 + 2 * x3 + 9 * x4 - 9,
///         x1 * x1 + 3 * x2 * x2 + 2 * x3 + 3 * x4 - 3,
///     ]
/// }
///
/// let model = KojimaShindo::new()?;
/// assert_eq!(model.shape().n(), 4);
/// assert_eq!(model.shape().variable_name(1), "x2");
/// assert_eq!(model.shape().equation_name(1), "f[x2]");
/// assert_eq!(model.shape().start(), [1.0, 0.5, 1.0, 0.0]);
///
/// // The function itself can still be called.
/// let f = kojima_shindo([1.0, 0.0, 3.0, 0.0].map(Real::<f64>::from));
/// assert_eq!(f.map(Real::into_scalar), [0.0, 31.0, 0.0, 4.0]);
/// # Ok::<(), ModelError>(())
/// ```
#[cfg(feature = "macros")]
pub use mcp_macros::mcp_fn;

/// The modelling language: a model of named families over index sets, as a type.
///
/// ```
/// use mcp_core::{Model, Options, Report, AdProblem, mcp, solve};
///
/// mcp! {
///     /// Plants supply markets at least cost.
///     pub model Transport {
///         data { plants: Set, markets: Set, capacity[plants]: f64, demand[markets]: f64, cost[plants, markets]: f64 }
///         /// shipment [cases]
///         var x[i in plants, j in markets] >= 0.0;
///         /// shadow price of capacity [$/case]
///         var w[i in plants] >= 0.0;
///         /// delivered price [$/case]
///         var p[j in markets] >= 0.0;
///
///         eq profit[i in plants, j in markets]: w[i] + cost[i, j] - p[j]      complements x[i, j];
///         eq supply[i in plants]: capacity[i] >= sum(markets, |j| x[i, j])    complements w[i];
///         eq market[j in markets]: sum(plants, |i| x[i, j]) >= demand[j]      complements p[j];
///         report spending: sum(markets, |j| p[j] * demand[j]);
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let mut model = Transport::builder()
///     .plants(["seattle", "san-diego"])
///     .markets(["new-york", "chicago"])
///     .capacity([5.0, 4.0])
///     .demand([("chicago", 4.0), ("new-york", 2.0)]) // in any order, by name
///     .cost([[2.5, 1.7], [2.5, 1.8]])
///     .build()?;
/// model.set_start_of("p", 2.0)?;
///
/// let solution = solve(&model, &Options::default())?.solved()?;
/// let view = model.view(&solution)?;
/// assert!((view.p["chicago"] - view.p["new-york"] + 0.8).abs() < 1e-9);
/// assert!((view.x[("seattle", "chicago")] + view.x[("san-diego", "chicago")] - 4.0).abs() < 1e-8);
/// println!("{}", Report::new(&mut AdProblem::new(&model)?, &solution)?);
/// # Ok(())
/// # }
/// ```
///
/// A misspelt name, an unpaired variable, swapped indices, a sign against its bound: each is one
/// error of the compiler at the word where it stands.
///
/// An effect that brings unknowns is a `part`: it exists only where it is switched on.
///
/// ```
/// use mcp_core::{Model, Options, mcp, solve};
///
/// mcp! {
///     /// Coal and gas sell power.
///     model Power {
///         data { plants: Set, dirty: Subset(plants), cost[plants]: f64, slope: f64, demand: f64 }
///         var q[i in plants] >= 0.0;
///         var p >= 0.0;
///         def unit_cost[i in plants]: cost[i] + slope * q[i];
///         eq profit[i in plants]: unit_cost[i] - p            complements q[i];
///         eq market: sum(plants, |i| q[i]) >= demand - p      complements p;
///         /// A cap on emissions, with permits.
///         part cap {
///             data { limit: f64, rate[dirty]: f64 }
///             /// price of a permit [$/t]
///             var permit >= 0.0;
///             eq emissions: limit >= sum(dirty, |i| rate[i] * q[i])   complements permit;
///             adds unit_cost[i in dirty]: rate[i] * permit;
///         }
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let free = Power::builder()
///     .plants(["coal", "gas"])
///     .dirty(["coal"])
///     .cost([2.0, 4.0])
///     .slope(1.0)
///     .demand(12.0)
///     .build()?;
/// let solution = solve(&free, &Options::default())?.solved()?;
/// let view = free.view(&solution)?;
/// assert_eq!((free.shape().n(), view.permit), (3, None));
/// assert!((view.q["coal"] - 4.0).abs() < 1e-9);
///
/// let capped = free.with(Cap { limit: 2.0, rate: [("coal", 1.0)] })?;
/// let solution = solve(&capped, &Options::default())?.solved()?;
/// let view = capped.view(&solution)?;
/// assert_eq!(capped.shape().n(), 4);
/// assert!((view.p - 7.0).abs() < 1e-9 && (view.permit.unwrap_or(0.0) - 3.0).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
#[cfg(feature = "macros")]
pub use mcp_macros::mcp;
