# SPDX-License-Identifier: Apache-2.0
"""Tables and power flows of a report without what says nothing: empty columns, equal pictures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pitchpoint.viz.power_flow import OUTSIDE, PowerBlock, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_drawing import LETTERS, name_lines, power_flow_svg
from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.report.build import ModeData, ReportResults, SourceData, TimeRun
from pitchpoint.viz.report.contact_times import contact_table
from pitchpoint.viz.report.overview import provenance_section
from pitchpoint.viz.report.power import power_section
from pitchpoint.viz.report.summary import summary_section
from pitchpoint.viz.report.tables import mode_section, parameter_section

TIME = np.linspace(0.0, 1.0, 201)


def flow(power: float, lost: float = 1.0, name: str = "mesh") -> PowerFlow:
    links = [
        PowerLink(name="motor", kind="load", start=OUTSIDE, end=0, given=power, taken=power),
        PowerLink(
            name=name, kind="mesh", start=0, end=1, given=power, taken=power - lost, losses={"friction": lost}
        ),
        PowerLink(name="brake", kind="load", start=1, end=OUTSIDE, given=power - lost, taken=power - lost),
    ]
    return PowerFlow(span=(0.0, 1.0), blocks=[PowerBlock(name=n, speed=9.0) for n in "ab"], links=links)


def test_variants_with_the_same_path_of_the_power_share_one_picture() -> None:
    flows = {"10 N m": flow(1000.0), "20 N m": flow(2000.0, 2.5), "20 N m again": flow(2000.0, 2.5)}
    html = "".join(power_section(flows).parts)
    assert html.count("<svg") == 1
    assert "Mean powers of 10 N m from 0 to 1 s" in html
    # one column for equal powers, the same decimals in all
    assert ">20 N m, 20 N m again</th>" in html
    for text in ("1000.0", "999.0", "2000.0", "1997.5"):
        assert f">{text}<" in html, text
    assert html.count("Balance: ") == 2
    other = "".join(power_section({"a": flow(1000.0), "b": flow(1000.0, name="other")}).parts)
    assert other.count("<svg") == 2


@pytest.mark.parametrize("name", ["pinion", "high_speed_shaft", "a_very_long_name_without_an_end_2"])
def test_names_stay_in_their_blocks(name: str) -> None:
    lines = name_lines(name)
    assert len(lines) <= 2 and all(len(line) <= LETTERS for line in lines)
    blocks = [PowerBlock(name=name, speed=1.0), PowerBlock(name="b", speed=1.0)]
    svg = power_flow_svg(PowerFlow(span=(0.0, 1.0), blocks=blocks, links=flow(10.0).links))
    for line in lines:
        assert f">{line}</text>" in svg


def test_columns_of_impacts_appear_only_with_impacts() -> None:
    settled = np.ones(TIME.size, bool)
    quiet = {"m": np.ones(TIME.size)}
    found = {"contact_state[m]": Channel("contact_state[m]", quiet["m"])}
    html = contact_table(TIME, quiet, found, settled)
    assert "impacts" not in html and "No mesh loses contact." in html
    state = np.where(np.arange(TIME.size) % 40 < 5, 0.0, 1.0)
    html = contact_table(
        TIME, {"m": state}, {"contact_state[m]": Channel("contact_state[m]", state)}, settled
    )
    assert ">impacts<" in html and "No mesh" not in html


def test_the_summary_tells_load_sharing_ripple_and_unstable_modes() -> None:
    force = Channel("mesh_force[m]", 1000.0 + 500.0 * np.sin(10.0 * np.pi * TIME), "N")
    modes = ModeData(
        names=["rigid rotation", "first bending of rotor (forward)", "torsion"],
        frequency=[0.0, 88.6, 195.0],
        damping_ratio=[-1.0, -7e-5, 3e-4],
    )
    run = TimeRun(
        data={"time": TIME, "mesh_force[m]": force}, planets={"set": {"load_sharing_factor": 1.283}}
    )
    html = "".join(summary_section((), ReportResults(runs={"r": run}, modes={"steady": modes})).parts)
    assert "mesh load factor K<sub>γ</sub> of the planets, set</th><td>1.283" in html
    assert "1.5 times its mean" in html
    assert "Unstable about the loaded state: first bending of rotor (forward) (88.6 Hz" in html
    assert "rigid rotation" not in html
    fed = replace(modes, undamped=True, sources=["", "torque fan", ""])
    html = "".join(summary_section((), ReportResults(modes={"steady": fed})).parts)
    assert "Unstable" not in html
    assert "The model has no damping, so that modes grow about the loaded state: first bending" in html
    assert "−0.007 %, driven by torque fan). Damping ratios above 0.007 % make them stable." in html
    rounded = replace(modes, names=["a", "b", "c"], damping_ratio=[-2.21e-17, 3e-13, 0.02], scenarios=["up"])
    html = "".join(mode_section({"up": replace(rounded, held=["a"], others=["idle"])}).parts)
    assert [cell in html for cell in (">0 %<", ">2 %<", "⁻¹")] == [True, True, False]
    assert "loaded state of scenario up with mean mesh stiffness; prescribed motion: a." in html
    assert "The prescribed motions of scenario idle differ" in html


def test_results_are_columns_of_one_table_of_provenance() -> None:
    sources = [SourceData(name=n, rows=[("file", f"{n}.h5"), (n, "1")]) for n in ("slow", "fast")]
    html = "".join(provenance_section(sources).parts)
    assert html.count("<table") == 1 and "<td>slow.h5</td><td>fast.h5</td>" in html


def test_parameters_have_printed_units_and_no_empty_columns() -> None:
    html = "".join(parameter_section([("beta", "12 deg", "12 deg", ""), ("m", "2 mm", "2 mm", "")]).parts)
    assert ">12°<" in html and "as written" not in html and "description" not in html
    html = "".join(parameter_section([("a", "2*b", "4 mm", "gap")]).parts)
    assert "as written" in html and "description" in html
