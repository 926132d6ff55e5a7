# SPDX-License-Identifier: Apache-2.0
"""Pages of the documentation that are made from the package itself: names, units, commands, decisions.

Usage: ``python docs/generate.py build/docs``. The written pages of this folder are copied beside them.
"""

from __future__ import annotations

import importlib
import shutil
import sys
from pathlib import Path

import click

from pitchpoint.cli.main import COMMANDS, EPILOG
from pitchpoint.core.nomenclature import markdown_table
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import display_unit

HERE = Path(__file__).parent


def nomenclature() -> str:
    """Page of all names."""
    head = "# Nomenclature\n\nFrom `core/nomenclature.csv`. Everything inside is SI and radians.\n\n"
    return head + markdown_table()


def units() -> str:
    """Page of what a model file may say for each kind of quantity."""
    head = "# Units\n\nA bare number is SI; angles are radians.\n\n"
    lines = ["| kind | SI | for instance | shown in |", "|---|---|---|---|"]
    for name, row in DIMENSIONS.items():
        lines.append(f"| {row.words} | {row.si or '1'} | `{row.example}` | {display_unit(name) or '1'} |")
    return head + "\n".join(lines) + "\n"


def commands() -> str:
    """Page of all commands with their options."""
    lines = ["# Commands", "", EPILOG, ""]
    for name in COMMANDS:
        command: click.Command = getattr(importlib.import_module(f"pitchpoint.cli.{name}"), name)
        context = click.Context(command, info_name=f"pitchpoint {name}", max_content_width=100)
        lines += [f"## {name}", "", "```", command.get_help(context), "```", ""]
    return "\n".join(lines)


def decisions() -> str:
    """Index of the decision records."""
    lines = ["# Decisions", ""]
    for path in sorted((HERE / "decisions").glob("*.md")):
        title = path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")
        lines.append(f"- [{title}](decisions/{path.name})")
    return "\n".join(lines) + "\n"


def main(target: Path) -> None:
    """Write all pages below a folder."""
    shutil.copytree(HERE, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.py", "__pycache__"))
    pages = {"nomenclature": nomenclature, "units": units, "commands": commands, "decisions": decisions}
    for name, page in pages.items():
        (target / f"{name}.md").write_text(page(), encoding="utf-8")
    print(f"{target} written")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "build/docs"))
