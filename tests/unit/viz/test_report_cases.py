# SPDX-License-Identifier: Apache-2.0
"""Cases of a report over one or two varied numbers, against the closed form of a free vibration in a gap."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from pitchpoint.core.status import OK
from pitchpoint.viz.report.build import CaseTable
from pitchpoint.viz.report.case_results import case_quantities
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
    assert "time without contact [%]" in html


def row(value: float, unit: str = "N", low: float = 0.0) -> dict[str, Any]:
    return {"unit": unit, "mean": value, "rms": 1e-16, "min": low, "max": value}


def planets(error: float, share: float) -> dict[str, Any]:
    """A slow roll of three planets: the loads of planets 2 and 3 rise as that of planet 1 falls."""
    loads = {"planet_1": 3e3 * (3.0 - 2.0 * share), "planet_2": 3e3 * share, "planet_3": 3e3 * share}
    channels = {f"mesh_force[sun-{name}]": row(load) for name, load in loads.items()}
    channels |= {f"mesh_force[{name}-ring]": row(1e-9, low=-load) for name, load in loads.items()}
    channels |= {f"transmission_error[sun-{name}]": row(4e-5, "m", 4e-5) for name in loads}
    channels |= {f"unloaded_transmission_error[sun-{name}]": row(4e-5, "m", 4e-5) for name in loads}
    channels |= {f"bearing_force[{n}-bearing.radial]": row(1.9 * load) for n, load in loads.items()}
    channels |= {f"bearing_force[{n}-bearing.axial]": row(1e-12) for n in loads}
    channels["load_sharing_factor[set]"] = row(share)
    path = "parameters.error"
    return {
        "values": {path: f"{error:g} %"},
        "numbers": {path: 0.01 * error},
        "status": OK,
        "sentence": "finished",
        "channels": channels,
    }


def test_load_sharing_of_planets_is_drawn_and_ring_forces_are_sizes() -> None:
    """K_γ over the varied number; forces of the back flank count by their size, round-off is zero; of more
    curves than six the largest one is drawn; per cent as given."""
    cases = [planets(*pair) for pair in ((0.0, 1.0), (10.0, 1.2), (30.0, 1.5))]
    section = case_section({"slow": CaseTable(cases=cases, units={"parameters.error": "1"})})
    assert set(section.figures) == {"load_sharing_factor", "mesh_force", "radial_bearing_force"}
    (curve,) = section.figures["load_sharing_factor"].data
    assert list(curve.x) == [0.0, 10.0, 30.0] and list(curve.y) == [1.0, 1.2, 1.5]
    assert section.figures["mesh_force"].layout.xaxis.title.text == "error [%]"
    assert len(section.figures["mesh_force"].data) == 6
    assert np.min([line.y for line in section.figures["mesh_force"].data]) == 0.0
    more = [case | {"channels": case["channels"] | {"mesh_force[other]": row(9e3)}} for case in cases]
    (largest,) = case_section({"slow": CaseTable(cases=more)}).figures["mesh_force"].data
    assert list(largest.y) == [9e3, 9e3, 9e3]
    html = "".join(section.parts).partition("<script")[0]
    assert "<h4>Maximum mesh force [N]</h4>" in html
    assert "axial" not in html and "·10" not in html


def test_sweeps_of_cases_give_the_largest_value_of_their_points() -> None:
    """The peak of a resonance curve over the varied number, on either flank."""
    path, found = "meshes.stage.damping.ratio", []
    for ratio_of_damping in (0.05, 0.1):
        points = [
            {
                "direction": "up",
                "mesh_frequency": f,
                "deflection": {
                    "unit": "m",
                    "mean": 1e-5,
                    "rms": size / ratio_of_damping,
                    "min": 0.0,
                    "max": 2e-5,
                },
                "mesh_force": row(1.0, low=-3e8 * size),
                "contact_loss_share": 1e5 * size,
            }
            for f, size in ((500.0, 1e-7), (1000.0, 4e-7), (1500.0, 2e-7))
        ]
        state = {"status": OK, "sentence": "finished", "channels": {}, "points": points}
        value = {"values": {path: f"{ratio_of_damping:g}"}, "numbers": {path: ratio_of_damping}}
        found.append(value | state)
    figures = case_section({"sweep": CaseTable(cases=found, units={path: "1"})}).figures
    assert list(figures["deflection"].data[0].y) == pytest.approx([8.0, 4.0])
    assert list(figures["mesh_force"].data[0].y) == [120.0, 120.0]
    assert list(figures["contact_loss_share"].data[0].y) == pytest.approx([4.0, 4.0])


def test_contacts_that_are_never_lost_have_no_column_and_no_picture() -> None:
    cases = [case(t, 0.15) for t in TORQUES]
    for one in cases:
        one["channels"]["contact_state[stage]"] |= {"contact_loss_share": 0.0, "contact_frequency": 0.0}
    section = case_section({"release": CaseTable(cases=cases, units=UNITS)})
    assert set(section.figures) == {"deflection"}
    assert "contact" not in "".join(section.parts).partition("<script")[0]


def test_a_failed_case_has_no_numbers() -> None:
    """A failed case has nan statistics: a dash in every table, no zero."""
    rows = []
    for size in (2.0, 3.0, math.nan):
        channel = {"unit": "m", "mean": size, "rms": size, "min": -size, "max": size}
        found = case(5.0, 0.15)
        found["channels"] = {
            f"{name}[stage]": channel
            for name in ("transmission_error", "unloaded_transmission_error", "deflection")
        }
        rows.append(found)
    for rolled in (True, False):
        cases = (
            rows
            if rolled
            else [r | {"channels": {"deflection[stage]": r["channels"]["deflection[stage]"]}} for r in rows]
        )
        (quantity,) = case_quantities(cases)
        assert quantity.values[:2, 0] == pytest.approx([4.0, 6.0] if rolled else [2.0, 3.0])
        assert math.isnan(quantity.values[2, 0])
