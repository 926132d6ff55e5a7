# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint examples`: list the examples of the package or copy one."""

from __future__ import annotations

import re
from fnmatch import fnmatch
from pathlib import Path

import click

from pitchpoint.cli.options import as_json, debug
from pitchpoint.cli.output import emit_json, show, table

# Files that runs of an example create.
_LEFTOVERS = ("build", "__pycache__", "*.h5", "*.html", "*.pyc", "*.bts", ".*")


def examples_folder() -> Path:
    """Locate the examples: in the installed package, or in its source tree."""
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "examples", package.parents[1] / "examples"):
        if folder.is_dir():
            return folder
    raise click.ClickException("this installation has no examples; reinstall the package")


def example_names() -> list[str]:
    """Names of the examples: folders with a README and at least one model file."""
    return sorted(
        folder.name
        for folder in examples_folder().iterdir()
        if (folder / "README.md").is_file() and any(folder.glob("*.yaml"))
    )


def title_of(folder: Path) -> str:
    """First heading of the README of an example."""
    for line in (folder / "README.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            return line[2:].strip()
    return folder.name


@click.group()
def examples() -> None:
    """List or copy the examples of pitchpoint."""


@examples.command("list")
@as_json
@debug
def list_examples(as_json: bool) -> None:
    """List the examples."""
    rows = [
        {
            "name": name,
            "title": title_of(examples_folder() / name),
            "files": sorted(path.name for path in (examples_folder() / name).glob("*.yaml")),
        }
        for name in example_names()
    ]
    if as_json:
        emit_json({"examples": rows})
        return
    cells = [[str(row["name"]), str(row["title"]), ", ".join(row["files"])] for row in rows]
    table("Examples", ["name", "topic", "model files"], cells)
    show("Copy one with: pitchpoint examples copy NAME [DIR]")


@examples.command("copy")
@click.argument("name")
@click.argument("directory", required=False, type=click.Path(file_okay=False))
@click.option("--force", is_flag=True, help="Overwrite existing files.")
@debug
def copy_example(name: str, directory: str | None, force: bool) -> None:
    """Copy the example NAME to the folder DIRECTORY (default: ./NAME).

    Examples whose files it includes are copied next to it.
    """
    if name not in example_names():
        from pitchpoint.core.nearest import did_you_mean

        known = example_names()
        guess = did_you_mean(name, known).strip() or f"there are {', '.join(known) or 'none'}"
        raise click.BadParameter(f"no example {name!r}; {guess}", param_hint="NAME")
    target = Path(directory if directory is not None else name)
    targets = {name: target} | {other: target.resolve().parent / other for other in _included(name)}
    for folder in targets.values():
        if folder.exists() and any(folder.iterdir()) and not force:
            raise click.BadParameter(
                f"{folder} is not empty; use --force to overwrite", param_hint="DIRECTORY"
            )
    for one, folder in targets.items():
        _copy(examples_folder() / one, folder)
    show(
        " and ".join(
            f"copied to {folder}" if folder == target else str(folder) for folder in targets.values()
        )
    )
    for path in sorted(target.glob("*.yaml")):
        if re.search("^title:", path.read_text(encoding="utf-8"), re.M):  # others are parts to be included
            show(f"  pitchpoint check {path}")


def _included(name: str) -> list[str]:
    """Other examples whose files the models of an example include, directly or by files of others."""
    found, queue = {name}, [name]
    while queue:
        folder = examples_folder() / queue.pop()
        for path in sorted(folder.rglob("*.yaml")):
            for file in _include_list(path):
                own = (path.parent / file).resolve()
                if own.is_relative_to(examples_folder().resolve()):
                    other = own.relative_to(examples_folder().resolve()).parts[0]
                    if other not in found:
                        found.add(other)
                        queue.append(other)
    return sorted(found - {name})


def _include_list(path: Path) -> list[str]:
    """Files in the key `include` of a model file."""
    from pitchpoint.model.keys import INCLUDE
    from pitchpoint.model.reading.yaml_tree import Tree, TreeError

    try:
        data = Tree(path.read_text(encoding="utf-8")).data
    except TreeError:
        return []
    wanted = data.get(INCLUDE) if isinstance(data, dict) else None
    return [wanted] if isinstance(wanted, str) else [str(file) for file in wanted or ()]


def _copy(folder: Path, target: Path) -> None:
    """Copy a folder without the files that runs have created."""
    from pitchpoint.io.target import write_file

    for path in sorted(folder.rglob("*")):
        below = path.relative_to(folder)
        if path.is_file() and not any(fnmatch(part, left) for part in below.parts for left in _LEFTOVERS):
            write_file(target / below, path.read_bytes())
