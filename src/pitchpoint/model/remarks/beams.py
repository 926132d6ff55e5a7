# SPDX-License-Identifier: Apache-2.0
"""Remarks on beams: a jump in speed at the start, sections of files that no material has."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.formula.formula import Formula
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.model.components.beam import FILES
from pitchpoint.model.components.law import Constant, FormulaLaw, Law, TableLaw
from pitchpoint.model.frames import GROUND, beam_length, carrier_of
from pitchpoint.model.mechanism import Seat, coordinate

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario

SLOWEST_SOUND, FASTEST_SOUND = 500.0, 13_000.0
"""Speeds of sound in bars: below that of lead, above that of carbon fibres and beryllium [m/s]."""
THICK = 0.1
"""Radius of gyration over the length that no slender beam has."""
SHORT = 1e-6
"""Step of the difference quotient of a prescribed angle [s]."""
SLOW = 1e-6
"""Rate below which a drive starts at rest [rad/s, m/s]."""


def ends_left_behind(model: Model) -> tuple[Message, ...]:
    """A remark for every beam with one end at rest on a body with `motion` while the other end moves."""
    found = []
    for name, beam in model.beams.items():
        bodies = [carrier_of(model, end) for end in beam.ends]
        for near, far in (bodies, bodies[::-1]):
            seat = model.mechanism.seats.get(far)
            if seat is None or seat.joint is not None or seat.kind not in ("shaft", "planar"):
                continue
            turning = [word for word, s in model.scenarios.items() if _turns(model, s, near)]
            turning = [word for word in turning if not _turns(model, model.scenarios[word], far)]
            if not turning:
                continue
            found.append(
                remark(
                    f"beams.{name}",
                    f"{far} moves against ground (motion: {model.bodies[far].motion}) and starts at rest "
                    f"while {near} moves in {', '.join(turning)}, so the beam starts with a jump in speed",
                    f"use a joint {{type: free, bodies: [{near}, {far}]}} instead of motion",
                    model.line(("beams", name)),
                )
            )
    return tuple(found)


def implausible_sections(model: Model) -> tuple[Message, ...]:
    """A remark for every file whose mass and stiffness contradict each other, as in other units.

    The square root of the axial stiffness over the mass is the speed of sound in the bar. That of the bending
    stiffness over the mass is this speed times the radius of gyration of the section, which is small compared
    with the length.
    """
    found: dict[str, Message] = {}
    for name, beam in model.beams.items():
        if (
            beam.properties is None
            or (key := next((k for k in FILES if getattr(beam.properties, k)), None)) is None
        ):
            continue
        table, length = beam_table_of(beam.properties), beam_length(model, beam)
        file = str(getattr(beam.properties, key))
        heavy = table.mass > 0.0
        if file in found or not heavy.any() or not length:
            continue
        text = ""
        if table.axial.size and "axial" not in beam.properties.lists:
            sound = np.sqrt(table.axial[heavy] / table.mass[heavy])
            worst = sound.max() if sound.max() > FASTEST_SOUND else sound.min()
            if not SLOWEST_SOUND <= worst <= FASTEST_SOUND:
                limit = f"{SLOWEST_SOUND:g} to {FASTEST_SOUND:g} m/s"
                text = f"axial stiffness and mass give a speed of sound of {worst:.3g} m/s (limit {limit})"
        bending = np.maximum(table.bending_1, table.bending_2)[heavy]
        radius = float(np.sqrt(bending / table.mass[heavy]).max()) / FASTEST_SOUND
        if not text and radius > THICK * length:
            text = (
                f"bending stiffness and mass require a radius of gyration of the section of {radius:.3g} m "
                f"even for the stiffest material (limit {THICK * length:.3g} m, a tenth of the length)"
            )
        if text:
            found[file] = remark(f"beams.{name}.properties.{key}", text, "check units: N, N m^2 and kg/m")
    return tuple(found.values())


def _turns(model: Model, scenario: Scenario, body: str) -> bool:
    """Whether a body or one of its parents moves at the start of a scenario."""
    speeds = model.start_speeds(scenario)
    seats = model.mechanism.seats
    while body != GROUND and body in seats:
        seat = seats[body]
        given = model.joints[seat.joint].speed if seat.joint is not None else {}
        if any(given.values()) or speeds.get(body, 0.0) != 0.0 or _driven(model, scenario, seat):
            return True
        body = seat.parent
    return False


def _driven(model: Model, scenario: Scenario, seat: Seat) -> bool:
    for word, drive in scenario.drive.items():
        found = coordinate(model.mechanism, model, word)
        if not isinstance(found, str) and found[0] == seat.body and abs(_rate(drive)) > SLOW:
            return True
    return False


def _rate(drive: Drive) -> float:
    """Initial rate of a drive [rad/s, m/s]; 0 for Python functions, which are not called here."""
    if drive.rate is not None:
        return _value(drive.rate, 0.0)
    if drive.value is None:
        return 0.0
    return (_value(drive.value, SHORT) - _value(drive.value, -SHORT)) / (2.0 * SHORT)


def _value(law: Law, t: float) -> float:
    if isinstance(law, Constant):
        return law.value
    if isinstance(law, FormulaLaw):
        return float(Formula.parse(law.text, ("t",))(t))
    if isinstance(law, TableLaw):
        return float(np.interp(t, law.abscissa, law.values))
    return 0.0
