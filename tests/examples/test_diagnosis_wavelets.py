# SPDX-License-Identifier: Apache-2.0
"""Wavelets, periods and detection on the page on diagnosis: their lines are tried as they stand."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

import numpy as np

from pitchpoint.analysis.noise import with_white_noise

TEXT = (Path(__file__).parents[2] / "docs" / "diagnosis.md").read_text(encoding="utf-8")
SECTIONS = dict(re.findall(r"^## (.+?)\n(.*?)(?=^## |\Z)", TEXT, re.DOTALL | re.MULTILINE))


def test_lines_give_what_the_page_shows() -> None:
    text = "\n".join(SECTIONS[name] for name in ("Wavelets", "Periods", "Detection against noise"))
    names = {"np": np, "with_white_noise": with_white_noise}
    test = doctest.DocTestParser().get_doctest(text, names, "docs/diagnosis.md", "docs/diagnosis.md", 0)
    result = doctest.DocTestRunner().run(test)
    assert result.attempted > 20
    assert result.failed == 0
