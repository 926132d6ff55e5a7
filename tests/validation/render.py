# SPDX-License-Identifier: Apache-2.0
"""One page with every published case: quantity, published value, ours, error, tolerance.

Runs the tests of this folder and reads the numbers from their passing assertions, so the page cannot say
anything that is not tested. Usage: ``python tests/validation/render.py --output validation.md``. The results
are kept case by case in ``build/validation.jsonl``: with ``--resume`` a run that was stopped goes on where it
ended.
"""

from __future__ import annotations

import argparse
import ast
import json
import platform
import re
import sys
import tempfile
from dataclasses import dataclass, field
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

HERE = Path(__file__).parent
MAX_ROWS = 12
KEPT = HERE.parents[1] / "build" / "validation.jsonl"
_NUMBER = r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?"
# pytest shortens numbers in the first line of an explanation; those of the comparison below it are whole
_COMPARED = re.compile(rf"^\s*Obtained: ({_NUMBER})\s+Expected: ({_NUMBER}) ± ({_NUMBER})\s*$", re.MULTILINE)


@dataclass
class Collector:
    """Gathers outcomes and compared numbers while pytest runs."""

    kept: Path
    outcomes: dict[str, str] = field(default_factory=dict)
    rows: dict[str, list[tuple[str, float, float, float]]] = field(default_factory=dict)

    def read(self) -> None:
        """Read the results of an earlier run; its last line is left out if it was cut off."""
        for line in self.kept.read_text(encoding="utf-8").splitlines(keepends=True):
            if line.endswith("\n"):
                name, outcome, rows = json.loads(line)
                self.outcomes[name] = outcome
                self.rows[name] = [tuple(row) for row in rows]

    def pytest_collection_modifyitems(self, items: list[Any]) -> None:
        """Leave out the cases that passed in the earlier run."""
        items[:] = [item for item in items if self.outcomes.get(item.nodeid) != "passed"]

    def pytest_assertion_pass(self, item: Any, orig: str, expl: str) -> None:
        """Keep the numbers of an assertion of the form ours == approx(published)."""
        match = _COMPARED.search(expl)
        if match:
            ours, published, tolerance = (float(x) for x in match.groups())
            quantity = orig.split("==")[0].strip()
            if not abs(ours - published) <= tolerance * (1.0 + 1e-9):
                raise ValueError(f"misread {quantity} of {item.nodeid}: {expl}")
            self.rows.setdefault(item.nodeid, []).append((quantity, published, ours, tolerance))

    def pytest_runtest_logreport(self, report: Any) -> None:
        """Keep the outcome of a test."""
        if report.when == "call" or report.outcome != "passed":
            self.outcomes[report.nodeid] = report.outcome
            with self.kept.open("a", encoding="utf-8") as file:
                row = [report.nodeid, report.outcome, self.rows.get(report.nodeid, [])]
                file.write(json.dumps(row) + "\n")


def run(folder: Path, kept: Path, *, resume: bool = False) -> Collector:
    """Run the tests of a folder, collect what they compare and keep it in a file."""
    collector = Collector(kept)
    kept.parent.mkdir(parents=True, exist_ok=True)
    if resume and kept.exists():
        collector.read()
    else:
        kept.write_text("", encoding="utf-8")
    # assertions are rewritten anew, with the hook, beside the usual cache
    sys.pycache_prefix = tempfile.mkdtemp()
    options = ["-q", "-p", "no:cacheprovider", "-o", "enable_assertion_pass_hook=true", "-n", "0"]
    pytest.main([*options, str(folder)], plugins=[collector])
    return collector


def page(collector: Collector) -> str:
    """Write the results as Markdown, one section per file."""
    files = sorted({name.split("::")[0] for name in collector.outcomes})
    failed = [n for n, o in collector.outcomes.items() if o == "failed"]
    lines = [
        "# Validation",
        "",
        f"{len(collector.outcomes)} cases, {len(failed)} failed.",
        "",
        *_origin(),
        "",
    ]
    for file in files:
        lines += _section(file, collector)
    return "\n".join(lines).rstrip() + "\n"


def _origin() -> list[str]:
    """When and with what the page was made, and how to read it."""
    python = f"Python {platform.python_version()}"
    packages = [f"{name} {version(name)}" for name in ("pitchpoint", "numpy", "scipy", "numba")]
    return [
        f"Made by `make validate` on {datetime.now(UTC):%Y-%m-%d} with",
        f"{', '.join([*packages, python])}.",
        "",
        "The numbers come from the passing assertions of `tests/validation`, so the page says nothing",
        f"that is not tested. A case shows its first {MAX_ROWS} numbers. One with the word *passed* alone",
        "checks something else than a pair of numbers. The quantity is the expression as it stands in",
        "the test.",
    ]


def _section(file: str, collector: Collector) -> list[str]:
    doc = ast.get_docstring(ast.parse(Path(HERE.parents[1], file).read_text(encoding="utf-8"))) or ""
    title, _, rest = doc.partition("\n")
    lines = [f"## {title.rstrip('.')}", "", *rest.strip().splitlines(), ""]
    lines += ["| case | quantity | published | ours | error | tolerance |", "|---|---|---|---|---|---|"]
    for name, outcome in collector.outcomes.items():
        if not name.startswith(f"{file}::"):
            continue
        case = name.partition("::")[2].removeprefix("test_").replace("_", " ").replace("|", "/")
        rows = collector.rows.get(name, [])
        for quantity, published, ours, tolerance in rows[:MAX_ROWS]:
            cell = quantity.replace("|", "\\|")
            error = f"{ours - published:.2g}"
            lines.append(f"| {case} | `{cell}` | {published:.8g} | {ours:.8g} | {error} | {tolerance:.2g} |")
        if not rows or outcome == "failed":
            lines.append(f"| {case} | {outcome} | | | | |")
    return [*lines, ""]


def main() -> int:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--resume", action="store_true", help="continue a run that was stopped")
    arguments = parser.parse_args()
    target = arguments.output
    collector = run(HERE, KEPT, resume=arguments.resume)
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(page(collector), encoding="utf-8")
    print(f"{target} written")
    return 1 if "failed" in collector.outcomes.values() or not collector.outcomes else 0


if __name__ == "__main__":
    sys.exit(main())
