# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint schema`: JSON schema of model files, for editors."""

from __future__ import annotations

import json

import click

from pitchpoint.cli.options import debug, output
from pitchpoint.cli.output import show

SCHEMA_FILE = "pitchpoint.schema.json"
"""Usual name of the schema, next to the model files."""


def modeline(name: str) -> str:
    """First line of a model file that names its schema, for the YAML language server."""
    return f"# yaml-language-server: $schema={name}\n"


@click.command()
@output(f"File such as {SCHEMA_FILE}; default: print the schema.")
@debug
def schema(output: str | None) -> None:
    """JSON schema of model files: editors complete keys, show their meaning, and mark errors.

    With the YAML extension of VS Code, a model file refers to the schema in its first line.
    """
    from pathlib import Path

    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.model.schema import json_schema

    text = json.dumps(json_schema(), indent=2, ensure_ascii=False) + "\n"
    if output is None:
        show(text.rstrip())
        return
    target = check_target(output, "schema")
    write_file(target, text)
    show(f"written to {target}; first line of a model file in the same folder:")
    show(modeline(Path(output).name).rstrip())
