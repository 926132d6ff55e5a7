# SPDX-License-Identifier: Apache-2.0
"""Section with studies: spread of the results, factors, and pictures of every result."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import TYPE_CHECKING

from pitchpoint.viz.report.page import Section
from pitchpoint.viz.study_page import study_sections

if TYPE_CHECKING:
    from pitchpoint.analysis.study.summary import StudySummary


def study_section(studies: Mapping[str, StudySummary]) -> Section:
    """Section with studies, one after the other."""
    section = Section("studies", "Tolerance study" if len(studies) == 1 else "Tolerance studies")
    for name, summary in studies.items():
        section.add(f"<h3>{escape(name)}</h3>" if len(studies) > 1 else "")
        for part in study_sections(summary):
            section.add(f"<h3>{escape(part.heading)}</h3>")
            for html in part.parts:
                section.add(html)
            section.figures.update(part.figures)
    return section
