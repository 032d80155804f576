"""Writes the files of this directory that come from Pyomo.

    python3 -m venv pyomo-env && pyomo-env/bin/pip install pyomo==6.10.1
    pyomo-env/bin/python write_with_pyomo.py

Every model is turned into the form of .nl files by Pyomo's own transformation `mpec.nl`.
"""

import csv
import sys
from pathlib import Path

import pyomo.environ as pyo
from pyomo.mpec import Complementarity, complements

HERE = Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
HERE = HERE if HERE.is_dir() else HERE.parent


def write(model, name, names):
    pyo.TransformationFactory("mpec.nl").apply_to(model)
    path = str(HERE / f"{name}.nl")
    model.write(path, io_options={"symbolic_solver_labels": names})


def kojima_shindo():
    """Four equations of Kojima and Shindo with two solutions."""
    m = pyo.ConcreteModel("kojima_shindo")
    m.x = pyo.Var([1, 2, 3, 4], initialize={1: 1, 2: 0.5, 3: 1, 4: 0})
    x1, x2, x3, x4 = (m.x[i] for i in (1, 2, 3, 4))
    f = {
        1: 3 * x1**2 + 2 * x1 * x2 + 2 * x2**2 + x3 + 3 * x4 - 6,
        2: 2 * x1**2 + x1 + x2**2 + 10 * x3 + 2 * x4 - 2,
        3: 3 * x1**2 + x1 * x2 + 2 * x2**2 + 2 * x3 + 9 * x4 - 9,
        4: x1**2 + 3 * x2**2 + 2 * x3 + 3 * x4 - 3,
    }
    m.f = Complementarity([1, 2, 3, 4], rule=lambda m, i: complements(m.x[i] >= 0, f[i] >= 0))
    write(m, "kojima_shindo", names=True)


def transport():
    """Dantzig's transport problem with prices, from the tables of examples/data/transport."""
    data = Path(__file__).resolve().parent.parent / "transport"
    rows = {name: list(csv.reader(open(data / f"{name}.csv")))[1:] for name in ("plants", "markets", "distances")}
    capacity = {plant: float(a) for plant, a in rows["plants"]}
    demand = {market: float(b) for market, b in rows["markets"]}
    cost = {(i, j): 90 * float(d) / 1000 for i, j, d in rows["distances"]}

    m = pyo.ConcreteModel("transport")
    m.x = pyo.Var(capacity, demand, initialize=100)
    m.w = pyo.Var(capacity, initialize=0)
    m.p = pyo.Var(demand, initialize=0.2)
    m.profit = Complementarity(
        capacity, demand,
        rule=lambda m, i, j: complements(m.w[i] + cost[i, j] >= m.p[j], m.x[i, j] >= 0))
    m.supply = Complementarity(
        capacity,
        rule=lambda m, i: complements(capacity[i] >= sum(m.x[i, j] for j in demand), m.w[i] >= 0))
    m.market = Complementarity(
        demand,
        rule=lambda m, j: complements(sum(m.x[i, j] for i in capacity) >= demand[j], m.p[j] >= 0))
    write(m, "transport", names=True)


def nash():
    """Five firms of Murphy, Sherali and Soyster (1982); see examples/cournot.rs."""
    gamma, c, beta = 1.1, [10, 8, 6, 4, 2], [1.2, 1.1, 1.0, 0.9, 0.8]
    m = pyo.ConcreteModel("nash")
    m.q = pyo.Var(range(5), initialize=10)
    total = sum(m.q[i] for i in range(5))
    m.price = pyo.Expression(expr=(5000 / total) ** (1 / gamma))
    m.profit = Complementarity(
        range(5),
        rule=lambda m, i: complements(
            c[i] + (m.q[i] / 5) ** (1 / beta[i]) - m.price * (1 - m.q[i] / (gamma * total)) >= 0,
            m.q[i] >= 0))
    write(m, "nash", names=True)


def equations():
    """A pair of two expressions beside an equation: auxiliary variables and equality rows."""
    m = pyo.ConcreteModel("equations")
    m.x, m.y = pyo.Var(initialize=1), pyo.Var(initialize=1)
    m.pair = Complementarity(expr=complements(m.x + m.y >= 3, m.x - 2 * m.y <= 3))
    m.curve = pyo.Constraint(expr=m.x * pyo.exp(m.y) == 2)
    write(m, "equations", names=True)


def bounds():
    """A lower bound, an upper bound, and both.

    For `l <= x <= u complements g`, Pyomo 6.10.1's `mpec.nl` fails (it builds a constraint without
    bounds), so that the row is marked by hand as that transformation does it.
    """
    m = pyo.ConcreteModel("bounds")
    m.a, m.b, m.c = (pyo.Var(initialize=1) for _ in range(3))
    m.d = pyo.Var(bounds=(-1, 1), initialize=0)
    m.lower = Complementarity(expr=complements(m.a >= 2, m.a**2 + m.b >= 9))
    m.upper = Complementarity(expr=complements(m.b <= 4, m.a - m.b**3 >= -1))
    m.equality = Complementarity(expr=complements(m.c + m.a == 5, m.c))
    m.body = pyo.Var()
    m.slope = pyo.Constraint(expr=m.body == m.d - m.c)
    m.both = pyo.Constraint(expr=m.body >= 0)
    m.both._complementarity, m.both._vid = 3, id(m.d)
    write(m, "bounds", names=True)


def free():
    """Two nonlinear equations in two free variables."""
    m = pyo.ConcreteModel("free")
    m.x, m.y = pyo.Var(initialize=1), pyo.Var(initialize=2)
    m.circle = pyo.Constraint(expr=m.x**2 + m.y**2 == 4)
    m.wave = pyo.Constraint(expr=m.y == pyo.exp(m.x))
    write(m, "free", names=False)


for model in (kojima_shindo, transport, nash, equations, bounds, free):
    model()
