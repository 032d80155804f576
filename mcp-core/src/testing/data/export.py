"""Writes the data of `testing::collection` from the problems of the Python study (README.md).

    OPENBLAS_NUM_THREADS=1 python export.py FOLDER_OF_PROBLEMS_PY

random.bin   what numpy's generator gave: matrices, vectors, manufactured solutions, scalings
values.bin   of every instance: bounds, start, F there, a second point, F there (for the tests)

Both are sequences of records: length of the name (u16), name (UTF-8), count (u32), numbers (f64),
all little endian.
"""
import struct
import sys

import numpy as np

sys.path.insert(0, sys.argv[1])
import problems  # noqa: E402

INSTANCES = [p for f in problems.ALL + ["unsolvable"] for p in problems.family(f)]
NAMED = {p.name: p for p in INSTANCES}


def write(path, records):
    with open(path, "wb") as out:
        for name, numbers in records:
            name, numbers = name.encode(), np.ascontiguousarray(numbers, "<f8").ravel()
            out.write(struct.pack("<H", len(name)) + name + struct.pack("<I", len(numbers)) + numbers.tobytes())


def affine(p):
    """M and q of F = M z + q"""
    return p.J(np.zeros(p.n)), p.F(np.zeros(p.n))


def lcp_records(p, x, m_must_be, q_must_be):
    m, q = affine(p)
    assert np.array_equal(m, m_must_be) and np.array_equal(q, q_must_be), p.name
    return [(f"{p.name}/m", m), (f"{p.name}/q", q), (f"{p.name}/x", x)]


def contacts():
    """the stream of `physics()`, for the manufactured x"""
    rng = np.random.default_rng(5)
    for r, nc in [(6, 20), (12, 60)]:
        g = rng.standard_normal((nc, r))
        g = np.vstack([g, g[:nc // 2]])
        rng.standard_normal(r)
        x = rng.random(len(g)) * (rng.random(len(g)) < .2)
        m = g @ g.T
        w = rng.random(len(g)) * (x == 0)
        yield from lcp_records(NAMED[f"contact-r{r}-n{len(g)}"], x, m, w - m @ x)


def linear_programs():
    """the stream of `nlp_kkt()`: min c·x, A x >= b, x >= 0, with primal and dual solution"""
    rng = np.random.default_rng(3)
    for (n, m) in [(10, 6), (30, 20)]:
        a = rng.standard_normal((m, n)) * (rng.random((m, n)) < .5)
        x = rng.random(n) * (rng.random(n) < .4)
        y = rng.random(m) * (rng.random(m) < .4)
        b = a @ x - rng.random(m) * (y == 0)
        c = a.T @ y + rng.random(n) * (x == 0)
        p = NAMED[f"lp-{n}x{m}"]
        assert np.array_equal(affine(p)[1], np.r_[c, -b])
        yield from [(f"{p.name}/{k}", v) for k, v in dict(a=a, b=b, c=c, z=np.r_[x, y]).items()]


def spatial_prices():
    """the stream of `networks()`"""
    rng = np.random.default_rng(11)
    for r in (3, 6):
        cost = rng.uniform(1, 10, (r, r))
        np.fill_diagonal(cost, 0)
        demand, supply = rng.uniform(50, 100, r), rng.uniform(1, 3, r)
        for k, v in dict(cost=cost, demand=demand, supply=supply).items():
            yield f"tobin-like-R{r}/{k}", v


def random_lcps():
    """the stream of `lcps()`, for the manufactured x"""
    rng = np.random.default_rng(1)
    kinds = ["spd", "psd-skew", "P-tri", "psd-lowrank", "skew", "copos", "indef", "hcond"]
    for k in range(24):
        n, kind = [10, 30, 80][k % 3], kinds[k // 3]
        a = rng.standard_normal((n, n))
        b = rng.standard_normal((n, n))
        s = b - b.T
        if kind == "spd":
            m = a @ a.T / n + .01 * np.eye(n)
        elif kind == "psd-skew":
            m = a @ a.T / n + s
        elif kind == "P-tri":
            m = np.triu(rng.uniform(-3, 3, (n, n)), 1) + np.diag(rng.uniform(.1, 1, n))
        elif kind == "psd-lowrank":
            m = a[:, :n // 3] @ a[:, :n // 3].T
        elif kind == "skew":
            m = s
        elif kind == "copos":
            m = rng.random((n, n)) + np.diag(rng.uniform(0, .1, n))
        elif kind == "indef":
            m = a
        else:
            orthogonal, _ = np.linalg.qr(a)
            m = orthogonal @ np.diag(np.logspace(-8, 4, n)) @ orthogonal.T
        x = rng.random(n) * (rng.random(n) < .5)
        w = rng.random(n) * (x == 0)
        degenerate = rng.random(n) < (.3 if k % 2 else 0)
        x[degenerate] = 0
        w[degenerate] = 0
        yield from lcp_records(NAMED[f"rnd-{kind}-{n}{'-deg' if k % 2 else ''}"], x, m, w - m @ x)


def arctans():
    """F = M z + d arctan z + q + z³/100: q = F(0), the others are closed over"""
    for p in (p for p in INSTANCES if p.name.startswith("rnl-") and "~" not in p.name):
        m, d, q = p._F.__defaults__
        for k, v in dict(m=m, d=d, q=q, l=p.l, u=p.u).items():
            yield f"{p.name}/{k}", v


def scalings():
    for p in (p for p in INSTANCES if "~" in p.name):
        yield f"{p.name}/rows", p.r
        yield f"{p.name}/columns", p.c


def second_point(p):
    """away from the start, inside the box; of a scaled instance, that of its original"""
    if hasattr(p, "base"):
        return second_point(p.base) / p.c
    return np.minimum(np.maximum(p.z0 + .25 * (1 + np.arange(p.n) % 4), p.l), p.u)


def values():
    for p in INSTANCES:
        z = second_point(p)
        for k, v in dict(l=p.l, u=p.u, z0=p.z0, f0=p.F(p.z0), z1=z, f1=p.F(z)).items():
            yield f"{p.name}/{k}", v


def fnv1a(path):
    h = 0xCBF29CE484222325
    for byte in open(path, "rb").read():
        h = (h ^ byte) * 0x100000001B3 % 2**64
    return h


streams = [contacts, linear_programs, spatial_prices, random_lcps, arctans, scalings]
write("random.bin", (record for stream in streams for record in stream()))
write("values.bin", values())
for path in ["random.bin", "values.bin"]:
    print(f"{path} {fnv1a(path):#018x}")
