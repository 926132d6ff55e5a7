# SPDX-License-Identifier: Apache-2.0
"""Sentences about findings: evidence and channel, without interpretation beyond them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pitchpoint.analysis.diagnosis import Diagnosis
from pitchpoint.analysis.family_evidence import PARTLY
from pitchpoint.analysis.findings import COMBS, Evidence, Finding
from pitchpoint.analysis.remarks import Note, grouped
from pitchpoint.analysis.shaft_periods import MESH_HARMONICS
from pitchpoint.analysis.turning_parts import TurningParts

BEARING_WORDS = {
    "outer ring": "a local fault on the outer ring",
    "inner ring": "a local fault on the inner ring",
    "rolling element": "a local fault on a rolling element",
    "cage": "a fault of the cage",
}

NEVER = -100.0
"""Level [dB] below which a line counts as absent."""
NOT_VISIBLE = "not visible in "
RULES = ("below ", "slope ", NOT_VISIBLE, PARTLY)
"""Beginnings of reasons that are not another fault."""
NO_IMPACTS = "impacts not confirmed"
"""Why a bearing part with a line above its limit is not named."""
BY_NOISE = "possible by noise"
SIDEBAND_CAUSES = {1: "runout, eccentricity or misalignment", 2: "misalignment or an oval gear"}
MANY_PER_TURN = "deviations that vary several times per turn, such as pitch errors"
"""Causes of sidebands on sound machines by their number."""
SHARED = "lines of a clearer part"
"""Why a significant test is neither a finding nor an observation."""
LOST = "sample rate: above half of it, not testable: {}"


def nothing_found(diagnosis: Diagnosis) -> str:
    """Sentence for a record without findings; it does not state that the machine is healthy."""
    beyond = sum(e.value > e.threshold for e in diagnosis.evidence)
    tests = f"{diagnosis.tests} tests" if diagnosis.tests > 1 else "1 test"
    if not beyond:
        return f"nothing found: none of {tests} exceeds its limit"
    which = "exceeds its limit" if beyond == 1 else "exceed their limits"
    return f"nothing found: {beyond} of {tests} {which}, but not in the pattern of damage"


def sentence(finding: Finding, diagnosis: Diagnosis, parts: TurningParts, frequency: float) -> str:
    """One finding in words.

    Parameters
    ----------
    finding
        The finding.
    diagnosis
        Diagnosis with the finding.
    parts
        Rotating parts.
    frequency
        Rotation frequency of the reference shaft [Hz]; NaN if it varies.
    """
    mine = evidence_of(finding, diagnosis)
    seen = "; ".join(dict.fromkeys(_seen(e, parts, frequency) for e in _same_lines(mine)[:3]))
    chance = f"by noise alone: {percent(finding.probability)}, {_over(diagnosis.tests)}"
    where = f"in {finding.channel}"
    if finding.kind == "bearing":
        what = BEARING_WORDS.get(finding.shaft, f"a fault of the {finding.shaft}")
        named = f"{finding.gears[0]}{_or_bearings(finding)}"
        return f"{what} of {_bearing(named)}, seen {where} as {seen} ({chance})"
    gears = _gears(finding.gears)
    turning = _rate(float(parts.shaft(finding.shaft).order), frequency)
    shaft = _named(finding.shaft)
    on = f"{gears} ({shaft}, {turning})" if gears else f"{shaft} ({turning})"
    text = f"a local fault on {on}, seen {where} as {seen}"
    return f"{text} ({chance}){_cannot_tell(finding)}"


def observation(
    finding: Finding, diagnosis: Diagnosis, parts: TurningParts, frequency: float, unit: str
) -> str:
    """One observation in words, with its level.

    Parameters
    ----------
    finding
        The observation.
    diagnosis
        Diagnosis with the observation.
    parts
        Rotating parts.
    frequency
        Rotation frequency of the reference shaft [Hz]; NaN if it varies.
    unit
        Unit of its channel; empty if unknown.
    """
    shaft = f"{_named(finding.shaft)} ({_rate(float(parts.shaft(finding.shaft).order), frequency)})"
    mine = [e for e in diagnosis.evidence if e.channel == finding.channel and e.shaft == finding.shaft]
    if finding.kind == "modulation":
        e = max((e for e in mine if e.kind == "sidebands" and e.found), key=lambda e: e.value)
        mesh = next(
            line
            for line in diagnosis.meshes[e.channel]
            if line.mesh == parts.gears_of(e.shaft)[e.gear][0].name
        )
        ratio = e.amplitude / max(float(mesh.amplitude.max(initial=0.0)), 1e-300)
        gears = _gears(finding.gears).removeprefix("gear ")
        return (
            f"sidebands of the mesh of {gears} at multiples of the speed of {shaft}: the clearest, sideband "
            f"{_signed(e.sideband)}, is at {_rate(e.order, frequency)} in {e.channel}, {100.0 * ratio:.2g} % "
            f"of the largest mesh line; {SIDEBAND_CAUSES.get(abs(e.sideband), MANY_PER_TURN)}"
        )
    if finding.kind == "once per turn":
        e = max((e for e in mine if e.kind == "low order" and e.found), key=lambda e: e.value)
        return (
            f"raised lowest orders of {shaft}: line at {_rate(e.order, frequency)} in {e.channel}"
            f"{_level(e, frequency, unit)}, {e.value:.0f} dB above its surroundings; unbalance, "
            "misalignment or a bent shaft"
        )
    where = (
        "impacts at one angle of the turn are not" if parts.gears_of(finding.shaft) else "the cause is not"
    )
    e = max((e for e in mine if e.kind in COMBS and e.found), key=lambda e: (e.kind == "comb", e.value))
    if e.kind == "period":
        return f"{_seen(e, parts, frequency)} in {e.channel}; {where} visible"
    return (
        f"raised orders of {shaft} about {_rate(e.order, frequency)} in {e.channel}, {e.value:.1f} standard "
        f"deviations above the spectrum between them; {where} visible"
    )


def _level(e: Evidence, frequency: float, unit: str) -> str:
    """Level of a line as rms velocity if its unit is one of vibration, else as amplitude."""
    from pitchpoint.analysis.severity import velocity_factor

    factor = velocity_factor(unit, e.order * frequency)
    if factor is not None:
        return f" with {1e3 * factor * e.amplitude / math.sqrt(2.0):.2g} mm/s rms"
    return f" with an amplitude of {e.amplitude:.3g} {unit}".rstrip()


def _over(tests: int) -> str:
    return "over 1 test" if tests == 1 else f"over all {tests} tests"


def evidence_of(finding: Finding, diagnosis: Diagnosis) -> list[Evidence]:
    """Evidence that supports a finding, in the channel of the finding, strongest kind first."""
    return [e for e in evidence_in(finding, diagnosis) if e.channel == finding.channel]


def evidence_in(finding: Finding, diagnosis: Diagnosis) -> list[Evidence]:
    """Evidence that supports a finding, in all channels, strongest kind first."""
    mine = [
        e
        for e in diagnosis.evidence
        if e.found
        and e.shaft == finding.shaft
        and (e.kind == "bearing") == (finding.kind == "bearing")
        and (e.kind not in COMBS or finding.kind == "local fault")
        and (e.kind != "bearing" or e.gear == finding.gears[0])
    ]
    kinds = {"comb": 0, "period": 1, "sidebands": 2, "low order": 3, "bearing": 4}
    mine.sort(key=lambda e: (kinds[e.kind], e.probability))
    return mine


def mesh_remarks(
    diagnosis: Diagnosis, parts: TurningParts, frequency: float, strongest: Mapping[str, Sequence[float]]
) -> tuple[list[str], bool]:
    """Remarks on meshes without a visible line; whether none is visible although the record covers some."""
    lost, remarks, seen, held = [], [], False, False
    for k, mesh in enumerate(parts.meshes):
        lines = [rows[k] for rows in diagnosis.meshes.values()]
        first = lines[0]
        if first.lost:
            which = ", ".join(str(number) for number in first.lost)
            many = "harmonics" if len(first.lost) > 1 else "harmonic"
            lost.append(Note(LOST, f"{many} {which} of {mesh.name} ({_rate(first.order, frequency)})"))
        if not first.amplitude.size:
            continue
        held = True
        if any(line.seen for line in lines):
            seen = True
            continue
        listed = strongest[next(iter(diagnosis.meshes))]
        found = ", ".join(_rate(order, frequency) for order in listed)
        remarks.append(
            f"{mesh.name}: no mesh line at {_rate(first.order, frequency)} or its harmonics stands out; "
            f"strongest lines at {found}; check tooth counts and speed, or give the "
            "range of a run-up as in --speed 600..1800rpm"
        )
    return [*grouped(lost), *remarks], held and not seen


def percent(probability: float) -> str:
    """Probability in percent.

    Examples
    --------
    >>> percent(0.01), percent(3.2e-4), percent(1e-12)
    ('1 %', '0.032 %', 'less than 0.001 %')
    """
    if probability < 1e-5:
        return "less than 0.001 %"
    return f"{100.0 * probability:.0f} %" if probability >= 0.1 else f"{100.0 * probability:.2g} %"


def evidence_rows(diagnosis: Diagnosis, frequency: float) -> list[dict[str, Any]]:
    """All tests as plain data, in Hz if the speed is known."""
    return [
        {
            "channel": e.channel,
            "kind": e.kind,
            "shaft": e.shaft,
            "gear": e.gear,
            "value": e.value,
            "threshold": e.threshold,
            "unit": "standard deviations" if e.kind in COMBS else "dB",
            "by_noise": e.probability,
            "order": e.order,
            "frequency": e.order * frequency,
            "amplitude": e.amplitude,
            "sideband": e.sideband,
            "found": e.found,
            "explained_by": e.explained,
            "detectors": list(e.detectors),
            "result": outcome(e, diagnosis),
        }
        for e in diagnosis.evidence
    ]


def cells_of_test(e: Evidence, diagnosis: Diagnosis) -> tuple[str, str, str, str, str, str]:
    """Cells of a test: whose it is, test, value, limit, probability by noise, result."""
    unit = unit_of(e.kind)
    by_rule = e.explained.startswith(RULES[:2])
    return (
        e.gear if e.kind == "bearing" else e.shaft,
        what_is_tested(e),
        f"{e.value:.1f} {unit}" if e.value > NEVER else "–",
        f"{e.threshold:.1f} {unit}",
        # a line that a rule excludes has no probability
        "–" if by_rule else percent(e.probability).replace("less than", "<"),
        outcome(e, diagnosis),
    )


def unit_of(kind: str) -> str:
    """Unit of the value of a test.

    Examples
    --------
    >>> unit_of("comb"), unit_of("sidebands")
    ('σ', 'dB')
    """
    return "σ" if kind in COMBS else "dB"


def outcome(e: Evidence, diagnosis: Diagnosis) -> str:
    """Result of a test; for a test above its limit without a finding the reason."""
    if e.explained:
        return e.explained if e.explained.startswith(RULES) else f"explained by {e.explained}"
    if not e.found:
        beyond = e.value > e.threshold
        return "" if not beyond else NO_IMPACTS if e.kind == "bearing" else BY_NOISE
    if any(e in evidence_in(finding, diagnosis) for finding in diagnosis.findings):
        return "found"
    if e.kind != "bearing" and any(one.shaft == e.shaft for one in diagnosis.observations):
        return "observed"
    return SHARED


def what_is_tested(e: Evidence) -> str:
    """Name of a test, of a bearing part with the detector whose value is stated."""
    if e.kind == "bearing":
        return ", by ".join((e.shaft, *e.detectors[:1]))
    if e.kind == "sidebands":
        return f"sidebands of {e.gear}"
    if e.kind == "period":
        return f"period in the level of {e.gear}"
    return {"comb": "all orders", "low order": "lowest orders"}[e.kind]


def _seen(e: Evidence, parts: TurningParts, frequency: float) -> str:
    if e.kind == "comb":
        turning = _rate(float(parts.shaft(e.shaft).order), frequency)
        return (
            f"a comb of lines at multiples of {turning} about {_rate(e.order, frequency)}, "
            f"{e.value:.1f} standard deviations above the spectrum between them (limit {e.threshold:.1f})"
        )
    if e.kind == "period":
        mesh, _ = parts.gears_of(e.shaft)[e.gear]
        top = _rate(MESH_HARMONICS * parts.mesh_order(mesh), frequency)
        return (
            f"one event per turn ({_rate(e.order, frequency)}) with lines up to {top}, {e.value:.1f} "
            f"standard deviations above the noise next to them (limit {e.threshold:.1f})"
        )
    twice = " (2 BSF)" * (e.kind == "bearing" and e.shaft == "rolling element")
    line = f"a line at {_rate(e.order, frequency)}{twice}, {e.value:.0f} dB above its surroundings"
    limit = f"(limit {e.threshold:.0f} dB)"
    if e.kind == "sidebands":
        return f"{line} {limit}, sideband {_signed(e.sideband)} of the mesh of {e.gear}"
    if e.kind == "bearing":
        by, *others = e.detectors or ("",)
        also = f", also by {', '.join(others)}" if others else ""
        return f"{line} {limit}, in the envelope spectrum{f' by {by}' if by else ''}{also}"
    return f"{line} {limit}"


def _same_lines(evidence: Sequence[Evidence]) -> list[Evidence]:
    """Merge sidebands of several meshes that coincide in one line, as with integer ratios."""
    found: dict[tuple[str, float, int], Evidence] = {}
    for number, e in enumerate(evidence):
        key = (e.kind, e.order, e.sideband) if e.kind == "sidebands" else (e.kind, 0.0, number)
        other = found.get(key)
        found[key] = replace(other, gear=f"{other.gear} and of that of {e.gear}") if other else e
    return list(found.values())


def _cannot_tell(finding: Finding) -> str:
    """Alternatives that the record does not distinguish: bearings, and other gears of the shaft."""
    others = ""
    if finding.bearings:
        others = (
            f"; or a local fault of a bearing: {' or '.join(finding.bearings)}, which has a whole number of "
            "impacts per turn: this record cannot distinguish them"
        )
    if len(finding.gears) < 2:
        return others
    return f"{others}; gears on one shaft rotate together, and a fault of one excites the meshes of all"


def _or_bearings(finding: Finding) -> str:
    """Other parts of bearings with the same lines; a ball may be the cause of the lines of its cage."""
    if not finding.bearings:
        return ""
    return f" (or {' or '.join(finding.bearings)}: this record cannot distinguish them)"


def _gears(gears: tuple[str, ...]) -> str:
    return f"gear {' or '.join(gears)}" if gears else ""


def _named(shaft: str) -> str:
    return shaft if shaft.startswith("shaft") else f"shaft {shaft}"


def named_mesh(name: str) -> str:
    """Name of a mesh that states that it is one.

    Examples
    --------
    >>> named_mesh("mesh 1"), named_mesh("second")
    ('mesh 1', 'mesh second')
    """
    return name if "mesh" in name.lower() else f"mesh {name}"


def _bearing(name: str) -> str:
    return name if "bearing" in name.lower() else f"bearing {name}"


def _signed(number: int) -> str:
    """Number of a sideband with a typographic sign.

    Examples
    --------
    >>> _signed(2), _signed(-3)
    ('+2', '−3')
    """
    return f"{number:+d}".replace("-", "−")


def _rate(order: float, frequency: float) -> str:
    return f"order {order:.5g}" if math.isnan(frequency) else f"{order * frequency:.5g} Hz"
