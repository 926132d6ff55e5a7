# SPDX-License-Identifier: Apache-2.0
"""Whole datasets in the result container: every variable over its own dimensions, one dataset or several."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nomenclature import symbol
from pitchpoint.core.status import OK
from pitchpoint.core.status import sentence as words_of
from pitchpoint.io.container import FINISHED, Container, Header
from pitchpoint.io.tables import Axis, Quantity, write_tables

if TYPE_CHECKING:
    import h5py
    import xarray as xr

Variable = tuple[tuple[str, ...], Any, str, str]
"""Dimensions, values, SI unit and description."""


def write_dataset(path: str | os.PathLike[str], header: Header, data: xr.Dataset, **ending: Any) -> None:
    """Write a dataset of numbers and texts to a result file; `open_result` gives the same variables.

    Complex numbers are stored as real and imaginary part, `NAME_real` and `NAME_imag`.

    Parameters
    ----------
    path
        File to write.
    header
        Provenance; attributes of the dataset that the file is to contain are among its options.
    data
        Dataset.
    **ending
        Final status, as for `write_tables`.
    """
    write_variables(path, header, _variables(data), [str(name) for name in data.coords], **ending)


def write_variables(
    path: str | os.PathLike[str],
    header: Header,
    variables: Mapping[str, Variable],
    coordinates: Sequence[str],
    **ending: Any,
) -> None:
    """Write the variables of a dataset as `write_dataset` does, without the library of datasets.

    Parameters
    ----------
    path, header, **ending
        As for `write_dataset`.
    variables
        Dimensions, values, SI unit and description by name, coordinates included.
    coordinates
        Names of the coordinates.
    """
    axes, filled = _tables_of(variables)
    sizes = {axis.name for axis in axes}
    others = [name for name in coordinates if name not in sizes]
    write_tables(path, header, axes, filled, coordinates=others, **ending)


def write_datasets(
    path: str | os.PathLike[str],
    header: Header,
    datasets: Mapping[str, xr.Dataset],
    attributes: Mapping[str, Mapping[str, str]],
    *,
    status: str = FINISHED,
    sentence: str = "",
    code: int = OK,
    notes: Sequence[str] = (),
) -> None:
    """Write several datasets of numbers to one result file, each in a group of its own.

    Parameters
    ----------
    path
        File to write.
    header
        Provenance.
    datasets
        Datasets by group, such as `meshes/stage`; `open_result` reads a group.
    attributes
        Texts by group, as attributes of its dataset.
    status, sentence, code, notes
        Final status.
    """
    begun = time.perf_counter()
    tables = {group: _tables_of(_variables(data)) for group, data in datasets.items()}
    count = sum(len(axes) + len(filled) for axes, filled in tables.values())
    size = sum(int(values.nbytes) for _, filled in tables.values() for _, values in filled)
    container = Container(path, header, count, size)
    with container.writing():
        for group, (axes, filled) in tables.items():
            container.file.require_group(group).attrs.update(attributes[group])
            scales = {axis.name: _dimension(container, group, axis) for axis in axes}
            for quantity, values in filled:
                made = container.variable(
                    quantity.name,
                    [scales[name] for name in quantity.axes],
                    group=group,
                    dtype=quantity.dtype,
                    attributes=_words(quantity),
                )
                made[...] = values
    container.begin()
    elapsed = time.perf_counter() - begun
    container.finish(status, sentence or words_of(code), code=code, wall_s=elapsed, notes=notes)


def _dimension(container: Container, group: str, axis: Axis) -> h5py.Dataset:
    """Dimension of a group with its coordinate."""
    whole = not isinstance(axis.values, int) and all(isinstance(v, int) for v in axis.values)
    return container.dimension(
        axis.name, axis.values, group=group, dtype="i8" if whole else "f8", attributes=_words(axis)
    )


def _words(part: Axis | Quantity) -> dict[str, str]:
    """Attributes of a dimension or variable."""
    return {
        "units": part.unit,
        "long_name": part.long_name,
        "symbol": part.symbol or (symbol(part.name) if isinstance(part, Quantity) else ""),
    }


def _variables(data: xr.Dataset) -> dict[str, Variable]:
    """Dimensions, values, unit and description of all variables of a dataset."""
    return {
        str(name): (
            tuple(map(str, found.dims)),
            found.values,
            str(found.attrs.get("units", "")),
            str(found.attrs.get("long_name", "")),
        )
        for name, found in data.variables.items()
    }


def _tables_of(variables: Mapping[str, Variable]) -> tuple[list[Axis], list[tuple[Quantity, Any]]]:
    """Dimensions and variables of a dataset."""
    sizes: dict[str, int] = {}
    for dims, values, _, _ in variables.values():
        sizes |= dict(zip(dims, values.shape, strict=True))
    axes = []
    for name, size in sizes.items():
        _, values, unit, words = variables.get(name, ((), None, "", ""))
        axes.append(Axis(name, size if values is None else values.tolist(), unit=unit, long_name=words))
    filled = []
    for name in (name for name in variables if name not in sizes):
        filled += _stored(name, *variables[name])
    return axes, filled


def _stored(
    name: str, dims: tuple[str, ...], values: Any, unit: str, words: str
) -> list[tuple[Quantity, Any]]:
    """Variable as stored: texts, whole numbers, numbers, or the parts of complex numbers."""
    if values.dtype.kind in "OU":
        return [(Quantity(name, dims, unit, words, dtype="text"), values.astype(object))]
    if values.dtype.kind == "c":
        return [
            (Quantity(f"{name}_{word}", dims, unit, words, part_of=name), part)
            for word, part in (("real", values.real), ("imag", values.imag))
        ]
    return [(Quantity(name, dims, unit, words, dtype="i8" if values.dtype.kind in "iu" else "f8"), values)]
