# SPDX-License-Identifier: Apache-2.0
"""Diagnosis of shafts, gears and bearings from vibration signals, with a stated false alarm probability in
noise.

Every piece of evidence is a test with the probability that noise alone exceeds its limit. All tests of a
record of noise together have the false alarm probability that the caller allows; machines are not noise, and
no rate of false alarms is stated for them. A part without a finding is not declared healthy: tests that could
not be performed are reported too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.bearing_tests import FROM_MESHES, bearing_evidence
from pitchpoint.analysis.explaining import Channel, explain
from pitchpoint.analysis.family_evidence import family_evidence
from pitchpoint.analysis.findings import COMBS, Evidence, Finding, findings_of
from pitchpoint.analysis.line_tests import fine_spectrum, line_threshold
from pitchpoint.analysis.remarks import Note, grouped
from pitchpoint.analysis.same_fault import across_channels
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive
from pitchpoint.analysis.shaft_periods import of_slower_shafts, shaft_periods
from pitchpoint.analysis.shaft_tests import (
    HARMONICS,
    MIN_TURNS,
    NEIGHBOURS,
    SLIP,
    Measured,
    ShaftView,
)
from pitchpoint.analysis.turning_parts import Mesh, TurningParts

MESH_PROBABILITY = 1e-4
"""Probability that noise alone is taken for a mesh line."""
PASSING = "meshes modulated by ball passage"
"""Explanation of bearing lines that are not due to impacts."""


@dataclass(frozen=True)
class MeshLines:
    """Lines of a mesh in one channel.

    Attributes
    ----------
    mesh
        Name of the mesh.
    order
        Mesh order [-].
    amplitude
        Shape (n,). Amplitudes of the harmonics within the bandwidth, in the unit of the channel.
    seen
        Whether a harmonic is a line above the noise and larger than its sidebands.
    lost
        Numbers of the first five harmonics that are above the bandwidth of the record [-].
    """

    mesh: str
    order: float
    amplitude: Array
    seen: bool
    lost: tuple[int, ...]


@dataclass(frozen=True)
class Diagnosis:
    """Result of a diagnosis.

    Attributes
    ----------
    findings
        Findings, the most certain first.
    observations
        What sound machines show as well, such as raised lowest orders; no verdict follows from one record.
    evidence
        All tests of all channels.
    meshes
        Mesh lines by channel.
    untested
        Remarks on tests that could not be performed.
    unreported
        Remarks on significant tests that are not findings.
    turns
        Revolutions of each shaft in the record [-].
    tests
        Number of tests that share the false alarm probability [-].
    false_alarm
        Probability that a record of noise has a finding [-].
    """

    findings: tuple[Finding, ...]
    observations: tuple[Finding, ...]
    evidence: tuple[Evidence, ...]
    meshes: Mapping[str, tuple[MeshLines, ...]]
    untested: tuple[str, ...]
    unreported: tuple[str, ...]
    turns: Mapping[str, float]
    tests: int
    false_alarm: float


def diagnose(
    signals: Mapping[str, ArrayLike],
    samples_per_turn: float,
    parts: TurningParts,
    *,
    false_alarm: float = 0.01,
    sampled_per_turn: float | None = None,
    speed_tolerance: float = 0.0,
    slip: float = SLIP,
) -> Diagnosis:
    """Evidence and findings from channels over the angle of the reference shaft.

    Parameters
    ----------
    signals
        Channels, shape (n,) each, any unit, at equal steps of the angle; at a steady speed also of time.
    samples_per_turn
        Samples per revolution of the reference shaft [-].
    parts
        Rotating parts of the machine.
    false_alarm
        Probability that a record of noise has a finding [-].
    sampled_per_turn
        Samples per revolution of the original record, if it was resampled [-].
    speed_tolerance
        Relative tolerance of the speed [-]. If it is not zero, the orders of shafts are not tested.
    slip
        Maximum relative deviation of bearing orders due to slip [-].

    Returns
    -------
    Diagnosis
        Findings, all tests, and remarks on tests that could not be performed.

    Raises
    ------
    SignalError
        If a channel is constant or not finite, or nothing can be tested.

    Notes
    -----
    A local fault raises all orders of its shaft [1]_: rank test of the orders without mesh orders against the
    points between them, and test of the lowest orders in the wavelet level of each mesh. Slow variations over
    the revolution raise single orders and sidebands [2]_: lines against the adjacent points. The false alarm
    probability is shared between the tests after [3]_. Valid for shafts with fixed axes.

    References
    ----------
    .. [1] P. D. McFadden, A revised model for the extraction of periodic waveforms by time domain averaging,
       Mechanical Systems and Signal Processing 1(1), 1987, 83-95.
    .. [2] R. B. Randall, A new method of modeling gear faults, Journal of Mechanical Design 104(2), 1982,
       259-267.
    .. [3] Z. Šidák, Rectangular confidence regions for the means of multivariate normal distributions,
       Journal of the American Statistical Association 62, 1967, 626-633.

    Examples
    --------
    A wheel of 40 teeth, one of them damaged, driven by a pinion of 21 teeth:

    >>> from pitchpoint.analysis.turning_parts import train_parts
    >>> turned = np.arange(100_000) / 500.0
    >>> knock = np.exp(-(((turned * 21 / 40 + 0.3) % 1 - 0.5) / 0.003) ** 2)
    >>> noise = np.random.default_rng(1).standard_normal(turned.size)
    >>> x = np.cos(2 * np.pi * 21 * turned) + knock + 0.5 * noise
    >>> found = diagnose({"acc": x}, 500.0, train_parts([(21, 40)]))
    >>> [(finding.kind, finding.shaft, finding.gears) for finding in found.findings]
    [('local fault', 'shaft 2', ('Z2',))]
    """
    rate = positive(samples_per_turn, "samples_per_turn")
    allowed = positive(false_alarm, "false_alarm")
    raw: list[tuple[str, str, str, str, Measured]] = []
    channels: dict[str, Channel] = {}
    meshes, turns = {}, {}
    untested, others, families = list[Note](), list[Note](), list[Evidence]()
    of_families = partial(
        family_evidence, tolerance=speed_tolerance, slip=slip, false_alarm=allowed, channels=len(signals)
    )
    modulated: set[tuple[str, str]] = set()
    for name, values in signals.items():
        x = as_signal(values, name, 64)
        if float(np.ptp(x)) == 0.0:
            raise SignalError(f"{name}: is constant; nothing can be read from it")
        alone = bool(parts.bearings) and not parts.meshes
        if alone:  # before the spectrum, which would be in the memory at the same time
            rows, notes, foreign = of_families(name, x, rate, parts)
            families += rows
            untested += notes
            others += foreign
        spectrum, rms = fine_spectrum(x, rate), float(x.std())
        mine = {s.name: ShaftView(spectrum, parts, s, rms, sampled_per_turn or rate) for s in parts.shafts}
        turns = {shaft: view.turns for shaft, view in mine.items()}
        meshes[name] = tuple(_mesh_lines(mine, parts, mesh) for mesh in parts.meshes)
        channels[name] = Channel(x, rate, mine, None)
        if speed_tolerance == 0.0:
            raw += [(name, *row) for row in _of_shafts(mine, parts, meshes[name])]
            raw += [(name, *row) for row in shaft_periods(x, rate, mine, parts)]
        if alone:
            continue
        bearings, remarks, envelopes = bearing_evidence(x, rate, parts, slip + speed_tolerance)
        channels[name] = Channel(x, rate, mine, envelopes)
        raw += [(name, "bearing", part, bearing, found) for bearing, part, found in bearings]
        untested += remarks
        modulated |= {(name, note.subject) for note in remarks if note.reason == FROM_MESHES}
    by_meshes = [note for note in untested if note.reason == FROM_MESHES]
    untested = _with_unseen([note for note in untested if note.reason != FROM_MESHES], raw)
    few = _too_few(turns)
    tests = sum(1 for row in raw if row[4].lines > 0) + len(families)
    if not tests and speed_tolerance == 0.0:
        reasons = grouped([*few, *untested]) or ["use a longer one, or a higher sample rate"]
        raise SignalError("record: is too short for any test; " + "; ".join(reasons))
    every = of_slower_shafts([_evidence(row, tests, allowed) for row in raw if row[4].lines > 0], parts)
    evidence, explained = explain(_without_passing(every, modulated), channels, parts, tests)
    revolutions = min(as_signal(x).size for x in signals.values()) / rate
    evidence = across_channels((*evidence, *families), parts, revolutions)
    views = {(name, shaft): view for name, one in channels.items() for shaft, view in one.shafts.items()}
    findings, observations, spread = findings_of(evidence, views, signals, rate, parts)
    not_tested = tuple(grouped([*few, *untested]))
    not_reported = tuple(grouped([*explained, *spread, *by_meshes, *others]))
    return Diagnosis(
        findings, observations, evidence, meshes, not_tested, not_reported, turns, tests, allowed
    )


def _with_unseen(untested: list[Note], raw: list[tuple[str, str, str, str, Measured]]) -> list[Note]:
    """Remarks on tests that could not be performed, with those without usable lines."""
    named = {note.subject for note in untested}
    unseen = [_not_looked_at(row) for row in raw if row[4].lines == 0]
    return [*untested, *(note for note in unseen if note.subject not in named)]


def _too_few(turns: Mapping[str, float]) -> list[Note]:
    """Remarks on shafts with too few revolutions."""
    why = f"too few revolutions of {{}}; needs about {MIN_TURNS:g}"
    return [Note(why, f"{shaft} ({count:.2g})") for shaft, count in turns.items() if count < MIN_TURNS]


def _without_passing(every: Sequence[Evidence], modulated: set[tuple[str, str]]) -> tuple[Evidence, ...]:
    """Evidence in which lines of meshes modulated by ball passage are marked as explained."""
    return tuple(
        replace(e, explained=PASSING)
        if (e.channel, f"{e.shaft} of {e.gear}") in modulated and e.value > e.threshold
        else e
        for e in every
    )


def _of_shafts(
    views: Mapping[str, ShaftView], parts: TurningParts, lines: tuple[MeshLines, ...]
) -> list[tuple[str, str, str, Measured]]:
    """Tests of all shafts and of their gears."""
    held = {line.mesh for line in lines if line.amplitude.size}
    found = []
    for shaft, view in views.items():
        if not view.testable:
            continue
        found.append(("comb", shaft, "", view.comb()))
        found.append(("low order", shaft, "", view.low_orders()))
        for gear, (mesh, teeth) in parts.gears_of(shaft).items():
            if mesh.name in held:
                found.append(("sidebands", shaft, gear, view.sidebands(parts.mesh_order(mesh), teeth)))
    return found


def _mesh_lines(views: Mapping[str, ShaftView], parts: TurningParts, mesh: Mesh) -> MeshLines:
    """Harmonics of a mesh, compared with the adjacent points and the sidebands of its faster shaft."""
    order = parts.mesh_order(mesh)
    fast = max((views[name] for name in mesh.shafts), key=lambda view: view.order)
    spectrum = fast.spectrum
    harmonic = np.arange(1, HARMONICS + 1)
    inside = harmonic * order < 0.95 * spectrum.highest
    power = spectrum.power(harmonic[inside] * order)
    seen = False
    for k in harmonic[inside]:
        line = fast.line(float(k * order)) if fast.testable else None
        around = k * order + np.array([-2, -1, 1, 2]) * fast.order
        around = around[(around > 0.0) & fast.free(around)]
        larger = around.size == 0 or power[k - 1] > spectrum.power(around).max()
        seen |= line is not None and line.probability < MESH_PROBABILITY / HARMONICS and bool(larger)
    lost = tuple(int(k) for k in harmonic[~inside])
    return MeshLines(mesh.name, order, np.sqrt(power), seen, lost)


def _not_looked_at(row: tuple[str, str, str, str, Measured]) -> Note:
    """Remark on a test without usable lines."""
    _, kind, shaft, gear, _ = row
    what = {"comb": "orders", "period": "period", "low order": "lowest orders", "sidebands": "sidebands"}.get(
        kind, shaft
    )
    whose = gear if kind == "bearing" else f"{gear} ({shaft})" if gear else shaft
    return Note(
        "no test of the {}: above the record's highest frequency, or too near to other lines",
        f"{what} of {whose}",
    )


def _evidence(row: tuple[str, str, str, str, Measured], tests: int, allowed: float) -> Evidence:
    """Evidence from a test, with probability and threshold for the number of all tests."""
    from scipy.stats import norm

    channel, kind, shaft, gear, found = row
    together = float(-np.expm1(tests * np.log1p(-min(found.probability, 1.0 - 1e-16))))
    each = -np.expm1(np.log1p(-allowed) / tests)
    if kind in COMBS:
        value = found.score
        threshold = float(norm.isf(-np.expm1(np.log1p(-each) / found.choices)))
    else:
        one = each / found.lines
        # for a bearing two of three harmonics must be significant
        one = float(np.sqrt(one / 3.0)) if kind == "bearing" else one
        ratio = line_threshold(one, NEIGHBOURS, (3 * NEIGHBOURS) // 4)
        value, threshold = 10.0 * np.log10(max(found.score, 1e-30)), 10.0 * np.log10(ratio)
    return Evidence(
        channel=channel,
        kind=kind,
        shaft=shaft,
        gear=gear,
        value=float(min(value, 300.0)),
        threshold=float(threshold),
        probability=together,
        order=found.order,
        amplitude=found.amplitude,
        sideband=found.sideband,
        found=together < allowed,
        allowed=allowed,
        explained=found.rule if value > threshold else "",
    )
