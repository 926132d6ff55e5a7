# SPDX-License-Identifier: Apache-2.0
"""Results of an analysis as CSV: comment lines with provenance and single numbers, then a table."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.io.csv_cells import plain_cell
from pitchpoint.io.target import ANALYSIS_MARK

if TYPE_CHECKING:
    import xarray as xr


_MAX_LISTED = 200


def table_text(result: xr.Dataset) -> str:
    """Text of the CSV file: columns `name [unit]`; maps have a row for each point.

    Parameters
    ----------
    result
        Result of `analysis.dataset.analyse`.
    """
    lines = [ANALYSIS_MARK.rstrip("\n")]
    lines += [
        f"# {key}: {' '.join(str(value).split())}" for key, value in result.attrs.items() if value != ""
    ]
    single = [name for name, v in result.data_vars.items() if not v.dims]
    lines += [f"# {_head(result, name)}: {result[name].item()!r}" for name in single]
    grids = dict.fromkeys(v.dims for v in result.data_vars.values() if v.dims)
    # one grid per file, so that readers can parse it: the finest one with all its variables
    for dims in sorted(grids, key=lambda dims: math.prod(result.sizes[dim] for dim in dims))[-1:]:
        names = [name for name, v in result.data_vars.items() if v.dims and set(v.dims) <= set(dims)]
        for name, v in result.data_vars.items():
            if v.dims and name not in names:
                values = v.values.tolist() if v.size <= _MAX_LISTED else "not in this table"
                lines.append(f"# {_head(result, name)} over {', '.join(map(str, v.dims))}: {values}")
        heads = [str(dim) if dim not in result.coords else _head(result, dim) for dim in dims]
        lines.append(",".join(_quoted(head) for head in (*heads, *(_head(result, name) for name in names))))
        shape = tuple(result.sizes[dim] for dim in dims)
        axes = np.meshgrid(*(_coordinate(result, dim) for dim in dims), indexing="ij")
        sizes = dict(zip(dims, shape, strict=True))
        columns = [axis.ravel() for axis in axes]
        for name in names:
            wide = result[name].expand_dims({d: n for d, n in sizes.items() if d not in result[name].dims})
            columns.append(wide.transpose(*dims).values.ravel())
        lines += [",".join(_cell(value) for value in row) for row in zip(*columns, strict=True)]
    return "\n".join(lines) + "\n"


def _coordinate(result: xr.Dataset, dim: object) -> np.ndarray:
    return np.asarray(result[dim].values) if dim in result.coords else np.arange(result.sizes[dim])


def _head(result: xr.Dataset, name: object) -> str:
    unit = result[name].attrs.get("units", "")
    words = f"{name} [{unit}]" if unit else str(name)
    return " ".join(words.split())


def _quoted(text: str) -> str:
    text = str(plain_cell(text))
    if set(text) & set(',"\r\n'):
        text = text.replace('"', '""')
        return f'"{text}"'
    return text


def _cell(value: object) -> str:
    return repr(value.item()) if isinstance(value, np.number) else _quoted(str(value))
