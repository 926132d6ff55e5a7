# SPDX-License-Identifier: Apache-2.0
"""Source of the documentation site: the written pages, and those made from the package and its examples.

Usage: ``python docs/generate.py build/docs/source``. `make docs` builds the site from it with Sphinx.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path
from typing import Any

import click
import make_api
import make_drawings
import make_gallery

from pitchpoint.cli.main import COMMANDS, EPILOG, command_of, pitchpoint
from pitchpoint.core.nomenclature import markdown_table
from pitchpoint.core.unit_table import DIMENSIONS, PLAIN_UNITS, WORDS, Unit
from pitchpoint.core.units import display_unit
from pitchpoint.model.reference import reference_page, snippets_of
from pitchpoint.model.schema import json_schema

HERE = Path(__file__).parent
ROOT = HERE.parent
# parts of the first page of the repository that the site shows too: from this heading, to that one
PARTS_OF_README = {
    "install": ("## Requirements\n", "## The first five minutes\n"),
    "first_steps": ("## The first five minutes\n", "## Features\n"),
    "contents": ("## Features\n", "## Limitations\n"),
    "limits": ("## Limitations\n", "## Further reading\n"),
}


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
* Several symbols in the denominator are put in brackets or each after a slash: `14 N/(mm um)`, `14 N/mm/um`.
* Speeds of rotation: `rpm`, `1/min`, `/min`, `min^-1`, `rev/min`, `r/min`, `U/min`, `Hz` count revolutions,
  `rad/s` and `deg/s` angles. `1/s` does not state what it counts and is refused.
* `grad` and `Grad` (degree or gon) are refused: write `deg` or `gon`. `lb`, `oz`, `kg`, `t` are masses, and
  `lbf`, `ozf`, `kgf`, `kN` the forces.

## Symbols

n, u (or µ), m, k, M and G may be before m, g, s, N, Pa, J, W and Hz; n, u and m before rad. Names that
are not in the table are looked up in [pint](https://pint.readthedocs.io), except for angles and rates.

| symbol | in SI |
|---|---|
"""


def units() -> str:
    """Page of the units that a model file accepts for each kind of quantity."""
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


SNIPPETS = (
    *sorted((HERE / "reference" / "snippets").glob("*.yaml")),
    ROOT / "examples" / "bevel-drive" / "spiral.yaml",
    ROOT / "examples" / "flexible-slider-crank" / "elastic.yaml",
    ROOT / "examples" / "speed-control" / "model.yaml",
    ROOT / "examples" / "wind-turbine" / "model.yaml",
)
"""Models whose sections the reference page shows; of several with a section, the first."""


def model_file() -> str:
    """Page of the keys of a model file, with a part of a model for each section."""
    found: dict[str, str] = {}
    for path in SNIPPETS:
        found = snippets_of(path.read_text(encoding="utf-8")) | found
    return reference_page(found)


def commands() -> str:
    """Page of all commands with their options."""
    lines = ["# Commands", "", EPILOG, ""]
    # every command has its options for help from the program; the width must not be that of some terminal
    settings: dict[str, Any] = pitchpoint.context_settings | {"terminal_width": 100}
    program = click.Context(pitchpoint, info_name="pitchpoint", **settings)
    for name in COMMANDS:
        command = command_of(name)
        context = click.Context(command, info_name=name, parent=program)
        lines += [f"## {name}", "", *_help(context)]
        for part, child in sorted(getattr(command, "commands", {}).items()):
            inner = click.Context(child, info_name=part, parent=context)
            lines += [f"### {name} {part}", "", *_help(inner)]
    return "\n".join(lines).rstrip() + "\n"


def _help(context: click.Context) -> list[str]:
    """What ``--help`` prints, as a block."""
    return ["```", context.get_help(), "```", ""]


def copy_written(target: Path) -> None:
    """Copy the pages of this folder and those of the root; a page that did not change keeps its time."""
    scripts = shutil.ignore_patterns("make_*.py", "generate.py", "check_site.py", "sheet.py", "__pycache__")
    shutil.copytree(HERE, target, dirs_exist_ok=True, ignore=scripts)
    for folder in ("tutorials", "howto"):
        # what notebooks of an earlier build have written would be in the way of this one
        shutil.rmtree(target / folder, ignore_errors=True)
        shutil.copytree(HERE / folder, target / folder)
    for name in ("CHANGELOG", "CONTRIBUTING"):
        text = (ROOT / f"{name}.md").read_text(encoding="utf-8")
        write(target / f"{name.lower()}.md", text.replace("](docs/", "](").replace("`docs/", "`docs/"))
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for name, (start, end) in PARTS_OF_README.items():
        part = readme[readme.index(start) + len(start) : readme.index(end)]
        write(target / "_parts" / f"{name}.md", part.strip() + "\n")
    first = readme.index("```yaml\n") + len("```yaml\n")
    write(target / "howto" / "pair.yaml", readme[first : readme.index("```", first)])


def write(path: Path, text: str) -> None:
    """Write a page, only if it is new or changed: Sphinx reads again what has a new time."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def main(target: Path) -> None:
    """Write all pages below a folder."""
    copy_written(target)
    reference = target / "reference"
    pages = {"nomenclature": nomenclature, "units": units, "commands": commands, "model-file": model_file}
    for name, page in pages.items():
        write(reference / f"{name}.md", page().rstrip() + "\n")
    schema = json.dumps(json_schema(), indent=2, ensure_ascii=False)
    write(target / "_extra" / "model-file.schema.json", schema + "\n")
    make_api.write_pages(reference / "api")
    make_drawings.write_drawings(target / "images" / "conventions")
    make_gallery.write_gallery(target)
    print(f"{target} written")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "build/docs/source"))
