# SPDX-License-Identifier: Apache-2.0
"""Channels of a result as arrays over bearing, mesh, body and component, without a copy of the samples."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import PitchpointError
from pitchpoint.core.nearest import hint
from pitchpoint.core.nomenclature import table

if TYPE_CHECKING:
    import xarray as xr

OF_ELEMENT = {
    "body": "angle speed displacement attitude strain_energy",
    "bearing": "bearing_force cage_angle",
    "mesh": "transmission_error deflection mesh_force mesh_stiffness mesh_phase contact_state backlash "
    "normal_force circumferential_force radial_force axial_force radial_force_1 axial_force_1 "
    "front_impacts back_impacts impact_rate contact_frequency closing_speed_mean closing_speed_rms "
    "closing_speed_max impulse_mean impulse_max front_contact_share back_contact_share both_flanks_share "
    "contact_loss_share longest_loss shortest_contact resolution rattle_index "
    "load_reversal peak_force_ratio flank_changes_per_revolution impact_energy_per_revolution "
    "pair_force penetration friction_torque_1 friction_torque_2 friction_power damping_power "
    "parametric_power elastic_energy",
    "load": "torque force",
    "coupling": "coupling_force twist slip_speed",
    "bushing": "bushing_force",
    "beam_end": "beam_force",
    "joint": "reaction_force reaction_moment friction_torque",
    "spring": "tension elongation",
    "contact": "contact_force friction_force gap contact_power_loss contact_location contact_path",
    "signal": "signal",
}
"""Quantities by the dimension of their elements; the dimension of all others is `element`."""
_DIMENSION = {quantity: name for name, words in OF_ELEMENT.items() for quantity in words.split()}
_WORDS = r"[fmr]?[xyz]|w|z[xy]|[ij]|radial|direction|axial|eta\d+"
SECOND = {
    "pair_force": ("tooth_pair", re.compile(r"(.+)\.(\d+)")),
    **dict.fromkeys(
        "displacement attitude bearing_force coupling_force bushing_force beam_force reaction_force "
        "reaction_moment contact_location contact_path".split(),
        ("component", re.compile(rf"(.+?)\.({_WORDS})")),
    ),
}
"""Quantities with a second dimension, and the form of element and component in their names."""


class Quantities(Mapping[str, Any]):
    """Arrays of a result by quantity, also as attributes: `found.bearing_force`.

    Each is an `xarray.DataArray` over the dimensions of the channels, the element (`bearing`, `mesh`, `body`,
    `coupling` …) and, for vectors, `component`; units are in `attrs` or, if they differ, in the coordinate
    `unit`. Samples are read when they are used; combinations without a channel are NaN.
    """

    def __init__(self, arrays: Mapping[str, xr.DataArray]) -> None:
        self._arrays = dict(arrays)

    def __getitem__(self, name: str) -> xr.DataArray:
        if name not in self._arrays:
            raise PitchpointError(f"no quantity is called {name!r}; {hint(name, list(self._arrays), 3)}")
        return self._arrays[name]

    def __getattr__(self, name: str) -> xr.DataArray:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except PitchpointError as reason:
            raise AttributeError(str(reason)) from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._arrays]

    def __repr__(self) -> str:
        """One line per quantity: its dimensions with their sizes."""
        rows = [
            f"  {name} ({', '.join(f'{dim}: {n}' for dim, n in array.sizes.items())})"
            for name, array in self._arrays.items()
        ]
        return "\n".join(["Quantities by component:", *rows])


def by_component(result: xr.Dataset) -> Quantities:
    """Channels of a result by quantity, with dimensions for elements and components.

    Parameters
    ----------
    result
        Dataset with channels named `quantity[element]` or `quantity[element.component]`, from a solver or
        from `open_result`. It remains unchanged.

    Returns
    -------
    Quantities
        For example `bearing_force` over `time`, `bearing`, `component`; `mesh_force` over `time`, `mesh`.

    Raises
    ------
    PitchpointError
        If the dataset has no such channel.

    Examples
    --------
    >>> import xarray as xr
    >>> names = ("bearing_force[left.fx]", "bearing_force[left.mx]", "bearing_force[right.fx]")
    >>> run = xr.Dataset({name: ("time", [k + 0.0, k + 0.5]) for k, name in enumerate(names)})
    >>> force = by_component(run).bearing_force
    >>> force.dims, force.sel(bearing="right", component="fx").values.tolist()
    (('time', 'bearing', 'component'), [2.0, 2.5])
    >>> force.sel(bearing="right", component="mx").values.tolist()
    [nan, nan]
    """
    groups: dict[str, dict[tuple[str, ...], xr.Variable]] = {}
    for name, variable in result.variables.items():  # arrays of a dataset with coordinates are slow to make
        quantity, bracket, rest = str(name).partition("[")
        if bracket:
            groups.setdefault(quantity, {})[_place(quantity, rest.rstrip("]"))] = variable
    if not groups:
        raise PitchpointError(
            "the dataset has no channel of an element, as in mesh_force[stage]; give a time response, a slow "
            "roll or an equilibrium"
        )
    return Quantities({quantity: _array(result, quantity, found) for quantity, found in groups.items()})


def _place(quantity: str, owner: str) -> tuple[str, ...]:
    """Element of a channel, and its component if the quantity has components."""
    if quantity not in SECOND:
        return (owner,)
    found = SECOND[quantity][1].fullmatch(owner)
    return (found[1], found[2]) if found else (owner, "")


def _array(result: xr.Dataset, quantity: str, found: Mapping[tuple[str, ...], xr.Variable]) -> xr.DataArray:
    """Array of one quantity."""
    import xarray as xr
    from xarray.core.indexing import LazilyIndexedArray

    first = next(iter(found.values()))
    kept = {place: v for place, v in found.items() if v.dims == first.dims}
    names = [list(dict.fromkeys(own)) for own in zip(*kept, strict=True)]
    over = [_DIMENSION.get(quantity, "element"), *([SECOND[quantity][0]] if len(names) > 1 else [])]
    index = {place: tuple(own.index(x) for own, x in zip(names, place, strict=True)) for place in kept}
    table_of = np.full([len(own) for own in names], -1)
    for number, place in enumerate(kept):
        table_of[index[place]] = number
    units = np.full(table_of.shape, "", dtype=object)
    for place, variable in kept.items():
        units[index[place]] = str(variable.attrs.get("units", ""))
    row = table().get(quantity)
    attrs = {"long_name": row.meaning if row else quantity.replace("_", " ")}
    coords: dict[str, Any] = dict(zip(over, names, strict=True))
    distinct = {str(unit) for unit in units[table_of >= 0]}
    if len(distinct) == 1:
        attrs["units"] = distinct.pop()
    elif len(over) > 1 and all(len({*column} - {""}) < 2 for column in units.T):
        coords["unit"] = (over[1], [max(column, key=len) for column in units.T])
    else:
        coords["unit"] = (over, units)
    coords |= {str(name): result.coords[name] for name in first.dims if name in result.coords}
    data = LazilyIndexedArray(_stacked()(list(kept.values()), table_of))
    return xr.DataArray(xr.Variable((*first.dims, *over), data), coords, name=quantity, attrs=attrs)


@functools.cache
def _stacked() -> Any:
    """Class of arrays stacked when read; created here because its base class is in xarray."""
    from xarray.backends import BackendArray
    from xarray.core import indexing

    class StackedArray(BackendArray):
        """Variables of one shape, stacked along further dimensions by a table of their numbers (-1: none)."""

        def __init__(self, variables: Sequence[xr.Variable], numbers: np.ndarray) -> None:
            self.variables, self.numbers = variables, numbers
            self.shape = (*variables[0].shape, *numbers.shape)
            kind = np.result_type(*{v.dtype for v in variables})
            self.dtype = kind if np.all(numbers >= 0) else np.result_type(kind, np.float64)

        def __getitem__(self, key: Any) -> Any:
            """Read a selection: integers, slices, index arrays of each dimension."""
            support = indexing.IndexingSupport.OUTER
            return indexing.explicit_indexing_adapter(key, self.shape, support, self._read)

        def _read(self, key: tuple[Any, ...]) -> Any:
            own = self.variables[0].ndim
            numbers = self.numbers
            for axis in range(numbers.ndim - 1, -1, -1):
                numbers = numbers[(slice(None),) * axis + (key[own + axis],)]
            parts = {int(k): self.variables[k][key[:own]].values for k in np.unique(numbers) if k >= 0}
            shape = next(iter(parts.values())).shape if parts else self.variables[0][key[:own]].shape
            size = (*shape, *np.shape(numbers))
            whole = bool(np.all(numbers >= 0))
            found = np.empty(size, self.dtype) if whole else np.full(size, np.nan, self.dtype)
            for place in np.ndindex(np.shape(numbers)):
                if (number := int(numbers[place])) >= 0:
                    found[(..., *place)] = parts[number]
            return found

    return StackedArray
