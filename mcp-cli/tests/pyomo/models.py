"""Models of pyomo.mpec, solved by `mcp` through Pyomo's interface to AMPL solvers.

usage: python models.py EXECUTABLE

Every model is written by both nl writers of Pyomo, with and without symbolic names, solved by the
executable, and its values are read back by Pyomo from the .sol file. What is expected is published
or in closed form, and stands beside each model. Prints a line for each solve; exits with 1 if one is
not as expected.
"""

import os
import sys

import pyomo.environ as pyo
from pyomo.mpec import Complementarity, ComplementarityList, complements
from pyomo.opt import SolverStatus, TerminationCondition, WriterFactory, check_optimal_termination

TOLERANCE = 1e-6


def kojima_shindo():
    """Four polynomials of Kojima and Shindo: two solutions, (1, 0, 3, 0) and (sqrt(6)/2, 0, 0, 1/2)."""
    m = pyo.ConcreteModel()
    m.x = pyo.Var([1, 2, 3, 4], initialize={1: 1, 2: 0.5, 3: 1, 4: 0})
    a, b, c, d = (m.x[i] for i in (1, 2, 3, 4))
    f = {
        1: 3 * a**2 + 2 * a * b + 2 * b**2 + c + 3 * d - 6,
        2: 2 * a**2 + a + b**2 + 10 * c + 2 * d - 2,
        3: 3 * a**2 + a * b + 2 * b**2 + 2 * c + 9 * d - 9,
        4: a**2 + 3 * b**2 + 2 * c + 3 * d - 3,
    }
    m.pairs = Complementarity([1, 2, 3, 4], rule=lambda m, i: complements(f[i] >= 0, m.x[i] >= 0))
    return m, [[(m.x, (1, 0, 3, 0))], [(m.x, (6**0.5 / 2, 0, 0, 0.5))]]


def transport():
    """Dantzig's transport problem with prices: cost 153.675 thousand dollars; shipments not unique."""
    capacity = {"seattle": 350, "san-diego": 600}
    demand = {"new-york": 325, "chicago": 300, "topeka": 275}
    miles = {"seattle": (2.5, 1.7, 1.8), "san-diego": (2.5, 1.8, 1.4)}
    cost = {(i, j): 0.09 * d for i in capacity for j, d in zip(demand, miles[i])}
    m = pyo.ConcreteModel()
    m.x = pyo.Var(list(cost), initialize=100)
    m.w = pyo.Var(list(capacity), initialize=0)
    m.p = pyo.Var(list(demand), initialize=0.2)
    m.profit = Complementarity(
        list(cost), rule=lambda m, i, j: complements(m.w[i] + cost[i, j] - m.p[j] >= 0, m.x[i, j] >= 0)
    )
    m.supply = Complementarity(
        list(capacity),
        rule=lambda m, i: complements(capacity[i] >= sum(m.x[i, j] for j in demand), m.w[i] >= 0),
    )
    m.market = Complementarity(
        list(demand),
        rule=lambda m, j: complements(sum(m.x[i, j] for i in capacity) >= demand[j], m.p[j] >= 0),
    )
    m.cost = pyo.Expression(expr=sum(cost[k] * m.x[k] for k in cost))
    return m, [[(m.p, (0.225, 0.153, 0.126)), (m.cost, (153.675,))]]


def nash_game():
    """Cournot, price 100 - Q: p = (100 + 10 + 20 + 30)/4 = 40, q = p - c; who costs 90 stays out."""
    cost = {1: 10, 2: 20, 3: 30, 4: 90}
    m = pyo.ConcreteModel()
    m.q = pyo.Var(list(cost), initialize=5)
    m.price = pyo.Expression(expr=100 - sum(m.q[i] for i in cost))
    m.firms = Complementarity(
        list(cost), rule=lambda m, i: complements(cost[i] - m.price + m.q[i] >= 0, m.q[i] >= 0)
    )
    return m, [[(m.q, (30, 20, 10, 0)), (m.price, (40,))]]


def equality_rows():
    """Projection of a = (0.8, 0.6, -0.5) onto the simplex: x = max(a - y, 0) with y = 0.2."""
    a = {1: 0.8, 2: 0.6, 3: -0.5}
    m = pyo.ConcreteModel()
    m.x = pyo.Var(list(a), initialize=0)
    m.y = pyo.Var(initialize=0)
    m.total = pyo.Constraint(expr=sum(m.x[i] for i in a) == 1)
    m.pairs = ComplementarityList(
        rule=(complements(m.x[i] - a[i] + m.y >= 0, m.x[i] >= 0) for i in a)
    )
    return m, [[(m.x, (0.6, 0.4, 0)), (m.y, (0.2,))]]


def double_bounds():
    """Plants with capacities serve 100: two are full and earn rents, the third sets p = 60 + 0.1 * 10.

    Pyomo 6.10 cannot write l <= q <= u with its equation: its transformation to .nl fails, and its
    writers leave out rows without bounds. So a pair for each bound, the rent going with the upper one.
    """
    plants = {"old": (50, 10), "new": (40, 20), "peak": (60, 60)}
    m = pyo.ConcreteModel()
    m.q = pyo.Var(list(plants), initialize=1)
    m.rent = pyo.Var(list(plants), initialize=0)
    m.p = pyo.Var(initialize=1)
    m.profit = Complementarity(
        list(plants),
        rule=lambda m, i: complements(
            plants[i][1] + 0.1 * m.q[i] + m.rent[i] - m.p >= 0, m.q[i] >= 0
        ),
    )
    m.limit = Complementarity(
        list(plants), rule=lambda m, i: complements(m.q[i] <= plants[i][0], m.rent[i] >= 0)
    )
    m.balance = pyo.Constraint(expr=sum(m.q[i] for i in plants) == 100)
    return m, [[(m.q, (50, 40, 10)), (m.rent, (46, 37, 0)), (m.p, (61,))]]


def free_variables():
    """exp(x) + y = 3, x + y^2 = 4 at (0, 2), x and y free; z = x + y - 1 > 0."""
    m = pyo.ConcreteModel()
    m.x = pyo.Var(initialize=0.3)
    m.y = pyo.Var(initialize=1.5)
    m.z = pyo.Var(initialize=0)
    m.first = pyo.Constraint(expr=pyo.exp(m.x) + m.y == 3)
    m.second = pyo.Constraint(expr=m.x + m.y**2 == 4)
    m.third = Complementarity(expr=complements(m.z - m.x - m.y + 1 >= 0, m.z >= 0))
    return m, [[(m.x, (0,)), (m.y, (2,)), (m.z, (1,))]]


def price_cap():
    """Demand 100 - p, supply p, but p <= 30: there -F >= 0; 100 - 2 * 30 = 40 go without."""
    m = pyo.ConcreteModel()
    m.p = pyo.Var(initialize=1)
    m.shortage = pyo.Var(initialize=0)
    m.market = Complementarity(expr=complements(m.p <= 30, m.p - (100 - m.p) <= 0))
    m.rest = pyo.Constraint(expr=m.shortage == 100 - 2 * m.p)
    return m, [[(m.p, (30,)), (m.shortage, (40,))]]


def no_solution():
    """1 + x^2 = 0: proved to have no solution."""
    m = pyo.ConcreteModel()
    m.x = pyo.Var(initialize=1)
    m.row = pyo.Constraint(expr=1 + m.x**2 == 0)
    return m


def at_infinity():
    """exp(-x) = 0: smaller and smaller residuals, no solution."""
    m = pyo.ConcreteModel()
    m.x = pyo.Var(initialize=1)
    m.row = pyo.Constraint(expr=pyo.exp(-m.x) == 0)
    return m


MODELS = [
    kojima_shindo,
    transport,
    nash_game,
    equality_rows,
    double_bounds,
    free_variables,
    price_cap,
]
FAILURES = [
    (no_solution, {}, SolverStatus.warning, TerminationCondition.infeasible),
    (at_infinity, {}, SolverStatus.error, TerminationCondition.internalSolverError),
    (
        lambda: kojima_shindo()[0],
        {"max_iterations": 1},
        SolverStatus.warning,
        TerminationCondition.maxIterations,
    ),
]


def values(component):
    return [pyo.value(component[i]) for i in component]


def error(expected):
    """Largest deviation of a list of components with their values."""
    pairs = ((v, e) for component, es in expected for v, e in zip(values(component), es))
    return max(abs(v - e) for v, e in pairs)


def solver(executable):
    folder, name = os.path.split(os.path.abspath(executable))
    # As a user has it: the executable on the search path.
    os.environ["PATH"] = folder + os.pathsep + os.environ["PATH"]
    return pyo.SolverFactory("asl:" + os.path.splitext(name)[0])


def main(executable):
    opt = solver(executable)
    assert opt.available(), "Pyomo does not see the solver"
    print("version as Pyomo reads it:", ".".join(map(str, opt.version())))
    wrong = 0

    def line(name, how, text, is_right):
        nonlocal wrong
        wrong += not is_right
        print(f"{name:<15} {how:<18} {text}{'' if is_right else '   WRONG'}")

    for writer in ("nl_v1", "nl_v2"):
        WriterFactory.register("nl")(WriterFactory.get_class(writer))
        for labels in (False, True):
            how = writer + (" with names" if labels else "")
            for model in MODELS:
                m, solutions = model()
                results = opt.solve(m, symbolic_solver_labels=labels, options={"tol": 1e-8})
                deviation = min(error(expected) for expected in solutions)
                ends = f"{results.solver.status}, {results.solver.termination_condition}"
                is_right = check_optimal_termination(results) and deviation <= TOLERANCE
                line(model.__name__, how, f"{ends}, deviation {deviation:.1e}", is_right)
        for model, options, status, condition in FAILURES:
            results = opt.solve(model(), load_solutions=False, options=options)
            found = (results.solver.status, results.solver.termination_condition)
            is_right = found == (status, condition) and not check_optimal_termination(results)
            name = getattr(model, "__name__", "").replace("<lambda>", "iteration_limit")
            line(name, writer, f"{found[0]}, {found[1]}", is_right)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
