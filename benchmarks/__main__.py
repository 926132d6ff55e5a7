# SPDX-License-Identifier: Apache-2.0
"""Print the speed table and write it as JSON: `python -m benchmarks --json build/bench.json`."""

from __future__ import annotations

import argparse
import json
import math
from dataclasses import asdict
from pathlib import Path

from rich.console import Console
from rich.table import Table

from benchmarks import (
    command_line,
    dataset,
    flank_contact,
    gearbox,
    mechanisms,
    rexs,
    scene,
    shovel,
    study,
    turbine,
    two_inertia,
    wind,
)
from benchmarks.rows import Row


def show(rows: list[Row]) -> None:
    """Print the table."""
    table = Table(title="pitchpoint: speed against peers, one run")
    for name in ("what", "value", "unit", "target", "", "measured how"):
        table.add_column(name, justify="right" if name == "value" else "left")
    for row in rows:
        mark = {True: "[green]met", False: "[red]missed", None: ""}[row.met]
        table.add_row(row.name, f"{row.value:.4g}", row.unit, row.target, mark, row.peer)
    Console(width=150).print(table)


def main() -> None:
    """Run all benchmarks."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--json", type=Path, default=Path("build/bench.json"))
    target = parser.parse_args().json
    console = Console(stderr=True)
    bare: list[float] = []
    rows: list[Row] = []
    for text, work in (
        ("two inertias against a bare loop, exudyn, SciPy", lambda: two_inertia.rows(bare)),
        ("pair with 12 degrees of freedom, sweeps", lambda: gearbox.rows(bare[0])),
        ("contact of tooth surfaces", lambda: flank_contact.rows(bare[0])),
        ("mechanisms against exudyn, planetary set, many bodies", mechanisms.rows),
        ("shovel gearbox", shovel.rows),
        ("wind-turbine drive train, planetary set in all directions, wind", wind.rows),
        ("wind turbine and its gearbox against real time", turbine.rows),
        ("data set of the PHM 2009 rig", dataset.rows),
        ("gearbox from REXS", rexs.rows),
        ("tolerance study of a two-stage gearbox", study.rows),
        ("command line", command_line.rows),
        ("scene in a browser", scene.rows),
    ):
        console.print(f"measuring: {text} ...")
        rows += work()
    show(rows)
    target.parent.mkdir(parents=True, exist_ok=True)
    plain = [
        {k: (None if isinstance(v, float) and math.isnan(v) else v) for k, v in asdict(r).items()}
        for r in rows
    ]
    target.write_text(json.dumps(plain, indent=1) + "\n", encoding="utf-8")
    console.print(f"written to {target}")


if __name__ == "__main__":
    main()
