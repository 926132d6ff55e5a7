# SPDX-License-Identifier: Apache-2.0
"""Remarks on beams: a jump in speed at the start, and mass matrices of sections that are not flat."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import Message, remark
from pitchpoint.core.formula.formula import Formula
from pitchpoint.geometry.section_matrix import polar_error
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.model.components.law import Constant, FormulaLaw, Law, TableLaw
from pitchpoint.model.frames import GROUND, carrier_of
from pitchpoint.model.mechanism import Seat, coordinate

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.scenario import Drive, Scenario

NOT_FLAT = 0.01
"""Error of the polar moment of inertia of a section that is attributed to rounding."""
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


def sections_not_flat(model: Model) -> tuple[Message, ...]:
    """A remark for every beam whose mass matrices have a polar moment of inertia that is not the sum of both
    others."""
    found = []
    for name, beam in model.beams.items():
        if beam.properties is None:
            continue
        table = beam_table_of(beam.properties)
        if isinstance(table, SectionTable) and (error := max(map(polar_error, table.inertia))) > NOT_FLAT:
            found.append(
                remark(
                    f"beams.{name}.properties",
                    f"the entry 66 of the mass matrices differs from the sum of 44 and 55 by up to "
                    f"{100 * error:.3g} %; 44, 45 and 55 give only their difference and its direction",
                    "correct the matrices if their entries are of one section",
                    model.line(("beams", name)),
                )
            )
    return tuple(found)


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
