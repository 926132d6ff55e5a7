# SPDX-License-Identifier: Apache-2.0
"""Parameters of a model that another program may change: the words of the memory that depend on them.

The model is compiled with four values of the parameter. If every word that changes is an affine function of
it, these words are all that has to be changed. The result is checked by the accelerations and channels of the
changed memory against a model that was compiled with another value. Numbers that follow from the start of the
run, such as balancing torques and damping constants of modal damping ratios, keep their values.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.numbers import number_at
from pitchpoint.solvers.exported_run import ExportedRun
from pitchpoint.solvers.input_places import Place
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from pitchpoint.system.image import arrays_of, word_at
from pitchpoint.system.system import State, System

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

CHANGES = (0.0, 0.1, 0.37, -0.2)
"""Changes with which the model is compiled, relative to the value of the file, or to 1 if that is zero."""
STRAIGHT = 1e-9
"""Largest relative deviation of a word from an affine function: round-off of the compilation."""
ALIKE = 1e-6
"""Largest deviation of the check, relative to the largest channel or acceleration of its unit.

Accelerations are differences of large forces, and words differ by round-off from those of a compilation."""
GROUPS = ("records.", "pool.", "program.")
"""Arrays that may depend on a parameter: elements, tables, bodies."""

Words = dict[str, NDArray[np.int64]]


def tunable_places(model: Model, scenario: str, run: ExportedRun, paths: Sequence[str]) -> tuple[Place, ...]:
    """Places of parameters in the memory of a run.

    Parameters
    ----------
    model, scenario
        Model and name of its scenario.
    run
        Started run of the scenario.
    paths
        Paths of the parameters in the model file.

    Raises
    ------
    ModelError
        If a path is not a number, or a word depends on it in another way.
    """
    return tuple(_place(model, scenario, run, path) for path in paths)


def _place(model: Model, scenario: str, run: ExportedRun, path: str) -> Place:
    found = number_at(model, path)
    if found is None:
        raise ModelError([Message(path, "is not a number of the model", remedy="name a number")])
    value, unit = found
    values = [value + change * (abs(value) or 1.0) for change in CHANGES]
    variants = [_variant(model, scenario, path, each) for each in values]
    fixed = {*run.image.moved, *(offset for offset, _ in run.code)}
    fixed |= {offset for place in run.inputs for offset, _ in place.words}
    words = _affine([_words(system) for system in variants], values, run, fixed, path)
    if not words:
        raise ModelError([Message(path, "changes nothing but inputs", remedy="leave it fixed")])
    place = Place(path, unit or "1", "parameter of the model file", value, words)
    _check(run, variants, place, values[2])
    return place


def _variant(model: Model, scenario: str, path: str, value: float) -> System:
    """System with another value of the parameter."""
    system = compile_model(model.replace(path, value), scenario)
    system.workspace  # noqa: B018 - writes addresses of tables to the records
    return system


def _words(system: System) -> Words:
    """Words of all arrays that may depend on a parameter."""
    found = {n: a for n, a in arrays_of(system).items() if n.startswith((*GROUPS, "keep."))}
    return {name: np.frombuffer(array.tobytes(), np.int64) for name, array in found.items()}


def _affine(
    variants: Sequence[Words], values: Sequence[float], run: ExportedRun, fixed: Collection[int], path: str
) -> tuple[tuple[int, float], ...]:
    """Offset and slope of every word that depends on the parameter."""
    first, found = variants[0], []
    if any(
        {n: len(w) for n, w in other.items()} != {n: len(w) for n, w in first.items()} for other in variants
    ):
        raise _refused(path, "changes the structure of the model")
    own = np.frombuffer(run.image.data, np.int64)
    for name, bits in first.items():
        moved = np.any([other[name] != bits for other in variants[1:]], axis=0)
        for k in np.flatnonzero(moved).tolist():
            offset = run.image.at[name] + 8 * k
            if offset in fixed:
                continue
            y = np.array([other[name][k] for other in variants]).view(np.float64)
            slope = (y[2] - y[3]) / (values[2] - values[3])
            straight = y[0] + slope * (np.array(values) - values[0])
            where = f"{name.partition('.')[2]}+{8 * k}"
            if name.startswith("keep.") or int(own[offset // 8]) != int(bits[k]):
                raise _refused(path, f"changes data that are not numbers of elements ({where})")
            if not np.allclose(y, straight, rtol=STRAIGHT, atol=STRAIGHT * np.abs(y).max()):
                raise _refused(path, f"changes a number that is not an affine function of it ({where})")
            found.append((offset, float(slope)))
    return tuple(found)


def _refused(path: str, what: str) -> ModelError:
    remedy = (
        "leave it fixed, or give quantities that depend on it as values, such as damping instead of a ratio"
    )
    return ModelError([Message(path, what, remedy=remedy)])


def _check(run: ExportedRun, variants: Sequence[System], place: Place, value: float) -> None:
    """Compare the memory with a changed parameter with a model that was compiled with it, at the start."""
    mine, other = run.system.copy(), variants[2].copy()
    change = value - place.start
    _write(mine, run.image.at, [(offset, slope * change) for offset, slope in place.words])
    _write(other, run.image.at, _from_the_start(run, variants[0]), replaced=True)
    results = [_response(system, run.state) for system in (mine, other)]
    for a, b in zip(*results, strict=True):
        size = float(np.abs(b).max(initial=0.0))
        if not np.allclose(a, b, rtol=ALIKE, atol=ALIKE * size):
            raise _refused(place.name, "has effects that do not follow from the numbers of the elements")


def _from_the_start(run: ExportedRun, compiled: System) -> list[tuple[int, float]]:
    """Offsets and values of the words that the start of the run has changed."""
    own = np.frombuffer(run.image.data, np.int64)
    fixed = {*run.image.moved, *(offset for offset, _ in run.code)}
    found = []
    for name, bits in _words(compiled).items():
        first = run.image.at[name] // 8
        for k in np.flatnonzero(own[first : first + len(bits)] != bits).tolist():
            if 8 * (first + k) not in fixed:
                found.append((8 * (first + k), float(own[first + k : first + k + 1].view(np.float64)[0])))
    return found


def _write(
    system: System, at: Mapping[str, int], changes: Sequence[tuple[int, float]], replaced: bool = False
) -> None:
    """Add to words of a system, or replace them."""
    arrays = arrays_of(system)
    for offset, change in changes:
        word = word_at(arrays, at, offset)
        word[0] = change if replaced else word[0] + change


def _response(system: System, state: State) -> list[NDArray[Any]]:
    """Accelerations and channels of a system at a state."""
    evaluate.prepare(system)
    evaluate.load(system, state)
    evaluate.check(system, evaluate.accelerations(system, state.t), state)
    a = system.workspace.a.copy()
    row = evaluate.observe(system, evaluate.store(system, state.t))
    units = [channel.unit for channel in system.layout.channels]
    return [a, *(row[[u == unit for u in units]] for unit in sorted({*units}))]
