# SPDX-License-Identifier: Apache-2.0
"""Computed tables of naive gear pairs: measured errors, their decrease with size, order, interruption.

The potentials are slices with tip relief, crowning and misalignment, without and with coupling. The aim for
realistic teeth at the default size is a root mean square error of 1e-3 of the nominal force.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
import pytest

from pitchpoint.contact.potential_build import (
    NominalValues,
    build_potential_table,
    measured_errors,
    one_after_another,
)
from pitchpoint.contact.potential_fit import PotentialTable
from pitchpoint.contact.potential_range import TableRange, TableSize, phase_axis
from pitchpoint.contact.potential_table import BEYOND_APPROACH, potential
from pitchpoint.core.errors import ModelError, SolverError
from pitchpoint.sweep.threads import on_all_cores
from tests.support.slice_potential import UM, SlicePair

NOMINAL = NominalValues(5000.0, 11.8e-3, 0.02)
QUANTITIES = {"loss": "m", "friction_moment": "m"}
WHOLE = TableRange((-15.0 * UM, 32.0 * UM), 1.5e-3, (-5e-5, 5e-5))
STRAIGHT = TableRange((-1.0 * UM, 32.0 * UM))


def table_of(pair: SlicePair, span: TableRange, size: TableSize, checks: int = 600) -> PotentialTable:
    return build_potential_table(lambda: pair, span, NOMINAL, size, QUANTITIES, checks=checks)


@pytest.mark.parametrize("pair", [SlicePair(), SlicePair(soft=0.5, slices=7)], ids=["slices", "coupled"])
def test_the_naive_potentials_are_potentials(pair: SlicePair) -> None:
    """Derivatives of the support functions by central differences: what they test must itself be right."""
    chance = np.random.default_rng(0)
    states = chance.uniform([0.0, -1e-5, -1.5e-3, -5e-5], [1.0, 3.2e-5, 1.5e-3, 5e-5], (60, 4))
    values = pair(states)
    for k, h in enumerate((1e-6, 1e-9, 1e-7, 1e-8)):
        step = h * np.eye(4)[k]
        quotient = (pair(states + step)[:, 0] - pair(states - step)[:, 0]) / (2.0 * h)
        assert np.max(np.abs(quotient - values[:, 1 + k])) < 1e-6 * np.max(np.abs(values[:, 1 + k]))


@pytest.mark.slow
@pytest.mark.study
@pytest.mark.parametrize(
    ("pair", "limit"),
    [
        pytest.param(SlicePair(slices=15), 1e-3, id="spur"),
        pytest.param(SlicePair(slices=15, eps_beta=1.2), 1e-3, id="helical"),
        pytest.param(SlicePair(slices=15, relief=0.0, crown=0.0), 1.2e-3, id="plain"),
    ],
)
def test_errors_at_the_default_size(pair: SlicePair, limit: float) -> None:
    """Travel force over the base pitch is a hundred times smaller than the force, and so is its error."""
    errors = table_of(pair, WHOLE, TableSize(), checks=2000).errors
    assert errors["force"][0] < limit
    assert errors["tilting_moment"][0] < limit
    assert errors["travel_force"][0] < 0.1 * limit
    assert errors["centre_force"][0] < 0.3 * limit
    assert errors["loss"][0] < 0.01 * errors["loss"][2]
    assert all(0.0 < rms <= most for rms, most, _ in errors.values())


@pytest.mark.slow
@pytest.mark.study
def test_errors_of_coupled_teeth_at_the_default_size() -> None:
    span = TableRange((-15.0 * UM, 28.0 * UM), 1.5e-3, (-5e-5, 5e-5))
    for eps_beta in (0.0, 1.2):
        assert (
            table_of(SlicePair(soft=0.5, slices=9, eps_beta=eps_beta), span, TableSize()).errors["force"][0]
            < 1e-3
        )


def test_errors_of_coupled_teeth_without_misalignment() -> None:
    """The moment of a helical gear remains with misalignment and centre distance fixed."""
    pair, span = SlicePair(soft=0.5, slices=7, eps_beta=1.2), TableRange((-1.0 * UM, 28.0 * UM))
    table = table_of(pair, span, TableSize())
    assert table.coefficients.shape == (128, 24, 2, 2)
    assert table.errors["force"][0] < 1e-3
    assert table.errors["tilting_moment"][0] < 1e-3 < 0.03 < table.errors["tilting_moment"][2]
    assert table.errors["centre_force"][0] < 1e-3


@pytest.mark.parametrize(
    ("pair", "order"), [(SlicePair(slices=5), 1.4), (SlicePair(slices=5, eps_beta=1.2), 1.4)]
)
@pytest.mark.study
def test_errors_decrease_with_the_size(pair: SlicePair, order: float) -> None:
    """Jumps of the stiffness along lines that cross the cells limit the order.

    The error of the force is proportional to the step in the cells that such a line crosses, and their share
    decreases with the step, too: order 3/2 of the root mean square for spur gears with stiff contact at once
    over the width. Crowning and helix smooth the lines.
    """
    sizes = [TableSize(16, 12), TableSize(32, 22), TableSize(64, 42)]
    found = [table_of(pair, STRAIGHT, size, checks=2000).errors for size in sizes]
    rms = [errors["force"][0] for errors in found]
    assert rms[2] < rms[0] / 4.0**order
    travel = [errors["travel_force"][0] for errors in found]
    assert travel[2] < travel[0] / 4.0**order


def test_smooth_potentials_converge_with_the_order_of_the_spline() -> None:
    """V of one cubic order more than the spline: error of the slope of order h^3."""

    def smooth(states):
        s, x, kappa, a = states.T
        c = 1.0 + 0.2 * np.sin(2.0 * np.pi * s) + 0.1 * np.cos(3.0 * kappa) + 0.1 * np.exp(a)
        g = x + 0.1 * np.sin(4.0 * x)
        up = np.maximum(c * g, 0.0)
        by_s = 0.4 * np.pi * np.cos(2.0 * np.pi * s) * g
        by_x, by_k = c * (1.0 + 0.4 * np.cos(4.0 * x)), -0.3 * np.sin(3.0 * kappa) * g
        return np.stack([0.5 * up**2, up * by_s, up * by_x, up * by_k, up * 0.1 * np.exp(a) * g], -1)

    span, nominal = TableRange((0.0, 1.0), 0.9, (-0.5, 0.5)), NominalValues(1.0, 1.0, 1.0)
    errors = []
    for factor in (1, 2):
        size = TableSize(12 * factor, 12 * factor - 2 * (factor - 1), 7 * factor, 5 * factor)
        table = build_potential_table(lambda: smooth, span, nominal, size, checks=1)
        chance = np.random.default_rng(2)
        states = chance.uniform([0.0, 0.3, -0.9, -0.5], [1.0, 1.0, 0.9, 0.5], (1000, 4))  # away from contact
        errors.append(measured_errors(table, states, smooth(states), nominal))
    for name in ("force", "travel_force", "tilting_moment", "centre_force"):
        assert errors[1][name][0] < errors[0][name][0] / 2.0**2.7, name


def test_states_come_in_an_order_for_warm_starts() -> None:
    """Lines along the approach, up and down in turn; a line differs from the next by one step."""
    seen: list[np.ndarray] = []
    made: list[int] = []

    def source() -> Callable[[np.ndarray], np.ndarray]:
        made.append(len(made))
        pair = SlicePair(slices=3)

        def evaluate(states: np.ndarray) -> np.ndarray:
            seen.append(states)
            return pair(states)

        return evaluate

    build_potential_table(
        source,
        TableRange((-16e-6, 32e-6), 1e-3, (-1e-5, 1e-5)),
        NOMINAL,
        TableSize(8, 6, 3, 3),
        QUANTITIES,
        checks=5,
    )
    lines = [states for states in seen if states.shape == (6, 4)][-8 * 9 :]
    assert len(lines) == 72
    for before, after in zip(lines, lines[1:], strict=False):
        assert np.count_nonzero(np.ptp(before, axis=0)) == 1
        changed = np.count_nonzero(before[-1] != after[0])
        assert changed == (1 if before[0, 2] == after[0, 2] and before[0, 3] == after[0, 3] else changed)
        assert before[-1, 1] == after[0, 1]
    assert len(made) == -(-len(seen) // 8) or len(made) < len(seen)


@pytest.mark.parametrize("run", [one_after_another, on_all_cores])
def test_threads_and_sequence_give_the_same_table(run) -> None:
    reports: list[tuple[float, float]] = []
    pair, size = SlicePair(slices=3), TableSize(8, 8, 3, 3)
    table = build_potential_table(
        lambda: pair,
        WHOLE,
        NOMINAL,
        size,
        QUANTITIES,
        run,
        lambda done, total, note="": reports.append((done, total)),
        20,
    )
    alone = table_of(pair, WHOLE, size, 20)
    assert np.array_equal(table.packed, alone.packed)
    assert table.errors == alone.errors
    totals = {total for _, total in reports}
    assert totals == {8 * 8 * 9 + 3 * 32 * 6 + 20}
    assert [done for done, _ in reports] == sorted(done for done, _ in reports)
    assert reports[-1][0] == reports[-1][1]


def test_an_interruption_stops_the_computation() -> None:
    calls: list[int] = []

    def listen(done: float, total: float, note: str = "") -> None:
        calls.append(int(done))
        if len(calls) == 3:
            raise KeyboardInterrupt

    pair, size = SlicePair(slices=3), TableSize(8, 8, 3, 3)
    with pytest.raises(KeyboardInterrupt):
        build_potential_table(lambda: pair, WHOLE, NOMINAL, size, QUANTITIES, progress=listen)
    assert len(calls) == 3

    def stopped(work, pieces, take) -> bool:
        """As the threads after Ctrl-C: some tasks are done, the others see the event."""
        event = threading.Event()
        event.set()
        _, values, error = work(pieces[0], event)
        assert (values, type(error)) == ([], KeyboardInterrupt)
        return False

    with pytest.raises(KeyboardInterrupt):
        build_potential_table(lambda: pair, WHOLE, NOMINAL, size, QUANTITIES, stopped)


@pytest.mark.parametrize("run", [one_after_another, on_all_cores])
def test_errors_of_the_evaluator_reach_the_caller(run) -> None:
    def broken(states: np.ndarray) -> np.ndarray:
        raise SolverError("does not converge", 5)

    with pytest.raises(SolverError, match="does not converge"):
        build_potential_table(lambda: broken, WHOLE, NOMINAL, TableSize(8, 8, 3, 3), run=run)
    with pytest.raises(SolverError, match="shape"):
        build_potential_table(lambda: np.sin, WHOLE, NOMINAL, TableSize(8, 8, 3, 3), run=run)


def test_phases_are_dense_where_teeth_engage() -> None:
    table = table_of(SlicePair(relief=0.0, crown=0.0, slices=5), STRAIGHT, TableSize(64, 12), checks=1)
    steps = np.diff(table.axes[0].closed)
    engaging = (table.axes[0].points > 0.9) | (np.abs(table.axes[0].points - 0.65) < 0.05)
    assert np.mean(steps[engaging]) < 0.5 * np.mean(steps[~engaging])
    assert steps.max() < 3.001 / 64.0
    even = phase_axis(np.zeros((3 * 64, 6)), 16)
    assert np.allclose(even.points, np.arange(16) / 16.0)


def test_range_and_marks_of_a_computed_table() -> None:
    span = TableRange((-1.0 * UM, 32.0 * UM), tolerances=(1e-5, 1e-6))
    table = table_of(SlicePair(slices=5), span, TableSize(16, 12), checks=1)
    marks = [
        potential(table.packed, 0.3, x, k, a)[8] for x, k, a in ((32e-6, 1e-5, -1e-6), (33e-6, 0.0, 0.0))
    ]
    assert marks == [0, BEYOND_APPROACH]
    with pytest.raises(ModelError, match="start lower"):
        table_of(SlicePair(slices=5, crown=0.0), TableRange((9.0 * UM, 32.0 * UM)), TableSize(16, 12))
    short = SlicePair(slices=5, eps_alpha=0.9, relief=9e-5)
    with pytest.raises(SolverError, match="raise the approach"):
        table_of(short, TableRange((-1e-6, 1e-6)), TableSize(16, 12))


@pytest.mark.parametrize(
    "make",
    [
        lambda: TableRange((1e-5, 1e-5)),
        lambda: TableRange((0.0, float("nan"))),
        lambda: TableRange((0.0, True)),
        lambda: TableRange((0.0, 1e-5), -1e-3),
        lambda: TableRange((0.0, 1e-5), 0.0, (1.0, 0.9)),
        lambda: TableRange((0.0, 1e-5), tolerances=(-1.0, 0.0)),
        lambda: TableSize(phase=3),
        lambda: TableSize(approach=True),
        lambda: TableSize(misalignment=2),
        lambda: TableSize(centre_distance=10**9),
        lambda: NominalValues(0.0, 1.0, 1.0),
        lambda: NominalValues(1.0, float("inf"), 1.0),
        lambda: table_of(SlicePair(), STRAIGHT, TableSize(8, 8), checks=0),
    ],
)
def test_bad_numbers_are_refused(make) -> None:
    with pytest.raises(ModelError):
        make()
