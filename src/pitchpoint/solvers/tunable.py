# SPDX-License-Identifier: Apache-2.0
"""Parameters of a model that another program may change: the words of the memory that depend on them.

The model is compiled with four values of the parameter. If every word that changes is an affine function of
it, these words are all that has to be changed. Otherwise the words are interpolated by polynomials in a range
of the parameter, from values at Chebyshev points, and checked between them. The result is also checked by the
accelerations and channels of the changed memory against a model that was compiled with another value. Numbers
that follow from the start of the run, such as damping constants of modal damping ratios, keep their values.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError, PitchpointError
from pitchpoint.model.numbers import key_at, number_at
from pitchpoint.solvers.exported_run import ExportedRun
from pitchpoint.solvers.input_places import Place, polynomial
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

DEGREE = 8
"""Degree of the polynomials; for the centre distance of a pair in 0.2 % their error is round-off."""
BETWEEN = np.array([-0.87, -0.31, 0.06, 0.55, 0.93])
"""Points of a range from -1 to 1 at which the polynomials are checked."""
RANGES = (0.2, 0.05, 0.01, 0.002)
"""Ranges that are tried, relative to the value of the file; the first with sufficient accuracy is taken."""

Array = NDArray[np.float64]
Words = dict[str, NDArray[np.int64]]
Found = tuple[tuple[int, tuple[float, ...]], ...]
Ranges = Mapping[str, tuple[float, float]]


def tunable_places(
    model: Model, scenario: str, run: ExportedRun, paths: Sequence[str], ranges: Ranges | None = None
) -> tuple[Place, ...]:
    """Places of parameters in the memory of a run.

    Parameters
    ----------
    model, scenario
        Model and name of its scenario.
    run
        Started run of the scenario.
    paths
        Paths of the parameters in the model file.
    ranges
        Smallest and largest value by path, where polynomials are required; default: the largest of `RANGES`.

    Raises
    ------
    ModelError
        If a path is not a number, or a word depends on it in a way that cannot be represented, or two
        parameters change the same word and do not add.
    """
    wanted = ranges or {}
    found = tuple(_place(model, scenario, run, path, wanted.get(path)) for path in paths)
    for k, place in enumerate(found):
        check_sums(model, scenario, run, found[:k], place)
    return found


def check_sums(model: Model, scenario: str, run: ExportedRun, others: Sequence[Place], place: Place) -> None:
    """Refuse a parameter that changes the same words as another one, unless their effects add.

    Parameters
    ----------
    model, scenario, run
        As for `tunable_places`.
    others
        Parameters, also those without common words.
    place
        The parameter.

    Raises
    ------
    ModelError
        If the effects do not add.
    """
    for other in others:
        if {offset for offset, _ in place.words} & {offset for offset, _ in other.words}:
            with _refusing(place.name):
                _check_sum(model, scenario, run, other, place)


def _place(
    model: Model, scenario: str, run: ExportedRun, path: str, limits: tuple[float, float] | None
) -> Place:
    found = number_at(model, path)
    if found is None:
        raise ModelError([Message(path, "is not a number of the model", remedy="name a number")])
    start, unit = found
    texts = (unit or "1", "parameter of the model file", start)
    study = _Study(model, scenario, run, path)
    values = [start + change * (abs(start) or 1.0) for change in CHANGES]
    if limits is None and (words := study.affine(values)) is not None:
        place = Place(path, *texts, words, *_permitted(model, path, start))
        with _refusing(path):
            study.check(place, values[2])
        return place
    tried = [limits] if limits else [_around(start, share) for share in RANGES]
    for least, most in tried:
        try:
            with _refusing(path):
                place = Place(path, *texts, study.interpolated(start, least, most), least, most)
                study.check(place, least + 0.8 * (most - least))
        except ModelError:
            if (least, most) == tried[-1]:
                raise
        else:
            return place
    raise AssertionError(path)


def _permitted(model: Model, path: str, start: float) -> tuple[float, float]:
    """Range of a number in model files; 1/1000 of the distance is kept from a limit that is not allowed."""
    key = key_at(model, path)
    if key is None:
        return -math.inf, math.inf
    least = key.minimum + (1e-3 * (start - key.minimum) if key.above else 0.0)
    return least, key.maximum - (1e-3 * (key.maximum - start) if key.below else 0.0)


def _around(start: float, share: float) -> tuple[float, float]:
    """Range around a value."""
    room = share * (abs(start) or 1.0)
    return start - room, start + room


@dataclass(frozen=True)
class _Study:
    """Compilations of a model with several values of a parameter."""

    model: Model
    scenario: str
    run: ExportedRun
    path: str

    @cached_property
    def fixed(self) -> set[int]:
        """Offsets of addresses and of inputs, which do not belong to a parameter."""
        found = {*self.run.image.moved, *(offset for offset, _ in self.run.code)}
        return found | {offset for place in self.run.inputs for offset, _ in place.words}

    def system(self, value: float) -> System:
        """System with another value of the parameter."""
        return _variant(self.model.replace(self.path, value), self.scenario)

    def changed(self, variants: Sequence[Words]) -> dict[int, Array]:
        """Offset of every word that depends on the parameter, and its values, the first of the file."""
        first, own = variants[0], np.frombuffer(self.run.image.data, np.int64)
        sizes = [{n: len(w) for n, w in each.items()} for each in variants]
        if any(each != sizes[0] for each in sizes):
            raise _refused(self.path, "changes the structure of the model")
        found = {}
        for name, bits in first.items():
            moved = np.any([other[name] != bits for other in variants[1:]], axis=0)
            for k in np.flatnonzero(moved).tolist():
                offset = self.run.image.at[name] + 8 * k
                if offset in self.fixed:
                    continue
                if int(own[offset // 8]) != int(bits[k]):
                    place = f"{name.partition('.')[2]}+{8 * k}"
                    raise _refused(self.path, f"changes data that are not numbers of elements ({place})")
                found[offset] = np.array([other[name][k] for other in variants]).view(np.float64)
        if not found:
            raise ModelError([Message(self.path, "changes nothing but inputs", remedy="leave it fixed")])
        return found

    def affine(self, values: Sequence[float]) -> Found | None:
        """Words and slopes if all are affine functions of the parameter, else None.

        None too if the model cannot be compiled with one of the values.
        """
        try:
            variants = [_words(self.system(value)) for value in values]
        except PitchpointError:
            return None
        words = []
        for offset, y in self.changed(variants).items():
            slope = (y[2] - y[3]) / (values[2] - values[3])
            straight = y[0] + slope * (np.array(values) - values[0])
            if not np.allclose(y, straight, rtol=STRAIGHT, atol=STRAIGHT * np.abs(y).max()):
                return None
            words.append((offset, (float(slope),)))
        return tuple(words)

    def interpolated(self, start: float, least: float, most: float) -> Found:
        """Words and coefficients of polynomials in a range, checked between the points."""
        if not least < most or not least <= start <= most:
            remedy = "give a range around the value of the model file"
            limit = f"{least:g} to {most:g}"
            raise ModelError([Message(self.path, "is out of its range", f"{start:g}", limit, remedy)])
        half, middle = 0.5 * (most - least), 0.5 * (most + least)
        nodes = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
        values = np.concatenate([[start], middle + half * nodes, middle + half * BETWEEN])
        x = (values - start) / half
        rows = np.vander(x[1 : DEGREE + 2], DEGREE + 1, increasing=True)[:, 1:]
        words = []
        for offset, y in self.changed([_words(self.system(v)) for v in values.tolist()]).items():
            rise = y - y[0]
            c = np.linalg.lstsq(rows, rise[1 : DEGREE + 2], rcond=None)[0]
            left = np.polynomial.polynomial.polyval(x, [0.0, *c]) - rise
            if not np.isfinite(y).all() or np.abs(left).max() > STRAIGHT * np.abs(y).max():
                what = f"changes a number that is not a smooth function of it from {least:g} to {most:g}"
                raise _refused(self.path, f"{what} ({self.run.image.place(offset)})")
            words.append((offset, tuple((c / half ** np.arange(1, DEGREE + 1)).tolist())))
        return tuple(words)

    def check(self, place: Place, value: float) -> None:
        """Compare the memory with a changed parameter with a model that was compiled with it."""
        _compare(self.run, self.system(place.start), self.system(value), ((place, value),))


def _compare(run: ExportedRun, plain: System, other: System, changes: Sequence[tuple[Place, float]]) -> None:
    """Refuse parameters whose words do not have the effect of a compilation with their values."""
    mine, other = run.system.copy(), other.copy()
    for place, value in changes:
        _write(mine, run.image.at, [(o, polynomial(c, value - place.start)) for o, c in place.words])
    _write(other, run.image.at, _from_the_start(run, plain), replaced=True)
    results = [_response(system, run.state) for system in (mine, other)]
    for a, b in zip(*results, strict=True):
        size = float(np.abs(b).max(initial=0.0))
        if not np.allclose(a, b, rtol=ALIKE, atol=ALIKE * size):
            names = " with ".join(place.name for place, _ in changes)
            raise _refused(names, "has effects that do not follow from the numbers of the elements")


def _check_sum(model: Model, scenario: str, run: ExportedRun, one: Place, two: Place) -> None:
    """Refuse two parameters that change the same words, unless their effects add."""
    changes = [
        (p, p.start + 0.3 * (min(p.most, p.start + (abs(p.start) or 1.0)) - p.start)) for p in (one, two)
    ]
    both = model
    for place, value in changes:
        both = both.replace(place.name, value)
    _compare(run, _variant(model, scenario), _variant(both, scenario), changes)


def _variant(model: Model, scenario: str) -> System:
    """Compiled system of a model."""
    system = compile_model(model, scenario)
    system.workspace  # noqa: B018 - writes addresses of tables to the records
    return system


def _words(system: System) -> Words:
    """Words of all arrays that may depend on a parameter."""
    found = {n: a for n, a in arrays_of(system).items() if n.startswith(GROUPS)}
    return {name: np.frombuffer(array.tobytes(), np.int64) for name, array in found.items()}


def _refused(path: str, what: str) -> ModelError:
    remedy = (
        "leave it fixed, or give quantities that depend on it as values, such as damping instead of a ratio"
    )
    return ModelError([Message(path, what, remedy=remedy)])


@contextmanager
def _refusing(path: str) -> Iterator[None]:
    """Refuse a parameter with which the model cannot be compiled or evaluated."""
    try:
        yield
    except ModelError:
        raise
    except PitchpointError as error:
        raise _refused(path, str(error)) from error


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
