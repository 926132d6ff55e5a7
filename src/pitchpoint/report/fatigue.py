# SPDX-License-Identifier: Apache-2.0
"""Fatigue loads of results: rain-flow cycles of channels, load pulses of the teeth, over all load cases."""

from __future__ import annotations

import fnmatch
import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.analysis.rainflow import equivalent_load, load_duration, rainflow
from pitchpoint.analysis.tooth_pulses import Pulses, find_passages, find_pulses, tooth_loads
from pitchpoint.core.errors import PitchpointError
from pitchpoint.report.same_machine import require_same_machine
from pitchpoint.report.stored_model import model_of
from pitchpoint.report.tooth_numbers import pair_places, tooth_numbers
from pitchpoint.viz.quantities import settle_time_of

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

SLOPES = (4.0, 10.0)
"""Exponents of the Wöhler line: welded and forged steel, glass-fibre blades."""
TOOTH_SLOPE = 8.738
"""Of the force of a tooth over life: tooth root of case-hardened gears (ISO 6336-6)."""
FREE = 1e-3
"""Moment over the largest one of the same beam up to which an end counts as free."""
FEW = 10
"""Pulses of a tooth below which one more or less changes its equivalent force noticeably."""
TRUNCATED = 10.0
"""Samples per mesh period below which the peaks of tooth forces are noticeably too low."""


@dataclass
class LoadCases:
    """Results as load cases, each with its time in the life.

    Attributes
    ----------
    hours
        Time of each result in the life [h]; None: its own duration.
    """

    model: Model
    results: Sequence[xr.Dataset]
    hours: Sequence[float | None]
    notes: list[str] = field(default_factory=list)
    forces: set[str] = field(default_factory=set, repr=False)
    _found: dict[tuple[int, str], Pulses | None] = field(default_factory=dict, repr=False)

    def time(self, data: xr.Dataset) -> tuple[slice, Array]:
        """Evaluated samples, from the settle time of the run, and their times."""
        time = np.asarray(data["time"], float)
        first = int(np.searchsorted(time, time[0] + settle_time_of(data.attrs)))
        if time.size - first < 2:
            raise PitchpointError("the result has fewer than two samples after its settle time")
        return slice(first, None), time[first:]

    def pulses(self, number: int, mesh: str) -> Pulses | None:
        """Pulses of a mesh in a result, by number of the pair; None, with a note, if channels are missing."""
        if (number, mesh) not in self._found:
            self._found[number, mesh] = self._pulses(self.results[number], mesh)
        return self._found[number, mesh]

    def _pulses(self, data: xr.Dataset, mesh: str) -> Pulses | None:
        rows = [str(n) for n in data.data_vars if str(n).startswith(f"pair_force[{mesh}.")]
        if not rows and f"mesh_force[{mesh}]" not in data:
            return None
        number = max(len(rows), math.ceil(self.model.pairs[mesh].eps_gamma) + 1) if rows else 0
        if lost := [name for k in range(number) if (name := f"pair_force[{mesh}.{k}]") not in data]:
            self.note(f"{mesh}: no loads of teeth; the result lacks the channels {', '.join(lost)}")
            return None
        window, time = self.time(data)
        try:
            places = [place[window] for place in pair_places(self.model, data, mesh)]
        except PitchpointError as problem:
            self.note(f"{mesh}: no loads of teeth; {problem}")
            return None
        passed = abs(places[0][-1] - places[0][0])
        if time.size < TRUNCATED * passed:
            self.note(
                f"{mesh}: {time.size / passed:.1f} samples per mesh period; below {TRUNCATED:.0f} the peaks "
                "of tooth forces are too low: increase sample_rate"
            )
        if rows:
            self.forces.add("single tooth pairs")
            rows = [f"pair_force[{mesh}.{k}]" for k in range(number)]
            return find_pulses([np.asarray(data[n], float)[window] for n in rows], places)
        self.forces.add("whole meshes")
        self.note(f"{mesh}: without forces of single tooth pairs; the whole mesh force counts")
        return find_passages(np.asarray(data[f"mesh_force[{mesh}]"], float)[window], places)

    def require_one_machine(self) -> None:
        """Require the same bodies, meshes and teeth in all results; other differences are a note."""
        hashes = {str(data.attrs.get("model_hash", "")) for data in self.results} - {""}
        if len(hashes) < 2:
            return
        remedy = "evaluate results of different machines separately"
        require_same_machine(self.model, self.results, remedy)
        teeth = {name: gear.number_of_teeth for name, gear in self.model.gears.items()}
        for number, data in enumerate(self.results, start=1):
            try:
                own = {name: gear.number_of_teeth for name, gear in model_of(data).gears.items()}
            except PitchpointError:  # it refers to files that are not here, or to functions
                continue
            changed = sorted(name for name in {*teeth, *own} if teeth.get(name) != own.get(name))
            if changed:
                names = ", ".join(changed)
                raise PitchpointError(
                    f"result {number}: other numbers of teeth than result 1: {names}; {remedy}"
                )
        self.note("the results are of different versions of the model; teeth are those of the first one")

    def note(self, text: str) -> None:
        """Add a note once."""
        if text not in self.notes:
            self.notes.append(text)

    def weights(self) -> list[float]:
        """Repetitions of each result in the life."""
        found = []
        for data, hours in zip(self.results, self.hours, strict=True):
            _, time = self.time(data)
            found.append(1.0 if hours is None else 3600.0 * hours / float(time[-1] - time[0]))
        return found

    def life(self) -> float:
        """Whole time [s]."""
        times = [self.time(data)[1] for data in self.results]
        return sum(w * float(t[-1] - t[0]) for w, t in zip(self.weights(), times, strict=True))


def fatigue_loads(
    cases: LoadCases,
    patterns: Sequence[str] = (),
    slopes: Sequence[float] = SLOPES,
    cycles: float | None = None,
    tooth_slope: float = TOOTH_SLOPE,
) -> dict[str, Any]:
    """Damage-equivalent loads of channels, and loads of all teeth, of one or more results.

    Parameters
    ----------
    cases
        The results.
    patterns
        Names of channels, * matches any characters; default: `main_loads`.
    slopes
        Exponents of the Wöhler line.
    cycles
        Number of the equivalent cycles; default: one per second of the whole time.
    tooth_slope
        Exponent for the forces of teeth.

    Returns
    -------
    dict
        `duration` [s] and `cycles`; `channels` by name: `unit`, `min`, `mean`, `max`, `equivalent` (by
        slope), `counted` cycles, `levels` and `exceeded` of the load duration; `teeth` by gear and flank:
        `pulses`, `largest` and `equivalent` force [N] of the teeth from 0, the `worst` tooth, `levels`,
        `exceeded`; `tooth_force`, that of `teeth` in words, or None.
    """
    cases.require_one_machine()
    names = _chosen(cases.results, patterns) if patterns else main_loads(cases.model, cases.results)
    number = cases.life() if cycles is None else cycles
    channels = {name: _channel(cases, name, slopes, number) for name in names}
    return {
        "duration": cases.life(),
        "cycles": number,
        "slopes": list(slopes),
        "tooth_slope": tooth_slope,
        "channels": channels if patterns else _without_small(channels),
        "teeth": {} if patterns else _teeth(cases, tooth_slope),
        "tooth_force": f"forces of {' and '.join(sorted(cases.forces))}" if cases.forces else None,
        "notes": cases.notes,
    }


def main_loads(model: Model, results: Sequence[xr.Dataset]) -> list[str]:
    """Moments at both ends of all beams, torques of couplings and torsion springs, in all results."""
    wanted = []
    for beam, part in model.beams.items():
        ends = ("1.i", f"{part.pieces}.j")
        wanted += [f"beam_force[{beam}.{end}.{m}]" for end in ends for m in ("mx", "my", "mz")]
    wanted += [f"coupling_force[{name}.mz]" for name in model.couplings]
    wanted += [f"torque[{name}]" for name in (*model.torsion_springs, *model.torsion_maxwells)]
    return [name for name in wanted if all(name in data for data in results)]


def _without_small(channels: dict[str, Any]) -> dict[str, Any]:
    """Channels without the moments at the free ends of beams."""
    sizes: dict[str, float] = {}
    for name, row in channels.items():
        part = name.split(".")[0]
        sizes[part] = max(sizes.get(part, 0.0), abs(row["min"]), abs(row["max"]))
    largest = {name: max(abs(row["min"]), abs(row["max"])) for name, row in channels.items()}
    return {n: row for n, row in channels.items() if largest[n] > FREE * sizes[n.split(".")[0]]}


def _chosen(results: Sequence[xr.Dataset], patterns: Sequence[str]) -> list[str]:
    """Channels of all results that match one of the patterns."""
    known = [str(n) for n, v in results[0].data_vars.items() if v.dims == ("time",)]
    found: list[str] = []
    for pattern in patterns:
        own = [n for n in known if n == pattern or fnmatch.fnmatchcase(n, pattern.replace("[", "[[]"))]
        own = [n for n in own if all(n in data for data in results)]
        if not own:
            remedy = "`pitchpoint analyse FILE` lists the channels of a result"
            raise PitchpointError(f"no channel {pattern!r} in all results; {remedy}")
        found += [n for n in own if n not in found]
    return found


def _channel(cases: LoadCases, name: str, slopes: Sequence[float], number: float) -> dict[str, Any]:
    ranges, counts, values, seconds = [], [], [], []
    for data, weight in zip(cases.results, cases.weights(), strict=True):
        window, time = cases.time(data)
        x = np.asarray(data[name], float)[window]
        one = rainflow(x)
        ranges.append(one.range)
        counts.append(weight * one.count)
        values.append(x)
        seconds.append(weight * np.gradient(time))
    spread, count = np.concatenate(ranges), np.concatenate(counts)
    x, duration = np.concatenate(values), np.concatenate(seconds)
    levels = load_duration(x, duration)
    return {
        "unit": str(cases.results[0][name].attrs.get("units", "")),
        "min": float(x.min()),
        "mean": float((x * duration).sum() / duration.sum()),
        "max": float(x.max()),
        "equivalent": [equivalent_load(spread, count, m, number) for m in slopes],
        "counted": float(count.sum()),
        "levels": levels.level.tolist(),
        "exceeded": levels.exceeded.tolist(),
    }


def _teeth(cases: LoadCases, slope: float) -> dict[str, dict[str, Any]]:
    """Loads of the teeth of all gears, by gear and flank."""
    found: dict[str, dict[str, Any]] = {}
    few: list[str] = []
    for gear, meshes in _meshes_of_gears(cases.model).items():
        teeth = cases.model.gears[gear].number_of_teeth
        pulses = [_pulses(cases, number, meshes) for number in range(len(cases.results))]
        if not all(pulses):
            continue
        weights = cases.weights()
        alone = [tooth_loads(one, teeth, slope) for one in pulses]
        for flank in ("front", "back"):
            parts = [(w, a[flank]) for w, a in zip(weights, alone, strict=True) if flank in a]
            if not parts:
                continue
            count = np.sum([w * p.pulses for w, p in parts], axis=0)
            mean = float(np.mean(count))
            top = max(float(p.largest.max()) for _, p in parts)
            total = sum(w * p.forces.size / teeth * (p.equivalent / top) ** slope for w, p in parts)
            equivalent = top * (total / mean) ** (1.0 / slope)
            forces = np.concatenate([p.forces for _, p in parts])
            if count.min() < FEW:
                few.append(gear)
            levels = load_duration(forces, np.concatenate([np.full(p.forces.size, w) for w, p in parts]))
            found.setdefault(gear, {})[flank] = {
                "pulses": [float(c) for c in count],
                "largest": np.max([p.largest for _, p in parts], axis=0).tolist(),
                "equivalent": equivalent.tolist(),
                "worst": int(np.argmax(equivalent)),
                "levels": levels.level.tolist(),
                "exceeded": levels.exceeded.tolist(),
            }
    if few:
        words = ", ".join(dict.fromkeys(few))
        cases.notes.append(
            f"fewer than {FEW} pulses per tooth of {words}: the equivalent forces of single teeth depend on "
            "the length of the results"
        )
    return found


def _meshes_of_gears(model: Model) -> dict[str, list[tuple[str, int]]]:
    """By gear: each of its meshes, and whether it is gear 1 (0) or gear 2 (1) there."""
    found: dict[str, list[tuple[str, int]]] = {}
    for name, mesh in model.meshes.items():
        if None not in [model.body_of(g) for g in mesh.gears]:
            for k, gear in enumerate(mesh.gears):
                found.setdefault(gear, []).append((name, k))
    return found


def _pulses(cases: LoadCases, number: int, meshes: Sequence[tuple[str, int]]) -> list[Pulses]:
    """Pulses of a gear in each of its meshes; empty if a mesh lacks channels."""
    found = []
    for mesh, gear in meshes:
        own = cases.pulses(number, mesh)
        if own is None:
            return []
        found.append(replace(own, tooth=tooth_numbers(cases.model, mesh, own, gear)))
    return found
