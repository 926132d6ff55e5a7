# SPDX-License-Identifier: Apache-2.0
"""Storage of independent cases: one table over the cases, filled case by case in any order."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from pitchpoint.core.load_sharing import factor_row, is_factor
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.container import Header
from pitchpoint.io.reading import header_in, open_table
from pitchpoint.io.sweep_store import (
    CONTACTS,
    QUANTITIES,
    STATISTICS,
    SWEPT,
    contact_quantities,
    results_of_meshes,
    statistics_row,
    stored_meshes,
)
from pitchpoint.io.tables import Axis, Quantity, TableWriter

LETTERS = 500
"""Maximum size of the sentence of a case [bytes]."""
_CONTACT_NAMES = {name for name, _, _ in RATTLE}


class CaseWriter(TableWriter):
    """Writer for the results of independent cases; the file can be read while it is written.

    Parameters
    ----------
    path, header
        File and provenance; the kind of the header is `cases`.
    values
        Values of every varied path as texts, one per case.
    channels
        Name, SI unit and description of the channels with stored statistics, and of the mesh load factors of
        planetary stages, which are single numbers.
    meshes
        Meshes with stored contact numbers, of speed sweeps also with statistics; the swept mesh first.
    directions, n_points
        Of speed sweeps: their directions and the number of speeds; no points for other scenarios.
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        values: Mapping[str, Sequence[str]],
        channels: Sequence[tuple[str, str, str]],
        *,
        meshes: Sequence[str] = (),
        directions: Sequence[str] = (),
        n_points: int = 0,
    ) -> None:
        count = max((len(v) for v in values.values()), default=0)
        self._channels = {name for name, _, _ in channels}
        self._meshes = list(meshes)
        self._directions = list(directions)
        axes = [Axis("case", list(range(count)), "", "number of the case"), Axis("statistic", STATISTICS)]
        axes.append(Axis("letter", LETTERS))
        quantities = [
            *(Quantity(f"given[{p}]", ("case",), "", f"{p} as given", dtype="text") for p in values),
            *(Quantity(f"value[{p}]", ("case",), "", f"{p} in SI units") for p in values),
            *(
                Quantity(name, at if is_factor(name) else (*at, "statistic"), unit, words)
                for name, unit, words in channels
                for at in [("case", "direction", "point") if n_points else ("case",)]
            ),
            *(
                Quantity(f"{n}[{m}]", ("case",), unit, words)
                for m in ([] if n_points else meshes)
                for n, unit, words in RATTLE
            ),
            Quantity("case_status", ("case",), "1", "status of the case; 1 is success", dtype="i4"),
            Quantity("case_sentence", ("case", "letter"), "", "status of the case in words", dtype="S1"),
            Quantity("wall_s", ("case",), "s", "wall time of the case"),
        ]
        if n_points:
            axes += [Axis("direction", self._directions), Axis("point", list(range(n_points)))]
            at = ("case", "direction", "point")
            quantities += [
                Quantity("speed", at, "rad/s", "speed of the swept body"),
                Quantity("mesh_frequency", at, "Hz", "mesh frequency"),
                *(
                    Quantity(f"{name}{of}", (*at, "statistic"), unit, words)
                    for of in ("", *(f"[{m}]" for m in meshes))
                    for name, unit, words in QUANTITIES
                ),
                *(Quantity(name, at, unit, words) for name, unit, words in CONTACTS),
                *contact_quantities(meshes, at),
            ]
            if meshes:
                header = replace(header, options={**header.options, SWEPT: meshes[0]})
        texts = {f"given[{p}]": list(v) for p, v in values.items()}
        super().__init__(path, header, axes, quantities, texts=texts)

    def put(self, result: Any) -> None:
        """Write one case: a `CaseResult`, or anything with its attributes."""
        k = result.index
        for path, (number, _) in result.numbers.items():
            self.fill(f"value[{path}]", k, number)
        for name, row in result.channels.items():
            if name in self._channels:
                self.fill(name, k, row["mean"] if is_factor(name) else [row[s] for s in STATISTICS])
        for mesh in () if self._directions else self._meshes:
            state = result.channels.get(f"contact_state[{mesh}]", {})
            for name, _, _ in RATTLE:
                if name in state:
                    self.fill(f"{name}[{mesh}]", k, state[name])
        for d, direction in enumerate(self._directions):
            here = sorted(
                (p for p in result.points if p["direction"] == direction), key=lambda p: p["mesh_frequency"]
            )
            for i, point in enumerate(here):
                for name in ("speed", "mesh_frequency", *(n for n, _, _ in CONTACTS), *self._channels):
                    if name in point:
                        self.fill(name, (k, d, i), point[name])
                for name, _, _ in QUANTITIES:
                    self.fill(name, (k, d, i), [point[name][s] for s in STATISTICS])
                for mesh in self._meshes:
                    row = point["meshes"].get(mesh, {})
                    for name, _, _ in CONTACTS:
                        if name in row:
                            self.fill(f"{name}[{mesh}]", (k, d, i), row[name])
                    for name, _, _ in QUANTITIES:
                        if name in row:
                            self.fill(f"{name}[{mesh}]", (k, d, i), [row[name][s] for s in STATISTICS])
        self.fill("case_sentence", k, _letters(result.sentence))
        self.fill("wall_s", k, result.wall_s)
        self.complete("case_status", k, result.status)


def read_cases(path: str | os.PathLike[str]) -> list[dict[str, Any]]:
    """Read the computed cases as plain data: `case`, `values`, `numbers`, `status`, `sentence`
    and `channels`.

    Cases of a speed sweep also have `points`.
    """
    with open_table(path, "cases") as file:
        return _plain(file)


def _plain(file: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Plain data of the variables of cases."""
    status = file["case_status"][...]
    sentences = [_sentence(row) for row in file["case_sentence"][...]]
    given = {_inside(n): _texts(file[n][...]) for n in file if n.startswith("given[")}
    numbers = {_inside(n): file[n][...] for n in file if n.startswith("value[")}
    tables = {
        n: (v[...], _text(v.attrs.get("units", "")))
        for n, v in file.items()
        if v.ndim == 2 and v.shape[1] == len(STATISTICS)
    }
    contacts = {n: v[...] for n, v in file.items() if v.ndim == 1 and n.partition("[")[0] in _CONTACT_NAMES}
    factors = {n: v[...] for n, v in file.items() if is_factor(n)}
    swept = "mesh_frequency" in file
    directions = _texts(file["direction"][...]) if swept else []
    points = {n: v[...] for n, v in file.items() if v.ndim >= 3} if swept else {}
    first = header_in(file["case_status"].file)["options"].get(SWEPT, "")
    found = []
    for k, code in enumerate(status):
        if code < 0:
            continue
        channels = {
            n: {"unit": unit} | {s: float(x) for s, x in zip(STATISTICS, v[k], strict=True)}
            for n, (v, unit) in tables.items()
        }
        channels |= {n: factor_row(float(v[k])) for n, v in factors.items() if v.ndim == 1}
        for n, v in contacts.items():
            name, _, mesh = n.partition("[")
            channels[f"contact_state[{mesh}"][name] = float(v[k])
        found.append(
            {
                "case": k,
                "values": {p: texts[k] for p, texts in given.items()},
                "numbers": {p: float(v[k]) for p, v in numbers.items()},
                "status": int(code),
                "sentence": sentences[k],
                "channels": channels,
                "points": points_of(points, directions, k, first),
            }
        )
    return found


def points_of(
    tables: Mapping[str, Any], directions: Sequence[str], case: int, swept: str = ""
) -> list[dict[str, Any]]:
    """Points of the sweep of one case in the order of computation.

    Parameters
    ----------
    tables
        Tables by case, direction and point.
    directions
        No directions: no points.
    case
        Number of the case.
    swept
        Swept mesh; without it, as of files of earlier versions, the points have no `meshes`.
    """
    meshes = stored_meshes(list(tables), swept) if swept else []
    found = []
    for d, direction in enumerate(directions):
        frequencies = tables["mesh_frequency"][case, d]
        order = range(len(frequencies)) if direction == "up" else range(len(frequencies) - 1, -1, -1)
        for i in order:
            if not frequencies[i] > 0.0:
                continue
            at = (case, d, i)
            point: dict[str, Any] = {"direction": direction}
            for name in ("speed", "mesh_frequency", *(n for n, _, _ in CONTACTS), *filter(is_factor, tables)):
                if name in tables:  # files of earlier versions have fewer
                    point[name] = float(tables[name][at])
            for name, unit, _ in QUANTITIES:
                point[name] = statistics_row(tables[name][at], unit)
            if meshes:
                point["meshes"] = results_of_meshes(meshes, tables, at)
            found.append(point)
    return found


def _letters(text: str) -> list[bytes]:
    """Text as a padded row of single bytes (UTF-8)."""
    data = text.encode("utf-8")[:LETTERS].decode("utf-8", "ignore").encode("utf-8").ljust(LETTERS, b"\0")
    return [data[k : k + 1] for k in range(LETTERS)]


def _sentence(row: Any) -> str:
    return b"".join(row.tolist()).decode("utf-8")


def _inside(name: str) -> str:
    return name.partition("[")[2].removesuffix("]")


def _text(value: Any) -> str:
    return value.decode("utf-8") if isinstance(value, bytes) else str(value)


def _texts(values: Any) -> list[str]:
    return [_text(v) for v in values]
