# SPDX-License-Identifier: Apache-2.0
"""Apply the analysis functions of the table in `tools` to channels of a measured or simulated dataset.

The functions themselves work on arrays and do not depend on datasets.
"""

from __future__ import annotations

import inspect
import json
import operator
from collections.abc import Mapping, Sequence
from fractions import Fraction
from numbers import Integral, Real
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.analysis.sampled import Array, SignalError, sample_rate_of
from pitchpoint.analysis.tacho import angle_channel
from pitchpoint.analysis.tool_rows import SOURCES, Output, Tool
from pitchpoint.analysis.tools import TOOLS
from pitchpoint.core.errors import join_notes, split_notes
from pitchpoint.core.nearest import did_you_mean, hint

if TYPE_CHECKING:
    import xarray as xr

KEPT = ("source_file", "format", "sha256", "title", "model_hash", "scenario", "solver", "status")
"""Attributes of a record that are copied to results."""
_WORDS = {
    "bool": "true or false",
    "float": "a number",
    "int": "a whole number",
    "str": "a text",
    "Fraction": "a fraction",
    "tuple": "two numbers",
    "Sequence": "several whole numbers",
    "ArrayLike": "one or more numbers",
}
_MAKERS = {
    "samples_per_revolution": "resample_over_angle, or use tracked_spectrum",
    "average": "synchronous_average, or name the angle of its shaft",
}


def analyse(
    dataset: xr.Dataset,
    tool: str,
    *,
    channel: str | Sequence[str] | None = None,
    angle: str | None = None,
    **options: Any,
) -> xr.Dataset:
    """Apply an analysis function to channels of a dataset.

    Parameters
    ----------
    dataset
        Record with channels over `time` [s] (or `angle` [rad]), as from `read_measured`, `open_result` and
        the solvers.
    tool
        Name in `tools.TOOLS`.
    channel
        One or several channels; default: the only one.
    angle
        Channel with the angle of the reference shaft of the orders [rad], or with its speed [rad/s], which
        is integrated over time.
    **options
        Options of the function, see there.

    Returns
    -------
    xarray.Dataset
        Fields of the result with dimensions and `units`; the first dimension of several channels is
        `channel`. Attributes: `tool`, `channel`, `angle`, `options` (JSON), and the origin of the record.

    Raises
    ------
    SignalError
        If the tool, a channel or an option does not exist, or the function cannot process the samples.

    Examples
    --------
    >>> import xarray as xr
    >>> t = np.arange(1000) / 1000.0
    >>> force = ("time", 3.0 * np.sin(2 * np.pi * 40.0 * t), {"units": "N"})
    >>> data = xr.Dataset({"force": force}, coords={"time": t})
    >>> found = analyse(data, "amplitude_spectrum", window_name="hann")
    >>> round(float(found["amplitude"].sel(frequency=40.0)), 9), found["amplitude"].units
    (3.0, 'N')
    """
    row = _row(tool)
    if hasattr(dataset, "to_dataset"):  # a single DataArray
        dataset = dataset.to_dataset(name=dataset.name or "signal")
    names = channel_names(dataset)
    one = channel if isinstance(channel, str) else None
    several = [one] if one is not None else _wanted(names, channel)
    for name in several:
        _known(name, names, "channel")
    checked = _options(tool, row, options)
    results = [_applied(dataset, tool, row, name, angle, checked) for name in several]
    remarks = join_notes(note for r in results for note in split_notes(r.attrs["notes"]))
    made = results[0] if one is not None or channel is None else _joined(results, several, tool)
    about = {key: dataset.attrs[key] for key in KEPT if key in dataset.attrs}
    shaft = {"angle": angle} if angle is not None and {"angle", "average"} & set(row.takes) else {}
    made.attrs = {
        "tool": tool,
        "channel": ", ".join(several),
        **shaft,
        "options": json.dumps(checked, default=str),
        **about,
    }
    if remarks:
        made.attrs["notes"] = remarks
    return made


def channel_names(dataset: xr.Dataset) -> list[str]:
    """Names of the channels of a record: numeric variables over `time` or `angle` only."""
    return [
        str(name)
        for name, variable in dataset.data_vars.items()
        if variable.dims in (("time",), ("angle",)) and variable.dtype.kind in "fiub"
    ]


def tool_options(tool: str) -> dict[str, inspect.Parameter]:
    """Options of a tool by name: the arguments of its function that do not come from the dataset."""
    row = _row(tool)
    return {n: p for n, p in inspect.signature(row.load()).parameters.items() if n not in row.takes}


def _row(tool: str) -> Tool:
    if tool not in TOOLS:
        guess = did_you_mean(tool, TOOLS, 2).strip() or f"there are {', '.join(TOOLS)}"
        raise SignalError(f"tool: {tool!r} is unknown; {guess}")
    return TOOLS[tool]


def _wanted(names: Sequence[str], channel: Sequence[str] | None) -> list[str]:
    if channel is None and len(names) != 1:
        listed = ", ".join(names[:12]) + (", ..." if len(names) > 12 else "")
        raise SignalError(
            f"channel: {len(names)} are in the record (limit 1); choose of {listed or 'another file'}"
        )
    if channel is not None and not len(channel):
        raise SignalError("channel: none is named (limit 1 or more); omit it or name one")
    return list(names) if channel is None else list(channel)


def _known(name: str, names: Sequence[str], what: str) -> None:
    if name not in names:
        raise SignalError(f"{what}: {name!r} is not a channel of the record; {hint(name, names, 3)}")


def _options(tool: str, row: Tool, options: Mapping[str, Any]) -> dict[str, Any]:
    """Check names and types of the options of a function, and convert them."""
    known = tool_options(tool)
    for name in options:
        if name not in known:
            raise SignalError(f"{tool}: has no option {name!r}; {hint(name, known)}")
    missing = [n for n, p in known.items() if p.default is p.empty and n not in options]
    if missing:
        raise SignalError(f"{tool}: needs the option {' and '.join(missing)}; such as {missing[0]}=100")
    return {name: _option(tool, name, str(known[name].annotation), value) for name, value in options.items()}


def _option(tool: str, name: str, kind: str, value: Any) -> Any:
    """Check and convert one option; 4.0 is accepted as a whole number."""
    kinds = {part.strip() for part in kind.split("|")}
    if value is None and "None" in kinds:
        return None
    number = isinstance(value, Real) and not isinstance(value, bool) and bool(np.isfinite(float(value)))
    if "bool" in kinds and isinstance(value, bool | np.bool_):
        return bool(value)
    if "float" in kinds and number:
        return float(value)
    if "int" in kinds and number and (isinstance(value, Integral) or float(value).is_integer()):
        return int(value)
    if "str" in kinds and isinstance(value, str):
        return value
    if "Fraction" in kinds and isinstance(value, Fraction):
        return value
    for part in kinds:
        found = _numbers(part, value)
        if found is not None:
            return found
    expected = " or ".join(words for k, words in _WORDS.items() if any(p.startswith(k) for p in kinds))
    raise SignalError(f"{tool}: option {name} is {value!r} (limit {expected}); correct it")


def _numbers(kind: str, value: Any) -> tuple[float, ...] | list[int] | list[float] | None:
    """Convert several numbers to `tuple[float, float]`, `Sequence[int]` or `ArrayLike`; None if not valid."""
    if not kind.startswith(("tuple[", "Sequence[", "ArrayLike")) or isinstance(value, str):
        return None
    try:
        items = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        return None
    if kind == "ArrayLike":
        items = np.atleast_1d(items)
    if items.ndim != 1 or not np.all(np.isfinite(items)):
        return None
    if kind == "ArrayLike":
        return [float(v) for v in items]
    if kind.startswith("tuple["):
        return tuple(map(float, items)) if items.size == kind.count(",") + 1 else None
    return [int(v) for v in items] if "int" in kind and np.array_equal(items, np.round(items)) else None


def _applied(
    dataset: xr.Dataset, tool: str, row: Tool, channel: str, angle: str | None, options: Mapping[str, Any]
) -> xr.Dataset:
    """Result of one channel as a dataset."""
    if "average" in row.takes and angle is not None and dataset[channel].dims == ("time",):
        averaged = _applied(dataset, "synchronous_average", TOOLS["synchronous_average"], channel, angle, {})
        dataset = averaged.rename(values=channel)
    function = row.load()
    try:
        given = {name: _source(dataset, name, channel, angle) for name in row.takes}
        result = function(**given, **options)
    except SignalError as error:
        raise SignalError(f"{tool} of {channel}: {error}") from error
    unit = "" if options.get("whiten") is True else str(dataset[channel].attrs.get("units", ""))
    return _dataset_of(result, row, dataset[channel], unit, squared=options.get("squared") is True)


def _source(dataset: xr.Dataset, name: str, channel: str, angle: str | None) -> Any:
    """Value of an argument of a function that comes from the dataset."""
    assert name in SOURCES
    variable = dataset[channel]
    if name == "values":
        return np.asarray(variable.values, dtype=np.float64)
    axis = np.asarray(dataset[variable.dims[0]].values, dtype=np.float64)
    if axis.size < 2:
        raise SignalError(f"{variable.dims[0]}: {axis.size} samples (limit 2 or more); use a longer record")
    if name in ("samples_per_revolution", "average"):
        if variable.dims != ("angle",):
            raise SignalError(f"is over time, not over an angle; create it with {_MAKERS[name]}")
        if name == "average":
            return np.asarray(variable.values, dtype=np.float64)
        return 2.0 * np.pi * sample_rate_of(np.sign(axis[-1] - axis[0]) * axis)
    if variable.dims != ("time",):
        raise SignalError("is over an angle, not over time; use a tool for signals over an angle")
    if name == "angle":
        return _angle(dataset, axis, angle)
    if name == "sample_rate":
        return sample_rate_of(axis)
    return axis if name == "time" else float(axis[0])


def _angle(dataset: xr.Dataset, time: Array, name: str | None) -> Array:
    """Angle of a shaft [rad] at the samples of the record."""
    names = [n for n in channel_names(dataset) if dataset[n].dims == ("time",)]
    turning = [n for n in names if dataset[n].attrs.get("units") in ("rad", "rad/s")]
    if name is None:
        listed = ", ".join(turning[:12]) or "none; give units= when the file is read"
        raise SignalError(f"angle: is not named; channels in rad or rad/s are: {listed}")
    _known(name, names, "angle")
    values, unit = np.asarray(dataset[name].values, dtype=np.float64), dataset[name].attrs.get("units", "")
    if unit == "rad":
        return angle_channel(values, time).angle
    if unit == "rad/s":
        steps = 0.5 * (values[1:] + values[:-1]) * np.diff(time)
        return np.concatenate(([0.0], np.cumsum(steps)))
    raise SignalError(f"angle: {name} is in {unit or 'no unit'} (limit rad or rad/s); state its unit")


def _dataset_of(result: Any, row: Tool, channel: xr.DataArray, unit: str, *, squared: bool) -> xr.Dataset:
    """Dataset of a result; coordinates come from the fields with dimension names, or from the channel."""
    import xarray as xr

    variables: dict[str, Any] = {}
    for output in row.outputs:
        value = operator.attrgetter(output.field)(result)
        if value is None:
            continue
        attributes = {"units": _unit(output, unit, squared), "long_name": output.variable.replace("_", " ")}
        variables[output.variable] = (tuple(output.dims.split()), np.asarray(value), attributes)
    dims = {d for output in row.outputs for d in output.dims.split()}
    coords = {name: variables.pop(name) for name in [n for n in variables if n in dims]}
    for dim in (dims - set(coords)) & set(channel.coords):
        words = {"units": {"time": "s", "angle": "rad"}.get(dim, ""), "long_name": dim}
        coords[dim] = (dim, channel[dim].values, words)
    return xr.Dataset(variables, coords=coords, attrs={"notes": join_notes(getattr(result, "notes", ()))})


def _unit(output: Output, unit: str, squared: bool) -> str:
    """Unit of a field, with the unit of the channel inserted."""
    own = square = unit or "1"
    if own != "1":
        square = f"({unit})^2" if any(sign in unit for sign in " /^") else f"{unit}^2"
    text = output.unit
    for mark, put in {"{squared}": square if squared else own, "{u2}": square, "{u}": own}.items():
        text = text.replace(mark, put)
    return text


def _joined(results: Sequence[xr.Dataset], names: Sequence[str], tool: str) -> xr.Dataset:
    """Results of several channels along the new dimension `channel`; their axes must be equal."""
    import xarray as xr

    first = results[0]
    for name, other in zip(names, results, strict=True):
        if (
            any(not np.array_equal(first[d].values, other[d].values) for d in first.coords)
            or first.sizes != other.sizes
        ):
            raise SignalError(
                f"{tool}: the axes of {name} differ from those of {names[0]}; analyse them separately"
            )
    units = {v: {str(r[v].attrs["units"]) for r in results} for v in first.data_vars}
    mixed = [str(v) for v, found in units.items() if len(found) > 1]
    if mixed:
        raise SignalError(f"{tool}: channels have different units ({mixed[0]}); analyse them separately")
    return xr.concat(list(results), dim=xr.Variable("channel", list(names)), combine_attrs="override")
