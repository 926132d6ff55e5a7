# SPDX-License-Identifier: Apache-2.0
"""Tables in the result container: speed sweeps, filled point by point, and modes.

A table has named dimensions with coordinates and variables over them, all of fixed size and filled with NaN
(integers: -1) at first. Each point is on the disk as soon as it is computed.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pitchpoint.core import status as st
from pitchpoint.core.nomenclature import symbol
from pitchpoint.io.container import FINISHED, Container, Header, ResultError
from pitchpoint.io.writing import Closing


@dataclass(frozen=True)
class Axis:
    """Dimension: name, coordinate values (numbers or texts), unit and description.

    A single number as `values` is the length of a dimension without coordinate.
    """

    name: str
    values: Sequence[Any] | int
    unit: str = ""
    long_name: str = ""
    symbol: str = ""


@dataclass(frozen=True)
class Quantity:
    """Variable: name, names of its dimensions, unit, description and storage type.

    The default symbol is that of the nomenclature. `part_of` names the complex variable of which it is the
    real or imaginary part.
    """

    name: str
    axes: tuple[str, ...]
    unit: str = ""
    long_name: str = ""
    symbol: str = ""
    dtype: str = "f8"
    part_of: str = ""


class TableWriter(Closing):
    """Writer of tables that can be read while they are filled.

    Parameters
    ----------
    path
        File to write.
    header
        Provenance; its `kind` is `sweep`, `modes` or the like.
    axes
        Dimensions.
    quantities
        Variables over these dimensions.
    growing
        Columns (name, unit, type) of one list of unknown length, such as the jumps of a sweep; its dimension
        is called `growing_name`.
    texts
        Contents of the quantities of type `text`; they cannot be changed later.
    coordinates
        Names of the quantities that are coordinates of a dataset.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> name = pathlib.Path(tempfile.mkdtemp()) / "sweep.h5"
    >>> axes = [Axis("direction", ["up", "down"]), Axis("point", [0, 1])]
    >>> force = Quantity("mesh_force[stage]", ("direction", "point"), "N")
    >>> with TableWriter(name, Header("sweep"), axes, [force]) as table:
    ...     table.fill("mesh_force[stage]", (0, 1), 250.0)
    """

    def __init__(
        self,
        path: str | os.PathLike[str],
        header: Header,
        axes: Sequence[Axis],
        quantities: Sequence[Quantity],
        *,
        growing: Sequence[tuple[str, str, str]] = (),
        growing_name: str = "jump",
        texts: Mapping[str, Any] | None = None,
        coordinates: Sequence[str] = (),
    ) -> None:
        self._begun = time.perf_counter()
        lengths = {a.name: a.values if isinstance(a.values, int) else len(a.values) for a in axes}
        values = sum(
            (64 if q.dtype == "text" else int(q.dtype[1:]))
            * math.prod(lengths.get(name, 0) for name in q.axes)
            for q in quantities
        )
        variables = len(axes) + len(quantities) + len(growing) + 1
        self._container = container = Container(path, header, variables, values)
        with container.writing():
            self._make(axes, quantities, growing, growing_name)
            for name, words in (texts or {}).items():
                self._variables[name][...] = words
            if coordinates:  # as in the CF conventions of netCDF
                container.file.attrs["coordinates"] = " ".join(coordinates)
        container.begin()

    def _make(
        self,
        axes: Sequence[Axis],
        quantities: Sequence[Quantity],
        growing: Sequence[tuple[str, str, str]],
        growing_name: str,
    ) -> None:
        """Create dimensions and variables."""
        container = self._container
        scales = {
            axis.name: container.dimension(
                axis.name,
                axis.values,
                dtype="i8" if _whole(axis.values) else "f8",
                attributes={"units": axis.unit, "long_name": axis.long_name, "symbol": axis.symbol},
            )
            for axis in axes
        }
        self._variables = {}
        for q in quantities:
            unknown = [name for name in q.axes if name not in scales]
            if unknown:
                container.finish("failed", "the table has no such dimension")
                raise ResultError(f"{q.name}: the table has no dimension {', '.join(unknown)}")
            self._variables[q.name] = container.variable(
                q.name,
                [scales[name] for name in q.axes],
                dtype=q.dtype,
                attributes={
                    "units": q.unit,
                    "long_name": q.long_name,
                    "symbol": q.symbol or symbol(q.name),
                    "part_of": q.part_of,
                    "_Encoding": "utf-8" if q.dtype == "S1" else "",
                },
            )
        self._length = 0
        self._columns: dict[str, Any] = {}
        if growing:
            self._index = container.dimension(growing_name, unlimited=True, chunk=64, dtype="i8")
            for name, unit, dtype in growing:
                self._columns[name] = container.variable(
                    name, [self._index], dtype=dtype, chunks=(64,), attributes={"units": unit}
                )

    @property
    def path(self) -> str:
        """The file."""
        return str(self._container.path)

    def fill(self, name: str, index: Any, values: Any) -> None:
        """Set values of a variable at an index or slice."""
        with self._container.writing():
            self._variables[name][index] = values

    def extend(self, row: Mapping[str, Any]) -> None:
        """Add one row to the growing list."""
        self._length += 1
        with self._container.writing():
            for name, column in self._columns.items():
                column.resize((self._length,))
                column[self._length - 1] = row[name]
            self._index.resize((self._length,))
            self._index[self._length - 1] = self._length - 1

    def flush(self) -> None:
        """Flush to the disk."""
        self._container.flush()

    def complete(self, name: str, index: Any, status: int) -> None:
        """Set the status of a point or case after a flush of its values: a flush has no defined order."""
        self.flush()
        self.fill(name, index, status)
        self.flush()

    def finish(
        self,
        status: str = FINISHED,
        sentence: str = "",
        *,
        code: int = st.OK,
        steps: int = 0,
        notes: Sequence[str] = (),
    ) -> None:
        """Write the final status and close; a second call has no effect."""
        elapsed = time.perf_counter() - self._begun
        self._container.finish(
            status, sentence or st.sentence(code), code=code, steps=steps, wall_s=elapsed, notes=notes
        )


def _whole(values: Sequence[Any] | int) -> bool:
    return not isinstance(values, int) and all(isinstance(v, int) for v in values)


def write_tables(
    path: str | os.PathLike[str],
    header: Header,
    axes: Sequence[Axis],
    filled: Sequence[tuple[Quantity, Any]],
    *,
    status: str = FINISHED,
    sentence: str = "",
    code: int = st.OK,
    steps: int = 0,
    notes: Sequence[str] = (),
    coordinates: Sequence[str] = (),
) -> None:
    """Write complete tables, such as modes: quantities with arrays, and the final status."""
    texts = {q.name: values for q, values in filled if q.dtype == "text"}
    with TableWriter(
        path, header, axes, [q for q, _ in filled], texts=texts, coordinates=coordinates
    ) as table:
        for quantity, values in filled:
            if quantity.dtype != "text":
                table.fill(quantity.name, ..., values)
        table.finish(status, sentence, code=code, steps=steps, notes=notes)
