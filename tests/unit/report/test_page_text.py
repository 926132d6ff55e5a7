# SPDX-License-Identifier: Apache-2.0
"""Text of reports as an engineer reads it: symbols with subscripts, printed units, no keys of files.

Names given by the user stay as they are.
"""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

import pitchpoint as pp

EXAMPLES = Path(__file__).parents[3] / "examples"
RUNS = {
    "geared-rotor/model.yaml": ("fast", {"scenarios.fast.duration": 0.02}),
    "shovel-gearbox/model.yaml": ("", {}),
    "planetary-set/model.yaml": ("", {}),
    "bevel-drive/spiral.yaml": ("", {}),
}
RAW = {
    "symbol": re.compile(r"\b[A-Za-z]{1,5}_[A-Za-z0-9]+(_[A-Za-z0-9]+)*\b"),
    "index without subscript": re.compile(r"(?<![\w.\-])[abcdjruvwxz][12](?=\s*[=<>≥≤])"),
    "power": re.compile(r"\w\^-?\d"),
    "angular speed": re.compile(r"\brad/s\b"),
    "unit of files": re.compile(r"\d ?(deg|um|us|uN)\b"),
    "comparison": re.compile(r"[<>]="),
    "more than six digits": re.compile(r"(?<![\w.])(?:[1-9]\d*\.\d{6,}|0\.0*[1-9]\d{6,})"),
}
RAW_ALLOWED = ("N m s/rad", "N m/rad")


class Text(HTMLParser):
    """Visible text, with subscripts marked so that they are not read as part of a word."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.hidden, self.parts = 0, [""]
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.hidden += tag in ("script", "style")
        self.parts.append("" if tag in ("sub", "b", "i") else "\n")

    def handle_endtag(self, tag: str) -> None:
        self.hidden -= tag in ("script", "style")

    def handle_data(self, data: str) -> None:
        if not self.hidden:
            self.parts.append(data)


def names_of(model: object) -> set[str]:
    """All names that the file gives to its components, longest first in use."""
    found = set()
    for field in vars(model).values():
        if hasattr(field, "keys"):
            found |= {str(name) for name in field}
    for body in getattr(model, "bodies", {}).values():
        found |= set(getattr(body, "markers", {}))
    return found


# the slow rolls of the six stages of the shovel take half a minute
@pytest.mark.parametrize(
    "example", [pytest.param(e, marks=[pytest.mark.study] if "shovel" in e else []) for e in RUNS]
)
def test_no_raw_identifiers(example: str, tmp_path: Path) -> None:
    file = EXAMPLES / example
    scenario, changes = RUNS[example]
    model = pp.load_model(file, allow_code=True)
    results = []
    if scenario:
        model = model.replace_all(changes)
        results.append(pp.solve_time(pp.compile_model(model, scenario)))
    page = pp.write_report(model, tmp_path / "page.html", *results).read_text(encoding="utf-8")
    text = "".join(Text(page).parts)
    for name in sorted(names_of(model), key=len, reverse=True):
        text = re.sub(rf"(?<![A-Za-z0-9_]){re.escape(name)}(?![A-Za-z0-9_])", "NAME", text)
    for words in RAW_ALLOWED:
        text = text.replace(words, "")
    found = {kind: sorted({m.group() for m in raw.finditer(text)}) for kind, raw in RAW.items()}
    assert not {kind: texts for kind, texts in found.items() if texts}
