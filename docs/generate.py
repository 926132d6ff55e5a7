# SPDX-License-Identifier: Apache-2.0
"""Pages of the documentation that are made from the package itself: keys, names, units, commands.

Usage: ``python docs/generate.py build/docs``. The written pages of this folder are copied beside them.
"""

from __future__ import annotations

import importlib
import json
import shutil
import sys
from pathlib import Path
from typing import Any

import click

from pitchpoint.cli.main import COMMANDS, EPILOG, pitchpoint
from pitchpoint.core.nomenclature import markdown_table
from pitchpoint.core.unit_table import DIMENSIONS, PLAIN_UNITS, WORDS, Unit
from pitchpoint.core.units import display_unit
from pitchpoint.model.schema import json_schema, reference_page

HERE = Path(__file__).parent


def nomenclature() -> str:
    """Page of all names."""
    head = "# Nomenclature\n\nFrom `core/nomenclature.csv`. Everything inside is SI and radians.\n\n"
    return head + markdown_table()


HOW_UNITS_COMBINE = """
## How units combine

* A product is a space, `*`, `·`, `.` or a hyphen without spaces: `N m`, `N*m`, `N·m`, `N.m`, `N-m`.
* A power is `^2`, `**2`, `²` or a number right behind the symbol: `kg m^2`, `kg m2`, `min-1`.
* `Nm`, `Nmm`, `Ncm`, `Ns`, `Nms` (m, k, M before N), `kgm`, `kgcm`, `kgmm`, `gcm`, `gmm` are one
  word; a power behind it belongs to the last symbol: `kgm2` is `kg m^2`.
* Several symbols below the line stand in brackets or each behind a line: `14 N/(mm um)`, `14 N/mm/um`.
* Speeds of rotation: `rpm`, `1/min`, `/min`, `min^-1`, `rev/min`, `r/min`, `U/min`, `Hz` count revolutions,
  `rad/s` and `deg/s` angles. `1/s` does not say what it counts and is refused.
* `grad` and `Grad` (degree or gon) are refused: write `deg` or `gon`. `lb`, `oz`, `kg`, `t` are masses, and
  `lbf`, `ozf`, `kgf`, `kN` the forces.

## Symbols

n, u (or µ), m, k, M and G may stand before m, g, s, N, Pa, J, W and Hz; n, u and m before rad. Names that
are not in the table are looked up in [pint](https://pint.readthedocs.io), except for angles and rates.

| symbol | in SI |
|---|---|
"""


def units() -> str:
    """Page of what a model file may say for each kind of quantity."""
    head = "# Units\n\nA bare number is SI; angles are radians.\n\n"
    lines = ["| kind | SI | for instance | shown in |", "|---|---|---|---|"]
    for name, row in DIMENSIONS.items():
        lines.append(f"| {row.words} | {row.si or '1'} | `{row.example}` | {display_unit(name) or '1'} |")
    symbols = [f"| `{name}` | {_in_si(unit)} |" for name, unit in PLAIN_UNITS.items()]
    written_out = "\nUnits may be written out, as in `millimeters` or `Newton`: " + ", ".join(WORDS) + ".\n"
    return head + "\n".join(lines) + "\n" + HOW_UNITS_COMBINE + "\n".join(symbols) + "\n" + written_out


def _in_si(unit: Unit) -> str:
    """Factor and SI base units of one symbol."""
    powers = zip(Unit._fields[1:], unit[1:], strict=True)
    base = [name if power == 1 else f"{name}^{power}" for name, power in powers if power]
    return " ".join([f"{float(unit.factor):.12g}", *base])


def commands() -> str:
    """Page of all commands with their options."""
    lines = ["# Commands", "", EPILOG, ""]
    # every command has its options for help from the program; the width must not be that of some terminal
    settings: dict[str, Any] = pitchpoint.context_settings | {"terminal_width": 100}
    program = click.Context(pitchpoint, info_name="pitchpoint", **settings)
    for name in COMMANDS:
        function = name.replace("-", "_")
        command: click.Command = getattr(importlib.import_module(f"pitchpoint.cli.{function}"), function)
        context = click.Context(command, info_name=name, parent=program)
        lines += [f"## {name}", "", *_help(context)]
        for part, child in sorted(getattr(command, "commands", {}).items()):
            inner = click.Context(child, info_name=part, parent=context)
            lines += [f"### {name} {part}", "", *_help(inner)]
    return "\n".join(lines).rstrip() + "\n"


def _help(context: click.Context) -> list[str]:
    """What ``--help`` prints, as a block."""
    return ["```", context.get_help(), "```", ""]


def index(target: Path) -> str:
    """List of all pages of a folder, the decision records below."""
    lines = ["# Documentation of pitchpoint", ""]
    for path in sorted(p for p in target.glob("*.md") if p.name != "index.md"):
        lines.append(f"- [{_title(path)}]({path.name})")
    lines += ["- [JSON schema of a model file](model-file.schema.json)", "", "## Decisions", ""]
    for path in sorted((target / "decisions").glob("*.md")):
        lines.append(f"- [{_title(path)}](decisions/{path.name})")
    return "\n".join(lines) + "\n"


def _title(path: Path) -> str:
    return path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")


def main(target: Path) -> None:
    """Write all pages below a folder."""
    shutil.copytree(HERE, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    pages = {"nomenclature": nomenclature, "units": units, "commands": commands, "model-file": reference_page}
    for name, page in pages.items():
        (target / f"{name}.md").write_text(page().rstrip() + "\n", encoding="utf-8")
    schema = json.dumps(json_schema(), indent=2, ensure_ascii=False)
    (target / "model-file.schema.json").write_text(schema + "\n", encoding="utf-8")
    (target / "index.md").write_text(index(target), encoding="utf-8")
    print(f"{target} written")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "build/docs"))
