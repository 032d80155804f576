//! The cases of the table, and one run of a case.

use crate::doubled::Doubled;
use crate::models::{Membrane, Spring, Traffic, Transport};
use crate::roads::Roads;
use mcp_core::linalg::FaerSparseLu;
use mcp_core::{
    AdProblem, Grid, Method, Model, ModelError, MultigridCg, Options, Robust, Solution, Solver,
    Stage, solve_sequence, solve_sequence_with,
};
use std::time::{Duration, Instant};

/// A solve that takes longer is a miss.
const TIME_LIMIT: Duration = Duration::from_mins(2);

/// How a problem is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// From its own start.
    Cold(Method),
    /// From its own start, with simplicial factors, whose fill is known.
    Simplicial(Method),
    /// Coarse to fine, factorisations.
    Nested(Method),
    /// Coarse to fine, multigrid CG.
    Multigrid,
    /// From its own start, by one stage of `Robust`.
    Alone(Stage),
}

/// What is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The linear obstacle problem on `k × k` nodes.
    Membrane,
    /// The nonlinear one.
    Spring,
    /// Transport between `k` regions.
    Transport,
    /// Traffic on 20 × 25 crossings to `k` places, from successive averages.
    Traffic,
    /// A membrane with every equation twice, `2k²` variables: what Levenberg–Marquardt steps are for.
    Doubled,
}

/// A line of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) kind: Kind,
    pub(crate) k: usize,
    pub(crate) way: Way,
    /// Seconds and megabytes to reach.
    pub(crate) reach: (Option<f64>, Option<f64>),
}

const fn case(kind: Kind, k: usize, way: Way, reach: (Option<f64>, Option<f64>)) -> Case {
    Case { kind, k, way, reach }
}

use Kind::{Membrane as M, Spring as S};
use Method::{NewtonFb, NewtonMinFb};
use Way::{Alone, Cold, Multigrid, Nested, Simplicial};

/// Every line, in order.
pub(crate) const CASES: [Case; 40] = [
    case(M, 40, Cold(NewtonMinFb), (Some(0.020), None)),
    case(M, 40, Cold(Method::Robust), (Some(0.020), None)),
    case(S, 40, Cold(Method::Robust), (Some(0.020), None)),
    case(M, 150, Cold(NewtonMinFb), (Some(1.2), None)),
    case(M, 150, Cold(Method::Robust), (Some(1.2), None)),
    case(S, 150, Cold(Method::Robust), (Some(1.2), None)),
    case(M, 300, Cold(NewtonFb), (Some(6.0), None)),
    case(M, 300, Cold(NewtonMinFb), (Some(6.0), None)),
    case(M, 300, Cold(Method::Robust), (Some(6.0), None)),
    case(S, 300, Cold(Method::Robust), (Some(6.0), None)),
    case(M, 300, Nested(NewtonMinFb), (Some(1.0), None)),
    case(S, 300, Nested(NewtonMinFb), (Some(1.0), None)),
    case(S, 300, Nested(Method::Robust), (Some(1.0), None)),
    case(S, 100, Nested(NewtonMinFb), (None, None)),
    case(S, 1000, Nested(NewtonMinFb), (Some(45.0), Some(1000.0))),
    case(M, 1000, Nested(NewtonMinFb), (Some(45.0), Some(1000.0))),
    case(M, 300, Multigrid, (Some(1.0), None)),
    case(S, 300, Multigrid, (Some(1.0), None)),
    case(S, 100, Multigrid, (None, None)),
    case(S, 316, Multigrid, (None, None)),
    case(S, 511, Multigrid, (None, None)),
    case(S, 1000, Multigrid, (None, None)),
    case(S, 1023, Multigrid, (Some(5.0), Some(250.0))),
    case(M, 1023, Multigrid, (Some(5.0), Some(250.0))),
    case(Kind::Transport, 300, Cold(Method::Robust), (None, None)),
    case(Kind::Traffic, 4, Cold(NewtonFb), (None, None)),
    case(Kind::Traffic, 4, Cold(NewtonMinFb), (None, None)),
    case(Kind::Traffic, 4, Simplicial(NewtonFb), (None, None)),
    case(Kind::Traffic, 10, Cold(NewtonFb), (None, None)),
    case(S, 316, Alone(Stage::Crash), (None, None)),
    case(S, 316, Alone(Stage::Semismooth), (None, None)),
    case(S, 316, Alone(Stage::Sized), (None, None)),
    case(S, 316, Alone(Stage::Smoothing), (None, None)),
    case(S, 316, Alone(Stage::Penalised), (None, None)),
    case(S, 316, Alone(Stage::Boxes), (None, None)),
    case(S, 316, Alone(Stage::Rescaled), (None, None)),
    case(S, 316, Alone(Stage::Proximal), (None, None)),
    case(S, 316, Alone(Stage::Starts), (None, None)),
    case(S, 316, Alone(Stage::Backtracking), (None, None)),
    case(Kind::Doubled, 224, Alone(Stage::Semismooth), (None, None)),
];

/// `Robust` with nothing but this stage.
fn alone(stage: Stage, options: &mut Robust) {
    let budgets = [
        (Stage::Crash, &mut options.crash),
        (Stage::Semismooth, &mut options.semismooth),
        (Stage::Sized, &mut options.sized),
        (Stage::Smoothing, &mut options.smoothing),
        (Stage::Penalised, &mut options.penalised),
        (Stage::Boxes, &mut options.boxes),
        (Stage::Rescaled, &mut options.rescale),
        (Stage::Proximal, &mut options.proximal),
        (Stage::Starts, &mut options.starts),
        (Stage::Backtracking, &mut options.backtracking),
    ];
    for (other, budget) in budgets {
        if other != stage {
            *budget = 0;
        }
    }
    (options.josephy_first, options.josephy) = (0, 0);
}

impl Case {
    /// Such as `spring 300 nested newton_min_fb`.
    pub(crate) fn name(&self) -> String {
        let kind = match self.kind {
            Kind::Membrane => "membrane",
            Kind::Spring => "spring",
            Kind::Transport => "transport",
            Kind::Traffic => "traffic",
            Kind::Doubled => "doubled",
        };
        let way = match self.way {
            Cold(method) => format!("cold {method}"),
            Simplicial(method) => format!("simplicial {method}"),
            Nested(method) => format!("nested {method}"),
            Multigrid => "nested multigrid".to_owned(),
            Alone(stage) => format!("{stage} alone"),
        };
        format!("{kind} {} {way}", self.k)
    }

    /// Solves it.
    pub(crate) fn run(&self) -> Result<Run, ModelError> {
        let began = Instant::now();
        let solutions = match self.kind {
            Kind::Membrane => self.on_grids(Membrane::on, 0.0)?,
            Kind::Spring => self.on_grids(Spring::on, 0.3)?,
            Kind::Transport => vec![self.cold(&Transport::between(self.k)?, None)?],
            Kind::Traffic => {
                let roads = Roads::grid(20, 25, self.k);
                vec![self.cold(&Traffic::on(&roads)?, Some(roads.start()))?]
            }
            Kind::Doubled => vec![self.cold(&Doubled::on(self.k)?, None)?],
        };
        let seconds = began.elapsed().as_secs_f64();
        Ok(Run { seconds, cpu: cpu_seconds(), megabytes: peak_memory(), solutions })
    }

    fn cold<M: Model>(&self, model: &M, start: Option<Vec<f64>>) -> Result<Solution, ModelError> {
        let method = match self.way {
            Cold(method) | Simplicial(method) | Nested(method) => method,
            Multigrid => NewtonMinFb,
            Alone(_) => Method::Robust,
        };
        let mut solver = match self.way {
            Simplicial(_) => Solver::with_linear_solver(
                options(self, method),
                Box::new(FaerSparseLu::simplicial()),
            )?,
            _ => Solver::new(options(self, method))?,
        };
        let mut problem = AdProblem::new(model)?;
        if self.way == Alone(Stage::Boxes) {
            // The stage is for two-sided boxes.
            let lower = problem.shape().bounds().lower().to_vec();
            problem.set_bounds(&lower, &vec![1.0; lower.len()])?;
        }
        let solution = match start {
            Some(start) => solver.solve_from(&mut problem, &start),
            None => solver.solve(&mut problem),
        };
        solution.cloned()
    }

    fn on_grids<M: Model>(
        &self,
        model: impl Fn(usize) -> Result<M, ModelError>,
        rim: f64,
    ) -> Result<Vec<Solution>, ModelError> {
        // From about 15 × 15 nodes.
        let mut levels = vec![Grid::square(self.k)];
        while let Some(coarser) = levels.last().and_then(|grid| grid.coarser())
            && coarser.rows >= 15
        {
            levels.push(coarser);
        }
        levels.reverse();
        let models = levels.iter().map(|grid| model(grid.rows));
        let square = |fine: &M| Grid::square(fine.shape().n().isqrt());
        let prolong = |coarse: &Solution, fine: &M| {
            square(fine).interpolate(&coarse.z, Grid::square(coarse.z.len().isqrt()), rim)
        };
        match self.way {
            Cold(_) | Simplicial(_) | Alone(_) => Ok(vec![self.cold(&model(self.k)?, None)?]),
            Nested(method) => solve_sequence(models, prolong, &options(self, method)),
            Multigrid => solve_sequence_with(models, prolong, |fine| {
                let linear = Box::new(MultigridCg::new(square(fine)));
                Solver::with_linear_solver(options(self, NewtonMinFb), linear)
            }),
        }
    }
}

/// On grids `F` is a force at a node: the absolute residual has to be a millionth of the load `10 h²`.
fn options(case: &Case, method: Method) -> Options {
    Options::new(method).with(|o| {
        o.max_iterations = 1000;
        o.time_limit = Some(TIME_LIMIT);
        if let Alone(stage) = case.way {
            alone(stage, &mut o.robust);
        }
        if matches!(case.kind, M | S) {
            o.tol = Some(1e-5 / ((case.k + 1) * (case.k + 1)) as f64);
        }
    })
}

/// What a run took.
pub(crate) struct Run {
    pub(crate) seconds: f64,
    pub(crate) cpu: f64,
    pub(crate) megabytes: f64,
    pub(crate) solutions: Vec<Solution>,
}

/// Time this process has spent on a processor [s]; NaN where the system does not tell.
fn cpu_seconds() -> f64 {
    let statistics = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds =
        statistics.split_whitespace().next().and_then(|word| word.parse::<f64>().ok());
    nanoseconds.map_or(f64::NAN, |nanoseconds| nanoseconds * 1e-9)
}

/// Largest resident memory of this process so far [MB]; NaN where the system does not tell.
fn peak_memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.map_or(f64::NAN, |kilobytes| kilobytes / 1000.0)
}
