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

import click

from pitchpoint.cli.main import COMMANDS, EPILOG
from pitchpoint.core.nomenclature import markdown_table
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import display_unit
from pitchpoint.model.schema import json_schema, reference_page

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
        lines += [f"## {name}", "", *_help(command, f"pitchpoint {name}")]
        for part, child in sorted(getattr(command, "commands", {}).items()):
            lines += [f"### {name} {part}", "", *_help(child, f"pitchpoint {name} {part}")]
    return "\n".join(lines).rstrip() + "\n"


def _help(command: click.Command, path: str) -> list[str]:
    """What ``--help`` prints, as a block."""
    context = click.Context(command, info_name=path, max_content_width=100)
    return ["```", command.get_help(context), "```", ""]


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
