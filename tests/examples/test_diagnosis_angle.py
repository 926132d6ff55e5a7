# SPDX-License-Identifier: Apache-2.0
"""Angle domain, indicators, noise, bearings on the page on diagnosis: its lines are tried as they stand."""

from __future__ import annotations

import doctest
import re
from dataclasses import fields
from pathlib import Path

from pitchpoint.analysis import gear_indicators, indicators

TEXT = (Path(__file__).parents[2] / "docs" / "diagnosis.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", TEXT, re.DOTALL | re.MULTILINE))
NAMES = ("Angle domain", "Indicators", "Noise", "diagnose", "Rolling bearings")


def test_lines_give_what_the_page_shows() -> None:
    text = "\n".join(SECTIONS[name] for name in NAMES)
    test = doctest.DocTestParser().get_doctest(text, {}, "docs/diagnosis.md", "docs/diagnosis.md", 0)
    result = doctest.DocTestRunner().run(test)
    assert result.attempted > 15
    assert result.failed == 0


def test_table_names_every_indicator() -> None:
    kinds = (indicators.SignalIndicators, gear_indicators.GearIndicators)
    known = {f.name for kind in kinds for f in fields(kind)} | {"na4", "nb4"}
    rows = re.findall(r"^\| (`.*?) \|", SECTIONS["Indicators"], re.MULTILINE)
    assert {name for row in rows for name in re.findall(r"`(\w+)`", row)} - {"good_records"} == known
