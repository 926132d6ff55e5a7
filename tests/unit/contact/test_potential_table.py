# SPDX-License-Identifier: Apache-2.0
"""Table of the elastic potential: exact for cubics, C2, conservative, marked outside its range.

Polynomials of V are reproduced to round-off: tolerances of 1e-11 relative leave room for the condition of the
interpolation, tolerances of difference quotients are named at the place.
"""

from __future__ import annotations

import itertools
import math
import os
import subprocess
import sys

import numpy as np
import pytest

from pitchpoint.contact.potential_axes import TableAxis
from pitchpoint.contact.potential_fit import PotentialTable, fit_potential
from pitchpoint.contact.potential_table import (
    BEYOND_APPROACH,
    BEYOND_CENTRE,
    BEYOND_MISALIGNMENT,
    force_ratios,
    potential,
)
from pitchpoint.core.errors import ModelError, SolverError

X = np.array([-0.2, 0.1, 0.35, 0.7, 1.0, 1.4])
KAPPA = np.array([-1.0, -0.4, 0.1, 0.5, 1.0])
A = np.array([2.0, 2.3, 2.9])


def wave(s: float, period: float = 1.0) -> float:
    return math.sin(2.0 * math.pi * s / period)


def axes(n_s: int = 8, kappa=KAPPA, a=A, doubled: bool = True) -> tuple[TableAxis, ...]:
    shares = np.arange(n_s) / n_s
    return (
        TableAxis("phase", shares + 0.3 / n_s * np.sin(2.0 * np.pi * shares), doubled, 1.0),
        TableAxis("approach", X),
        TableAxis("misalignment", np.atleast_1d(np.asarray(kappa, float)), doubled, tolerance=0.1),
        TableAxis("centre_distance", np.atleast_1d(np.asarray(a, float)), doubled, tolerance=0.2),
    )


def polynomial(s, x, kappa, a):
    """A cubic in x, kappa and a, positive above x = 0, with its derivatives by s, x, kappa, a."""
    c = 1.0 + 0.1 * kappa**3 + 0.05 * (a - 2.0) ** 3 + 0.02 * kappa * a
    g = x + 0.2 * x**2 + 0.1 * x**3
    by_x = 1.0 + 0.4 * x + 0.3 * x**2
    return (
        c * g,
        0.0 * x,
        c * by_x,
        g * (0.3 * kappa**2 + 0.02 * a),
        g * (0.15 * (a - 2.0) ** 2 + 0.02 * kappa),
    )


def table_of(function, places: tuple[TableAxis, ...]) -> PotentialTable:
    """Table of V = function, extended below zero by the fit; U = V^2/2."""
    grid = np.meshgrid(*(axis.points for axis in places), indexing="ij")
    V, *slopes = function(*grid)
    up = np.maximum(V, 0.0)
    return fit_potential(places, np.stack([0.5 * up**2, *(up * v for v in slopes)], -1))


@pytest.fixture(scope="module")
def wavy() -> PotentialTable:
    """A table with all axes, waves over the phase and contact that begins at different approaches."""

    def function(s, x, kappa, a):
        g = x - 0.1 * np.sin(2 * np.pi * s) - 0.1 * kappa**2 + 0.05 * (a - 2.4)
        c = 1.0 + 0.2 * np.cos(2 * np.pi * s) * kappa + 0.1 * x
        by_s = -0.2 * np.pi * np.cos(2 * np.pi * s) * c - 0.4 * np.pi * np.sin(2 * np.pi * s) * kappa * g
        by_kappa = -0.2 * kappa * c + 0.2 * np.cos(2 * np.pi * s) * g
        return g * c, by_s, c + 0.1 * g, by_kappa, 0.05 * c

    return table_of(function, axes())


@pytest.mark.nojit
@pytest.mark.parametrize("doubled", [False, True])
def test_cubics_are_exact(doubled: bool) -> None:
    places = axes(a=np.append(A, 3.1), doubled=doubled)
    # the fit sees V only where it is positive: the tangent below would not be the cubic
    shifted = (places[0], TableAxis("approach", np.append(-0.01, X[1:])), *places[2:])
    packed = _full(polynomial, shifted)
    chance = np.random.default_rng(3)
    for _ in range(20):
        s, x, kappa, a = (
            chance.random(),
            chance.uniform(0.01, 1.4),
            chance.uniform(-1, 1),
            chance.uniform(2, 3.1),
        )
        V, V_s, V_x, V_k, V_a = polynomial(s, x, kappa, a)
        c = V / (x + 0.2 * x**2 + 0.1 * x**3)
        V_xx, V_xk = c * (0.4 + 0.6 * x), V_x / c * (0.3 * kappa**2 + 0.02 * a)
        V_kk = V / c * 0.6 * kappa
        wanted = [0.5 * V * V, V * V_s, V * V_x, V * V_k, V * V_a]
        wanted += [V_x**2 + V * V_xx, V_x * V_k + V * V_xk, V_k**2 + V * V_kk, 0]
        assert np.allclose(potential(packed, s, x, kappa, a), wanted, rtol=1e-11, atol=1e-11)


def _full(function, places: tuple[TableAxis, ...]) -> np.ndarray:
    """Packed table of V itself, with its true values below zero."""
    grid = np.meshgrid(*(axis.points for axis in places), indexing="ij")
    V, *slopes = function(*grid)
    parts = dict(enumerate([V, *slopes]))
    for number, axis in enumerate(places):
        slope, (by_value, by_slope) = parts.pop(1 + number), axis.slopes_operators
        along = {k: by_value if k == 0 else axis.values_operator for k in parts}
        new = {k: np.moveaxis(np.tensordot(along[k], v, (1, number)), 0, number) for k, v in parts.items()}
        new[0] = new[0] + np.moveaxis(np.tensordot(by_slope, slope, (1, number)), 0, number)
        parts = new
    coefficients = parts[0][: len(places[0].refined)]
    return PotentialTable(places, coefficients, np.zeros((0, *(a.count for a in places)))).packed


@pytest.mark.nojit
def test_phase_is_periodic(wavy: PotentialTable) -> None:
    for s, x, kappa, a in ((0.0, 0.6, 0.3, 2.4), (0.77, 1.2, -0.8, 2.9), (0.9999999999, 0.4, 0.0, 2.1)):
        here = potential(wavy.packed, s, x, kappa, a)
        for turns in (-3.0, 1.0, 1000.0):
            # s - floor(s) loses up to 1e-13 of the phase at 1000
            assert potential(wavy.packed, s + turns, x, kappa, a) == pytest.approx(here, rel=1e-11, abs=1e-11)
    before, after = (potential(wavy.packed, s, 0.8, 0.3, 2.4) for s in (-1e-12, 0.0))
    assert before == pytest.approx(after, rel=1e-10, abs=1e-10)


def test_second_derivatives_are_continuous_across_cells(wavy: PotentialTable) -> None:
    """A change over 2e-9 of an axis, no jump; third derivatives are below 500.

    Those by phase and centre distance are differences of first ones over 2e-5.
    """
    middle, h = [0.37, 0.8, 0.23, 2.47], 1e-5
    for number, axis in enumerate(wavy.axes):
        for edge in axis.edges[1:-1]:
            near = [potential(wavy.packed, *_moved(middle, number, edge + d)) for d in (-1e-9, 1e-9)]
            assert near[0] == pytest.approx(near[1], rel=0.0, abs=2e-6)
            sides = [_moved(middle, number, edge + d) for d in (-2.0 * h, 2.0 * h)]
            second = [_difference(wavy, side, number, h)[1 + number] for side in sides]
            assert second[0] == pytest.approx(second[1], abs=4.0 * h * 500.0)


def _moved(state: list[float], number: int, to: float) -> list[float]:
    return [to if k == number else v for k, v in enumerate(state)]


def _difference(table: PotentialTable, state: list[float], number: int, h: float) -> np.ndarray:
    low, high = list(state), list(state)
    low[number] -= h
    high[number] += h
    pair = [np.array(potential(table.packed, *q)) for q in (low, high)]
    return (pair[1] - pair[0]) / (2.0 * h)


@pytest.mark.nojit
def test_derivatives_are_difference_quotients(wavy: PotentialTable) -> None:
    """Central differences with h = 1e-5: error h^2 f'''/6, about 1e-8, in cells and outside the range."""
    states = [
        [0.37, 0.8, 0.23, 2.47],
        [0.911, 1.21, -0.83, 2.11],
        [0.2, 1.7, 0.31, 2.5],
        [0.55, 0.9, 1.3, 2.6],
        [0.55, 0.9, -1.2, 1.8],
        [0.4, 1.6, 1.2, 3.3],
    ]
    for state in states:
        value = potential(wavy.packed, *state)
        by = [_difference(wavy, state, number, 1e-5) for number in range(4)]
        assert [d[0] for d in by] == pytest.approx(value[1:5], rel=1e-6, abs=1e-7)
        assert [by[1][2], by[2][2], by[2][3]] == pytest.approx(value[5:8], rel=1e-6, abs=1e-6)


def test_forces_do_no_work_on_a_closed_path(wavy: PotentialTable) -> None:
    """Integral of the four forces around boxes and triangles of the four coordinates, crossing all cells.

    Between crossings of cell edges U is a polynomial of degree 24 along a straight line: 13 Gauss points
    integrate its derivative exactly. The path stays in contact.
    """
    corners = {
        "box": [[0.1, 0.5, -0.8, 2.1], [1.4, 0.5, -0.8, 2.1], [1.4, 1.3, 0.9, 2.1], [0.1, 1.3, 0.9, 2.8]],
        "triangle": [[0.0, 0.6, 0.0, 2.0], [0.7, 1.39, 0.99, 2.9], [0.3, 0.7, -0.9, 2.5]],
    }
    for path in corners.values():
        work, size = 0.0, 0.0
        for start, end in zip(path, [*path[1:], path[0]], strict=True):
            part, most = _work(wavy, np.array(start), np.array(end))
            work, size = work + part, size + most
        assert abs(work) < 1e-12 * size


def _work(table: PotentialTable, start: np.ndarray, end: np.ndarray) -> tuple[float, float]:
    """Work along a straight line, and the same of its absolute value."""
    cuts = {0.0, 1.0}
    for number, axis in enumerate(table.axes):
        way = end[number] - start[number]
        for turn in range(3) if number == 0 else range(1):
            for edge in axis.edges + turn:
                if way and 0.0 < (edge - start[number]) / way < 1.0:
                    cuts.add((edge - start[number]) / way)
    nodes, weights = np.polynomial.legendre.leggauss(13)
    work = size = 0.0
    for low, high in itertools.pairwise(sorted(cuts)):
        for t, w in zip(0.5 * (low + high) + 0.5 * (high - low) * nodes, weights, strict=True):
            U, *forces, _, _, _, beyond = potential(table.packed, *(start + t * (end - start)))
            assert U > 0.0
            assert beyond == 0
            power = float(np.dot(forces, end - start)) * 0.5 * (high - low) * w
            work, size = work + power, size + abs(power)
    return work, size


@pytest.mark.nojit
def test_no_force_below_contact_and_a_continuous_one_above(wavy: PotentialTable) -> None:
    packed = wavy.packed
    for s, kappa, a in ((0.25, 0.0, 2.4), (0.75, 0.9, 2.0), (0.1, -0.5, 2.9)):
        low, high = -0.2, 1.4
        for _ in range(60):
            x = 0.5 * (low + high)
            low, high = (x, high) if potential(packed, s, x, kappa, a)[0] == 0.0 else (low, x)
        assert potential(packed, s, low, kappa, a)[:8] == (0.0,) * 8
        for d in (1e-3, 1e-5, 1e-7):  # the force grows with the stiffness at contact, which is about 1
            force = potential(packed, s, high + d, kappa, a)[2]
            assert 0.0 < force < 3.0 * d
    assert potential(packed, 0.3, -5.0, 0.0, 2.4) == (0.0,) * 8 + (0,)


@pytest.mark.nojit
def test_places_outside_the_range_are_marked(wavy: PotentialTable) -> None:
    packed = wavy.packed
    for x, kappa, a, flag in (
        (1.4, 1.0, 2.9, 0),
        (0.5, -1.0, 2.0, 0),
        (1.41, 0.0, 2.4, BEYOND_APPROACH),
        (0.8, 1.01, 2.4, BEYOND_MISALIGNMENT),
        (0.8, -1.01, 2.4, BEYOND_MISALIGNMENT),
        (0.8, 0.0, 1.99, BEYOND_CENTRE),
        (2.0, 2.0, 3.0, BEYOND_APPROACH + BEYOND_MISALIGNMENT + BEYOND_CENTRE),
        (-9.0, 2.0, 2.4, BEYOND_MISALIGNMENT),
        (1e6, 0.0, 2.4, BEYOND_APPROACH),
    ):
        assert potential(packed, 0.3, x, kappa, a)[8] == flag


@pytest.mark.nojit
def test_nan_in_a_coordinate_is_marked_or_gives_nan(wavy: PotentialTable) -> None:
    for k in range(4):
        state = [0.3, 0.8, 0.2, 2.4]
        state[k] = math.nan
        found = potential(wavy.packed, *state)
        assert math.isnan(found[0])
        assert (found[8] > 0) == (k > 0)
    assert math.isnan(potential(wavy.packed, math.inf, 0.8, 0.2, 2.4)[0])


@pytest.mark.nojit
def test_force_continues_linearly_beyond_the_approach(wavy: PotentialTable) -> None:
    """V is linear there, so the force is, and value and force are continuous at the edge."""
    x = [1.4, 1.4 + 1e-9, 1.6, 1.8, 2.0]
    found = [potential(wavy.packed, 0.3, v, 0.2, 2.4) for v in x]
    assert found[0][:5] == pytest.approx(found[1][:5], rel=1e-8)
    force = [f[2] for f in found[2:]]
    assert force[2] - force[1] == pytest.approx(force[1] - force[0], rel=1e-12)


@pytest.mark.nojit
def test_axes_with_one_point() -> None:
    """The table is that of the other two axes, and linear about the point: moment and centre force remain."""
    kappa, a = 0.25, 2.4

    def function(s, x, k, a):
        V = x - 0.1 * np.sin(2 * np.pi * s) + 0.2 * k - 0.1 * a
        return V, -0.2 * np.pi * np.cos(2 * np.pi * s), 1.0 + 0.0 * x, 0.2 + 0.0 * x, -0.1 + 0.0 * x

    whole = table_of(function, axes())
    flat = table_of(function, axes(kappa=kappa, a=a))
    assert flat.coefficients.shape == (16, 6, 2, 2)
    for s, x, d in ((0.2, 0.9, 0.0), (0.71, 1.3, 0.1), (0.5, 0.4, -0.1)):
        there, here = (potential(t.packed, s, x, kappa + d, a - d) for t in (whole, flat))
        assert here == pytest.approx(there, rel=1e-9, abs=1e-9)
    constant = table_of(function, axes(kappa=kappa, a=a, doubled=False))
    assert constant.coefficients.shape == (8, 6, 1, 1)
    found = [potential(constant.packed, 0.2, 0.9, kappa + d, a)[:5] for d in (0.0, 0.05)]
    assert found[0] == found[1]
    assert found[0][2] > 0.0 == found[0][3] == found[0][4]
    inside, outside = (potential(flat.packed, 0.2, 0.9, kappa + 0.11 * k, a + 0.21 * k)[8] for k in (0, 1))
    assert (inside, outside) == (0, BEYOND_MISALIGNMENT + BEYOND_CENTRE)


@pytest.mark.nojit
def test_ratios_are_linear_between_points_and_constant_outside() -> None:
    places = axes(n_s=4)
    grid = np.meshgrid(*(axis.points for axis in places), indexing="ij")
    V, *slopes = polynomial(*grid)
    up = np.maximum(V, 0.0)
    ratio = 1.0 + 0.5 * grid[1] + 0.25 * grid[2] * grid[3]
    columns = [0.5 * up**2, *(up * v for v in slopes)]
    values = np.stack([*columns, columns[2] * ratio, 3.0 * columns[2]], -1)
    packed = fit_potential(places, values, {"one": "m", "two": "1"}).packed
    out = np.zeros((3, 2))
    for s, x, kappa, a in ((0.3, 0.8, 0.23, 2.47), (0.99, 1.4, -1.0, 2.9), (0.0, 0.35, 0.5, 2.0)):
        force_ratios(packed, s, x, kappa, a, out)
        assert out[0] == pytest.approx([1.0 + 0.5 * x + 0.25 * kappa * a, 3.0], rel=1e-12)
    force_ratios(packed, 0.3, 0.8, 0.23, 2.47, out)
    assert out[1:] == pytest.approx(np.array([[0.5, 0.0], [0.25 * 2.47, 0.0]]), abs=1e-9)
    force_ratios(packed, 0.3, 9.0, 2.0, 0.0, out)
    assert out[:, 0] == pytest.approx([1.0 + 0.5 * 1.4 + 0.25 * 1.0 * 2.0, 0.0, 0.0], rel=1e-12)
    force_ratios(packed, 0.3, -9.0, 0.1, 2.0, out)  # below contact: as at the lowest point in contact
    assert out[0, 0] == pytest.approx(1.0 + 0.5 * 0.1 + 0.25 * 0.1 * 2.0, rel=1e-12)
    first = np.zeros((3, 1))
    force_ratios(packed, 0.3, -9.0, 0.1, 2.0, first)
    assert np.array_equal(first, out[:, :1])


def test_the_same_without_the_compiler(wavy: PotentialTable, tmp_path) -> None:
    chance = np.random.default_rng(5)
    states = chance.uniform([-2.0, -0.3, -1.2, 1.9], [2.0, 1.8, 1.2, 3.0], (60, 4))
    np.savez(tmp_path / "states.npz", table=wavy.packed, states=states)
    script = """
import sys, numpy as np
from pitchpoint.contact.potential_table import potential
data = np.load(sys.argv[1])
np.save(sys.argv[2], [potential(data["table"], *map(float, q)) for q in data["states"]])
"""
    files = [str(tmp_path / "states.npz"), str(tmp_path / "plain.npy")]
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    subprocess.run([sys.executable, "-c", script, *files], env=environment, check=True)
    compiled = np.array([potential(wavy.packed, *q) for q in states])
    assert np.count_nonzero(compiled[:, 0]) > 20
    # fused multiplications of the compiled code
    assert np.allclose(np.load(files[1]), compiled, rtol=1e-12, atol=1e-12)


def values_of_a_spring(places: tuple[TableAxis, ...]) -> np.ndarray:
    x = np.meshgrid(*(axis.points for axis in places), indexing="ij")[1]
    force = np.maximum(x, 0.0)
    return np.stack([0.5 * force**2, 0.0 * x, force, 0.0 * x, 0.0 * x], -1)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda v: v.__setitem__((1, 2, 0, 0, 0), np.nan), "is not finite"),
        (lambda v: v.__setitem__((1, 2, 0, 0, 3), np.inf), "is not finite"),
        (lambda v: v.__setitem__((1, 2, 0, 0, 0), -1.0), "is negative"),
        (lambda v: v.__setitem__((1, 3, 0, 0, 2), -1.0), "decreases with the approach"),
        (lambda v: v.__setitem__(..., 0.0), "is zero everywhere"),
        (lambda v: v.__setitem__((2, ..., 0), 0.0), "no contact up to the highest approach"),
    ],
)
def test_values_of_no_potential_are_refused(change, words) -> None:
    places = axes()
    values = values_of_a_spring(places)
    change(values)
    with pytest.raises(SolverError, match=words):
        fit_potential(places, values)


def test_contact_at_the_lowest_approach_is_refused() -> None:
    places = axes()
    places = (places[0], TableAxis("approach", X + 0.3), *places[2:])
    with pytest.raises(ModelError, match="start lower"):
        fit_potential(places, values_of_a_spring(places))
    with pytest.raises(SolverError, match="shape"):
        fit_potential(places, values_of_a_spring(axes(n_s=6)))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"points": np.array([0.0, 2.0, 1.0, 3.0])}, "do not increase"),
        ({"points": np.array([0.0, 1.0, np.nan, 3.0])}, "finite"),
        ({"points": np.array([0.0, 1.0, 2.0, 1e9])}, "too uneven"),
        ({"points": np.arange(3.0)}, "too small"),
        ({"points": np.arange(2.0), "doubled": True}, "too small"),
        ({"points": np.arange(600.0)}, "too large"),
        ({"points": np.arange(4.0), "period": 3.0}, "not one period"),
        ({"points": np.arange(1.0, 5.0), "period": 9.0}, "not one period"),
        ({"points": np.zeros(1), "tolerance": -1.0}, "tolerance"),
        ({"points": np.zeros(1), "tolerance": np.nan}, "tolerance"),
        ({"points": np.zeros(1), "period": 1.0}, "too small"),
    ],
)
def test_bad_axes_are_refused(options, words) -> None:
    with pytest.raises(ModelError, match=words):
        TableAxis("a", **options)


@pytest.mark.parametrize(("kink", "gain"), [(False, 1.0), (True, 1.7)])
def test_doubling_by_slopes(kink: bool, gain: float) -> None:
    """Smooth functions: values of the local cubic have the error of the spline, slopes a smaller one.

    Where the second derivative jumps, as that of the potential at engagement, the mean error of the slope
    over all places of the jump in a cell is almost halved.
    """
    t, errors = np.linspace(0.0, 1.0, 2001), np.zeros(2)
    plain, doubled = (TableAxis("phase", np.arange(16) / 16.0, on, 1.0) for on in (False, True))
    by_value, by_slope = doubled.slopes_operators
    for place in np.arange(0.5, 0.5 + 1.0 / 16.0, 1.0 / 128.0):

        def function(s, place=place):
            over = np.maximum(np.sin(2.0 * np.pi * (s - place)), 0.0 if kink else -1.0)
            slope = 2.0 * np.pi * np.cos(2.0 * np.pi * (s - place))
            return over**2, 2.0 * over * slope

        f, df = function(plain.points)
        splines = plain.spline(plain.values_operator @ f), doubled.spline(by_value @ f + by_slope @ df)
        errors += [np.mean((spline(t, 1) - function(t)[1]) ** 2) for spline in splines]
    assert np.sqrt(errors[1]) < np.sqrt(errors[0]) / gain
    same = doubled.spline(doubled.values_operator @ f)(t)  # values alone: the spline of the plain axis
    assert np.allclose(same, plain.spline(plain.values_operator @ f)(t), atol=1e-12)
