# SPDX-License-Identifier: Apache-2.0
"""Storage of a speed sweep: a table of direction, point and statistic per channel, filled point by point."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pitchpoint.core.load_sharing import is_factor
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.container import Header
from pitchpoint.io.reading import header_in, open_table
from pitchpoint.io.tables import Axis, Quantity, TableWriter

STATISTICS = ("mean", "rms", "min", "max")
QUANTITIES = (
    ("transmission_error", "m", "transmission error u_bt along the base tangent"),
    ("deflection", "m", "deflection u_bt - e along the base tangent"),
    ("mesh_force", "N", "mesh force along the base tangent"),
)
CONTACTS = RATTLE[:5]
"""Contact numbers of each mesh at each point of a sweep."""
SWEPT = "swept_mesh"
"""Option in the header with the name of the swept mesh."""


_NAMES = tuple(name for name, _, _ in (*QUANTITIES, *CONTACTS))
_STATE = "contact_state["


class SweepWriter(TableWriter):
    """Writer of a speed sweep; the file can be read during the sweep.

    Parameters
    ----------
    path, header
        File and provenance; the kind of the header is `sweep`.
    mesh
        Swept mesh: its contact numbers and statistics are stored in any case, the contact numbers of other
        meshes if their `contact_state` is among the channels.
    directions
        `up`, `down` or both, in the order of computation.
    speeds, mesh_frequencies
        Speed of the swept body [rad/s] and mesh frequency [Hz] of every point, ascending in magnitude,
        shape (n,).
    channels
        Name, SI unit and description of all channels with stored statistics, and of the mesh load factors of
        planetary stages, which are single numbers.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        mesh: str,
        directions: Sequence[str],
        speeds: Sequence[float],
        mesh_frequencies: Sequence[float],
        channels: Sequence[tuple[str, str, str]] = (),
    ) -> None:
        self.mesh = mesh
        own = {f"{name}[{mesh}]" for name, _, _ in QUANTITIES}
        others = [c for c in channels if c[0] not in own]
        self._others = [name for name, _, _ in others]
        states = (name for name, _, _ in channels if name.startswith(_STATE))
        self._meshes = list(dict.fromkeys((mesh, *(name[len(_STATE) : -1] for name in states))))
        self._directions = list(directions)
        axes = [
            Axis("direction", self._directions, long_name="direction of the sweep"),
            Axis("mesh_frequency", [float(f) for f in mesh_frequencies], "Hz", "mesh frequency", "f_z"),
            Axis("statistic", STATISTICS),
        ]
        point = ("direction", "mesh_frequency")
        quantities = [
            Quantity("speed", ("mesh_frequency",), "rad/s", "speed of the swept body", "omega"),
            *(Quantity(f"{n}[{mesh}]", (*point, "statistic"), unit, words) for n, unit, words in QUANTITIES),
            *(
                Quantity(name, point if is_factor(name) else (*point, "statistic"), unit, words)
                for name, unit, words in others
            ),
            *contact_quantities(self._meshes, point),
            Quantity("point_status", point, "1", "status of the computation of the point", dtype="i4"),
        ]
        jumps = [("jump_direction", "", "i4"), ("jump_mesh_frequency", "Hz", "f8")]
        header = replace(header, options={**header.options, SWEPT: mesh})
        super().__init__(path, header, axes, quantities, growing=jumps)
        self.fill("speed", ..., list(speeds))
        self.flush()

    def put(self, direction: str, point: int, values: Mapping[str, Any], status: int = 1) -> None:
        """Write one point: `values` as in the points of `SweepSummary`; missing values remain NaN."""
        at = (self._directions.index(direction), point)
        for name, _, _ in QUANTITIES:
            if name in values:
                self.fill(f"{name}[{self.mesh}]", at, [values[name][key] for key in STATISTICS])
        known = values.get("channels", {})
        for name in self._others:
            if name in known:
                self.fill(name, at, [known[name][key] for key in STATISTICS])
            elif name in values:
                self.fill(name, at, values[name])
        for mesh, numbers in values.get("meshes", {self.mesh: values}).items():
            for name, _, _ in CONTACTS:
                if mesh in self._meshes and name in numbers:
                    self.fill(f"{name}[{mesh}]", at, numbers[name])
        self.complete("point_status", at, status)

    def put_jumps(self, jumps: Sequence[Mapping[str, Any]]) -> None:
        """Write the jumps: `direction` and `mesh_frequency` [Hz] of each."""
        for jump in jumps:
            self.extend(
                {
                    "jump_direction": self._directions.index(jump["direction"]),
                    "jump_mesh_frequency": jump["mesh_frequency"],
                }
            )
        self.flush()


def contact_quantities(meshes: Sequence[str], axes: tuple[str, ...]) -> list[Quantity]:
    """Variables of the contact numbers of meshes over the axes of the points."""
    return [
        Quantity(f"{name}[{mesh}]", axes, unit, words) for mesh in meshes for name, unit, words in CONTACTS
    ]


def stored_meshes(names: Sequence[str], swept: str) -> list[str]:
    """Meshes with mesh forces among the names of variables, the swept mesh first."""
    first = f"{QUANTITIES[2][0]}["
    return list(dict.fromkeys((swept, *(name[len(first) : -1] for name in names if name.startswith(first)))))


def results_of_meshes(
    meshes: Sequence[str], tables: Mapping[str, Any], at: tuple[int, ...]
) -> dict[str, dict[str, Any]]:
    """Statistics and contact numbers of each mesh at one point of a sweep.

    Parameters
    ----------
    meshes
        Names of the meshes.
    tables
        Arrays by the name of the variable.
    at
        Indices of the point in the arrays.
    """
    found: dict[str, dict[str, Any]] = {}
    for mesh in meshes:
        own = {n: tables[name][at] for n in _NAMES if (name := f"{n}[{mesh}]") in tables}
        # files of earlier versions have the contact numbers of the swept mesh only, or only some of them
        found[mesh] = {n: statistics_row(own[n], unit) for n, unit, _ in QUANTITIES if n in own}
        found[mesh] |= {n: float(own[n]) for n, _, _ in CONTACTS if n in own}
    return found


def statistics_row(values: Any, unit: str) -> dict[str, Any]:
    """Statistics with their names."""
    return {"unit": unit} | {key: float(value) for key, value in zip(STATISTICS, values, strict=True)}


def read_sweep(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a sweep as plain data: `mesh` (the swept mesh), `points` in the order run, `jumps`.

    Points that were not computed are omitted; `open_result` has all channels.
    """
    with open_table(path, "sweep") as file:
        return _plain(file)


def _plain(file: Mapping[str, Any]) -> dict[str, Any]:
    """Plain data of the variables of a sweep."""
    mesh = header_in(file["speed"].file)["options"].get(SWEPT)
    if mesh is None:  # files of earlier versions have contact numbers of the swept mesh only
        first = f"{CONTACTS[0][0]}["
        mesh = next(name for name in file if name.startswith(first))[len(first) : -1]
    directions = [d.decode() if isinstance(d, bytes) else d for d in file["direction"][...]]
    frequencies, speeds = file["mesh_frequency"][...], file["speed"][...]
    status = file["point_status"][...]  # before the values: a running sweep writes them in the opposite order
    meshes = stored_meshes(list(file), mesh)
    named = (f"{n}[{m}]" for m in meshes for n in _NAMES)
    tables = {name: file[name][...] for name in named if name in file}
    n = file["jump"].shape[0]
    where, jump_at = file["jump_direction"][:n], file["jump_mesh_frequency"][:n]
    points = []
    for k, direction in enumerate(directions):
        order = range(len(frequencies)) if direction == "up" else range(len(frequencies) - 1, -1, -1)
        for i in order:
            if status[k, i] < 0:
                continue
            found = results_of_meshes(meshes, tables, (k, i))
            points.append(
                {
                    "direction": direction,
                    "speed": float(speeds[i]),
                    "mesh_frequency": float(frequencies[i]),
                    **found[mesh],
                    "meshes": found,
                    "status": int(status[k, i]),
                }
            )
    jumps = [
        {"direction": directions[int(d)], "mesh_frequency": float(f)}
        for d, f in zip(where, jump_at, strict=True)
    ]
    return {"mesh": mesh, "points": points, "jumps": jumps}
