# SPDX-License-Identifier: Apache-2.0
"""Locate a local fault on a gear: mean turn, indicators, and the tooth that stands out, if any."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from pitchpoint.analysis.diagnosis import Diagnosis
from pitchpoint.analysis.findings import Finding
from pitchpoint.analysis.gear_indicators import gear_indicators
from pitchpoint.analysis.mean_turns import MeanTurn, mean_turn
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.shaft_periods import level_of
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.report.diagnosis.over_angle import OverAngle
from pitchpoint.report.diagnosis.words import percent
from pitchpoint.viz.quantities import number

INDICATORS = {"kurtosis": "kurtosis", "fm4": "FM4", "m6a": "M6A", "m8a": "M8A"}
"""Labels of the indicators of a mean turn."""
GAUSSIAN = {"kurtosis": 3.0, "fm4": 3.0, "m6a": 15.0, "m8a": 105.0}
"""Values of the indicators for Gaussian noise [-]."""

SOUND = 5.6
"""Kurtosis of the residual that sound gears of a measured gearbox reach at low load [-] (docs/diagnosis.md,
measured records)."""


SHORT = "the event is too short to identify the gear"
"""Why several gears of a shaft are named."""


@dataclass(frozen=True)
class GearTurn:
    """Mean turn of a shaft, evaluated for the gears of one tooth count.

    Attributes
    ----------
    channel, shaft, gears
        Channel, shaft, and the gears of this tooth count.
    teeth
        Tooth count [-].
    turn
        Mean turn with indicators and tooth energy.
    zero, since
        Angle of the shaft at the first sample [rad], and the zero of this angle in words.
    fm0
        FM0 [-]; NaN if the mean turn contains no mesh harmonic.
    level
        Gear in whose wavelet level the turn is averaged; empty for the whole signal.
    """

    channel: str
    shaft: str
    gears: tuple[str, ...]
    teeth: int
    turn: MeanTurn
    zero: float
    since: str
    fm0: float
    level: str = ""

    @property
    def angle(self) -> float:
        """Middle of the tooth angle with the most energy [rad], from `since`."""
        return (self.turn.energy.angle + self.zero) % math.tau

    @property
    def tooth(self) -> float:
        """`angle` in pitches of the gear [-]."""
        return self.angle / math.tau * self.teeth

    def stands_out(self, false_alarm: float) -> bool:
        """Whether the energy within the angle of one tooth is significant."""
        return self.turn.energy.probability < false_alarm

    def as_data(self, false_alarm: float, one_gear: bool) -> dict[str, Any]:
        """Plain data; the tooth only if one stands out and the gear is known."""
        energy = self.turn.energy
        out = self.stands_out(false_alarm)
        return {
            "averages": self.turn.averages,
            "angle": self.angle if out else None,
            "tooth": self.tooth if out and one_gear else None,
            "teeth": self.teeth if one_gear else None,
            "counted_from": self.since,
            "tooth_energy": {
                "share": energy.share,
                "evenly_spread": 1.0 / self.teeth,
                "by_noise": energy.probability,
            },
            "indicators": {"fm0": {"value": self.fm0}}
            | {
                name: {
                    "value": value,
                    "gaussian": GAUSSIAN[name],
                    "limit_1_percent": limit,
                    "by_noise": part,
                }
                for name, (value, limit, part) in self.turn.indicators.items()
            },
        }


def gear_turns(
    channel: str, shaft: str, over: OverAngle, parts: TurningParts, level: str = ""
) -> tuple[GearTurn, ...]:
    """Mean turns of a shaft in one channel, one per tooth count on it, if the record is long enough.

    Of the signal, or of the wavelet level of a gear.
    """
    by_count: dict[int, list[str]] = {}
    for gear, (_, teeth) in parts.gears_of(shaft).items():
        by_count.setdefault(teeth, []).append(gear)
    zero, since = over.zeros.get(shaft, (0.0, over.began))
    found = []
    x, rate = level_of(over.signals[channel], over.samples_per_turn, parts, shaft, level)
    for teeth, gears in by_count.items():
        try:
            turn = mean_turn(x, rate, parts, parts.shaft(shaft), teeth)
        except SignalError:
            continue
        try:
            fm0 = gear_indicators(turn.average, teeth=teeth).fm0
        except SignalError:
            fm0 = math.nan
        found.append(GearTurn(channel, shaft, tuple(gears), teeth, turn, zero, since, fm0, level))
    return tuple(found)


def local_turns(
    diagnosis: Diagnosis, over: OverAngle, parts: TurningParts
) -> tuple[tuple[GearTurn, ...], ...]:
    """For each local fault the mean turns of the suspected gears; empty for other findings."""
    return tuple(
        tuple(
            row
            for row in gear_turns(finding.channel, finding.shaft, over, parts, _level(finding, parts))
            if not finding.gears or set(row.gears) & set(finding.gears)
        )
        if finding.kind == "local fault"
        else ()
        for finding in diagnosis.findings
    )


def _level(finding: Finding, parts: TurningParts) -> str:
    """Gear in whose level the mean turns are taken: of several suspected ones the finest."""
    gears = parts.gears_of(finding.shaft)
    suspected = [gear for gear in gears if gear in finding.gears] or list(gears)
    return max(suspected, key=lambda gear: gears[gear][1]) if finding.level else ""


def one_gear(finding: Finding, turns: tuple[GearTurn, ...]) -> bool:
    """Whether all suspected gears have one tooth count, so that teeth can be numbered."""
    named = set(finding.gears)
    return bool(named) and not finding.bearings and len(turns) == 1 and named <= set(turns[0].gears)


def place_sentence(finding: Finding, turns: tuple[GearTurn, ...], false_alarm: float) -> str:
    """Sentence about the mean turn of a local fault; empty without mean turns."""
    if not turns:
        return ""
    best = min(turns, key=lambda row: row.turn.energy.probability)
    found = best.turn.indicators
    (fm4, limit, _), (m6a, other, _) = found["fm4"], found["m6a"]
    shape = (
        f"FM4 {number(fm4, 3)} (1 % of noise of the same spectrum exceeds {number(limit, 3)}), "
        f"M6A {number(m6a, 3)} ({number(other, 3)})"
    )
    where = f" in the wavelet level of {best.level}" if best.level else ""
    text = f"mean of {best.turn.averages} turns of {finding.shaft}{where}: {shape}"
    degrees = f"{math.degrees(best.angle):.0f}°"
    # a finding without a gear has no tooth
    shares = " and ".join(
        f"{100.0 * row.turn.energy.share:.0f} % within the angle of "
        f"{f'one tooth of {_either(row.gears)}' if finding.gears else f'a turn over {row.teeth}'} "
        f"({100.0 / row.teeth:.2g} % if spread evenly; by noise: {percent(row.turn.energy.probability)})"
        for row in turns
    )
    share = f"of the energy of its residual {shares}"
    kurtosis = found["kurtosis"][0]
    sound = (
        f"; sound gears of a measured gearbox have a kurtosis of up to {SOUND} at low load, this one "
        f"{number(kurtosis, 3)}: compare it with a healthy record (--reference)"
    )
    text, end = f"{text}; {share}", sound if kurtosis <= SOUND and not best.level else ""
    if not best.stands_out(false_alarm):
        return f"{text}: no single tooth can be identified{end}"
    if not one_gear(finding, turns):
        either = f"; {SHORT}" if finding.gears and len(turns) > 1 else ""
        return f"{text}, {degrees} after {best.since}{either}{end}"
    return (
        f"{text}: the tooth of {best.teeth} that meshes {best.tooth:.1f} pitches ({degrees}) after "
        f"{best.since}{end}"
    )


def _either(gears: tuple[str, ...]) -> str:
    return " or ".join(gears)


def crest(turn: MeanTurn) -> float:
    """Crest factor of the residual [-]."""
    rms = float((turn.residual**2).mean() ** 0.5)
    return float(abs(turn.residual).max()) / rms if rms > 0.0 else math.nan
