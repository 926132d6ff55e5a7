# SPDX-License-Identifier: Apache-2.0
"""Inputs of a stepper: their values, and the words of the memory that follow them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.elements.kind import DRIVE
from pitchpoint.solvers.input_places import (
    Place,
    constant_drives,
    drive_places,
    lead,
    load_places,
    polynomial,
)
from pitchpoint.system.image import arrays_of, offsets, word_at
from pitchpoint.system.system import System


class StepperInputs:
    """Constant loads, numbers of the model, and constant speeds of drives.

    Parameters
    ----------
    system
        Started system; its memory is changed.
    more
        Places of numbers of the model.

    Attributes
    ----------
    values, units
        Present value and unit of each input.
    ends
        Whether drives are defined up to the end of the scenario only.
    """

    def __init__(self, system: System, more: Sequence[Place] = ()) -> None:
        arrays = arrays_of(system)
        at, _ = offsets(arrays)
        places, drives = [*load_places(system, at), *more], drive_places(system, at)
        self._words: dict[int, tuple[NDArray[np.float64], float]] = {}
        self._terms: dict[int, list[tuple[str, tuple[float, ...]]]] = {}
        for p in places:
            for offset, terms in p.words:
                word = word_at(arrays, at, offset)
                self._words[offset] = word, float(word[0])
                self._terms.setdefault(offset, []).append((p.name, terms))
        found = constant_drives(system)
        self._drives = {name: system.records[kind][k] for name, (kind, k) in found.items()}
        self.ends = sum(len(system.records[kind]) for kind in system.kinds(DRIVE)) > len(drives)
        self._start = {p.name: p.start for p in (*places, *drives)}
        self._ranges = {p.name: (p.least, p.most) for p in (*places, *drives)}
        self.values = dict(self._start)
        self.units = {p.name: p.unit for p in (*places, *drives)}

    def set(self, values: Mapping[str, float]) -> bool:
        """Set values by name; returns whether forces have changed.

        Speeds of drives change in the next communication step.

        Raises
        ------
        ModelError
            If a name is not an input, or a value is not finite or out of range; then none is set.
        """
        problems = []
        for name, value in values.items():
            if name not in self.values:
                listed = ", ".join(self.values) or "there are none: add a constant load, or name `inputs`"
                known = did_you_mean(name, self.values)
                problems.append(Message(name, "is not an input", remedy=f"{known}inputs: {listed}"))
            elif not math.isfinite(value):
                problems.append(Message(name, "is not a finite number", str(value), remedy="check its law"))
            elif not self._ranges[name][0] <= value <= self._ranges[name][1]:
                shown = f"{value:.9g} {self.units[name]}", "{:.9g} to {:.9g}".format(*self._ranges[name])
                remedy = "change it in the model file, and start again"
                problems.append(Message(name, "is out of range", *shown, remedy))
        if problems:
            raise ModelError(problems)
        changed = {name for name, value in values.items() if float(value) != self.values[name]}
        self.values |= {name: float(values[name]) for name in changed}
        for offset, terms in self._terms.items():
            if any(name in changed for name, _ in terms):
                word, base = self._words[offset]
                word[0] = base + sum(polynomial(c, self.values[n] - self._start[n]) for n, c in terms)
        return bool(changed - set(self._drives))

    def lead(self, t: float, step: float) -> bool:
        """Let the speeds of drives vary in the next communication step; returns whether a force jumps."""
        jumps = [lead(record, self.values[name], t, step) for name, record in self._drives.items()]
        return any(jumps)
