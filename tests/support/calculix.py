# SPDX-License-Identifier: Apache-2.0
"""CalculiX (`ccx`, GPL) as an external program: input decks, runs, results. Lengths in mm, forces in N."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

requires_ccx = pytest.mark.skipif(
    shutil.which("ccx") is None, reason="CalculiX (ccx) is not installed; Debian: apt install calculix-ccx"
)


@dataclass
class Deck:
    """Input deck of one linear material.

    Parameters
    ----------
    nodes
        Coordinates [mm], shape (n, 2) or (n, 3).
    elements
        Node numbers from 0, shape (m, 8) or (m, 20).
    kind
        Type of the elements.
    lines
        The rest of the model.
    """

    nodes: np.ndarray
    elements: np.ndarray
    kind: str
    lines: list[str] = field(default_factory=list)

    def node_set(self, name: str, nodes: np.ndarray) -> None:
        """Named set of nodes."""
        self.lines += [f"*NSET, NSET={name}", *(f"{n + 1}," for n in nodes)]

    def text(self) -> str:
        """The whole deck."""
        found = ["*NODE, NSET=Nall"]
        found += [f"{k + 1}, " + ", ".join(f"{x:.12e}" for x in row) for k, row in enumerate(self.nodes)]
        found.append(f"*ELEMENT, TYPE={self.kind}, ELSET=Eall")
        for k, row in enumerate(self.elements):
            numbers = [str(n + 1) for n in row]
            found.append(f"{k + 1}, " + ", ".join(numbers[:10]) + ("," if len(numbers) > 10 else ""))
            if len(numbers) > 10:
                found.append(", ".join(numbers[10:]))
        return "\n".join([*found, *self.lines]) + "\n"

    def run(self, folder: Path, seconds: float = 600.0) -> dict[str, list[np.ndarray]]:
        """Results of all steps: name of the field to arrays (node, component) for each step.

        Nodes without a result have NaN.
        """
        (folder / "job.inp").write_text(self.text(), encoding="utf-8")
        done = subprocess.run(
            ["ccx", "-i", "job"], cwd=folder, capture_output=True, text=True, timeout=seconds, check=False
        )
        assert "Job finished" in done.stdout, done.stdout[-2000:]
        return fields(folder / "job.frd", len(self.nodes))


def material(E: float, nu: float) -> list[str]:
    """Isotropic material [MPa] of all elements."""
    return [
        "*MATERIAL, NAME=steel",
        "*ELASTIC",
        f"{E!r}, {nu!r}",
        "*SOLID SECTION, ELSET=Eall, MATERIAL=steel",
    ]


def fields(path: Path, count: int) -> dict[str, list[np.ndarray]]:
    """Nodal fields of a result file in its text form (-4 header, -1 values of 12 characters)."""
    found: dict[str, list[np.ndarray]] = {}
    now: np.ndarray | None = None
    with path.open(encoding="utf-8") as lines:
        for line in lines:
            if line.startswith(" -4"):
                now = np.full((count, 6), np.nan)
                found.setdefault(line.split()[1], []).append(now)
            elif line.startswith(" -3"):
                now = None
            elif now is not None and line.startswith(" -1"):
                node = int(line[3:13])
                if node <= count:
                    values = [float(line[k : k + 12]) for k in range(13, len(line.rstrip()), 12)]
                    now[node - 1, : len(values)] = values
    return found
