# SPDX-License-Identifier: Apache-2.0
"""Cases of a report over one or two varied numbers, against the closed form of a free vibration in a gap."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.viz.report.build import CaseTable
from pitchpoint.viz.report.cases import case_section

NATURAL = 7.35
TORQUES, GAPS = (5.0, 20.0, 200.0, 1500.0), (0.15, 0.43)
UNITS = {"parameters.torque": "N m", "parameters.backlash": "m"}


def ratio(torque: float, gap: float) -> float:
    """Gap over static deflection, for 25.6 N m per millimetre."""
    return 25.6 * gap / torque


def case(torque: float, gap: float) -> dict[str, Any]:
    r = ratio(torque, gap)
    numbers = {
        "contact_loss_share": r / (math.pi + r),
        "contact_frequency": NATURAL * math.pi / (math.pi + r),
    }
    return {
        "values": {"parameters.torque": f"{torque:g} N m", "parameters.backlash": f"{gap:g} mm"},
        "numbers": {"parameters.torque": torque, "parameters.backlash": 1e-3 * gap},
        "status": OK,
        "sentence": "finished",
        "channels": {
            "deflection[stage]": {"unit": "m", "mean": 0.0, "rms": 1e-5 * torque, "min": 0.0, "max": 0.0},
            "contact_state[stage]": {"unit": "1", "mean": 0.0, **numbers},
        },
    }


def test_two_varied_numbers_are_curves_over_the_one_with_most_values() -> None:
    """Frequency over torque, a curve per backlash: it tends to the natural frequency."""
    table = CaseTable(cases=[case(t, g) for g in GAPS for t in TORQUES], units=UNITS)
    section = case_section({"release": table})
    assert set(section.figures) == {"deflection", "contact_loss_share", "contact_frequency"}
    figure = section.figures["contact_frequency"]
    assert [line.name for line in figure.data] == ["backlash 0.15 mm", "backlash 0.43 mm"]
    for line, gap in zip(figure.data, GAPS, strict=True):
        assert list(line.x) == list(TORQUES)
        expected = [NATURAL * math.pi / (math.pi + ratio(t, gap)) for t in TORQUES]
        assert line.y == pytest.approx(expected)
        assert np.all(np.diff(line.y) > 0.0)
    assert figure.layout.xaxis.title.text == "torque [N m]"
    assert figure.layout.yaxis.title.text == "frequency of the contacts [Hz]"
    assert figure.layout.xaxis.type == "log"
    html = "".join(section.parts)
    assert '<th scope="col">torque</th>' in html and "parameters." not in html.partition("<script")[0]
    assert "time without contact, stage [%]" in html


def test_contacts_that_are_never_lost_have_no_column_and_no_picture() -> None:
    cases = [case(t, 0.15) for t in TORQUES]
    for one in cases:
        one["channels"]["contact_state[stage]"] |= {"contact_loss_share": 0.0, "contact_frequency": 0.0}
    section = case_section({"release": CaseTable(cases=cases, units=UNITS)})
    assert set(section.figures) == {"deflection"}
    assert "contact" not in "".join(section.parts).partition("<script")[0]
