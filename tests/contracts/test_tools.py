# SPDX-License-Identifier: Apache-2.0
"""Every public function of `analysis` that gives a dataclass is a tool of `analyse`, or has a reason."""

from __future__ import annotations

import dataclasses
import importlib
import inspect
import pkgutil
import re
from pathlib import Path

import pytest

import pitchpoint.analysis
from pitchpoint.analysis.dataset import tool_options
from pitchpoint.analysis.tools import TOOLS
from pitchpoint.viz.analysis_pictures import PICTURES

NO_TOOL = {
    "bearing_frequencies.bearing_frequencies": "from dimensions, not from a signal",
    "cepstrum.rahmonics": "takes the result of another tool",
    "combs.comb_lines": "a step of find_period, whose result holds it",
    "combs.record_for_combs": "a step of find_period",
    "detection.detection_curves": "takes two signals and functions",
    "diagnosis.diagnose": "takes several channels and what turns; the command diagnose",
    "fault_frequencies.gear_pair_frequencies": "from tooth counts, not from a signal",
    "fault_frequencies.train_frequencies": "from tooth counts, not from a signal",
    "family_lines.coherence_lines": "a step of diagnose",
    "family_lines.envelope_lines": "a step of diagnose",
    "fault_families.families_in": "a step of diagnose",
    "fault_families.fault_families": "takes fault orders by part",
    "speed_path.speed_path": "a step of speed_track",
    "speed_without_gears.finer_path": "a step of speed_track",
    "speed_without_gears.motor_path": "a step of speed_track",
    "speed_track.speed_track": "takes several channels and what turns; the command diagnose",
    "gear_indicators.na4": "takes several averages",
    "gear_indicators.nb4": "takes several averages",
    "gear_indicators.running_kurtosis": "takes several records",
    "healthy_reference.deviations": "takes features of several records; the command diagnose --reference",
    "line_tests.fine_spectrum": "a step of diagnose",
    "load_sharing.share_along_path": "of a mesh cycle, not of a record",
    "mean_turns.mean_turn": "a step of diagnose",
    "planet_frequencies.planetary_frequencies": "from tooth counts, not from a signal",
    "rainflow.load_duration": "takes weights; the command fatigue",
    "rainflow.rainflow": "cycles, not samples; the command fatigue",
    "rattle.rattle": "takes three channels of a mesh; stands in results and tables",
    "shaft_periods.shaft_period": "a step of diagnose",
    "shaft_periods.tooth_level": "a step of diagnose",
    "speed_search.speed_from_lines": "a step of diagnose",
    "statistics.contact_statistics": "takes two channels of a mesh; stands in results and reports",
    "tacho.angle_channel": "makes the angle of every tool that takes one",
    "tacho.tacho_angle": "makes the channel of --tacho, shaft_channel.with_shaft_angle",
    "tooth_energy.tooth_energy": "a step of diagnose",
    "tooth_pulses.find_passages": "takes the angle of a mesh; the command fatigue",
    "tooth_pulses.find_pulses": "takes the tooth pairs of a mesh; the command fatigue",
    "turning_parts.train_parts": "from tooth counts, not from a signal",
}
"""Public functions that give a dataclass and are no tool, and why."""
PAGE = (Path(__file__).parents[2] / "docs" / "diagnosis.md").read_text(encoding="utf-8")


def dataclass_functions() -> set[str]:
    """Module and name of every public function of the package that gives a dataclass."""
    found = set()
    for info in pkgutil.iter_modules(pitchpoint.analysis.__path__):
        module = importlib.import_module(f"pitchpoint.analysis.{info.name}")
        for name, function in vars(module).items():
            own = inspect.isfunction(function) and function.__module__ == module.__name__
            if not own or name.startswith("_"):
                continue
            result = inspect.get_annotations(function).get("return")
            if dataclasses.is_dataclass(vars(module).get(str(result))):
                found.add(f"{info.name}.{name}")
    return found


def needed(tool: str) -> str:
    """What the table of the page says that a tool needs."""
    row, words = TOOLS[tool], []
    if "samples_per_revolution" in row.takes:
        words.append("signal over an angle")
    if {"angle", "average"} & set(row.takes):
        words.append("`--angle`")
    words += [f"`{name}`" for name, p in tool_options(tool).items() if p.default is p.empty]
    return ", ".join(words)


def test_functions_are_tools_or_have_a_reason():
    homes = {row.home for row in TOOLS.values()}
    assert len(homes) == len(TOOLS)
    assert not homes & set(NO_TOOL)
    assert dataclass_functions() == homes | set(NO_TOOL)


@pytest.mark.parametrize("tool", sorted(TOOLS))
def test_tools_have_a_line_and_a_picture(tool):
    row = TOOLS[tool]
    assert row.summary.endswith(".") and "\n" not in row.summary
    assert row.picture == "lines" or row.picture in PICTURES


def test_every_picture_is_that_of_a_tool():
    assert {row.picture for row in TOOLS.values()} - {"lines"} == set(PICTURES)


def test_the_page_on_diagnosis_lists_all_tools():
    listed = re.findall(r"^\| `(\w+)` \| (.*?) \| (.*?) ?\|$", PAGE, re.MULTILINE)
    expected = [(name, row.summary, needed(name)) for name, row in TOOLS.items()]
    assert [row for row in listed if row[0] in TOOLS] == expected
