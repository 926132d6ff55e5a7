# SPDX-License-Identifier: Apache-2.0
"""Result file as a lazy `xarray.Dataset`: samples are read on access.

Deep and pickled copies of a dataset open the file again when they are read, so that they outlive the original
and reach other processes.

General netCDF readers query the length of a growing dimension from all variables, for each variable again: a
minute for 168 channels. Here one table of lengths is used for all variables.
"""

from __future__ import annotations

import functools
import os
import weakref
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.io.container import ResultError
from pitchpoint.io.opening import Dimensions, damaged, member, members, open_file
from pitchpoint.io.unmarked_file import DAMAGE

if TYPE_CHECKING:
    import h5py
    import xarray as xr

_OF_NETCDF = {"CLASS", "NAME", "REFERENCE_LIST", "DIMENSION_LIST", "DIMENSION_LABELS", "_Netcdf4Dimid"}
IDENTITY = ("created", "kind", "model_hash", "scenario", "options")
"""Attributes that together identify a result; they do not change while it is written."""
_BARE = b"This is a netCDF dimension but not a netCDF variable"


class ReopenedFile:
    """Result file that is opened again when it is closed, and only if it still has the same result.

    Parameters
    ----------
    path
        Absolute path of the file.
    identity
        Identifies the result, see `_identity`.
    file
        The open file, if any.
    """

    def __init__(self, path: str, identity: tuple[str, ...], file: h5py.File | None = None) -> None:
        self.path, self.identity, self._file = path, identity, file

    @classmethod
    def of(cls, path: str, file: h5py.File) -> ReopenedFile:
        """Handle of an open file."""
        return cls(os.path.abspath(path), _identity(file), file)

    def __reduce__(self) -> tuple[Any, ...]:
        return _shared, (self.path, self.identity)

    def close(self) -> None:
        """Close the file; reading opens it again."""
        if self._file:
            self._file.close()

    def item(self, name: str) -> h5py.Dataset:
        """Array of the file.

        Raises
        ------
        ResultError
            If the file cannot be opened, or has another result.
        """
        if not self._file:  # a closed file is false
            file = open_file(self.path)
            if _identity(file) != self.identity:
                file.close()
                raise ResultError(f"{self.path}: was written again since it was opened; open it once more")
            self._file = file
        group, _, last = name.rpartition("/")
        return member(self._file[group or "/"], last)


_COPIES: weakref.WeakValueDictionary[tuple[str, tuple[str, ...]], ReopenedFile] = (
    weakref.WeakValueDictionary()
)
"""Files of copied datasets: the variables of a dataset share one."""


def _shared(path: str, identity: tuple[str, ...]) -> ReopenedFile:
    """File of copies, opened when they are read."""
    return _COPIES.setdefault((path, identity), ReopenedFile(path, identity))


def _identity(file: h5py.File) -> tuple[str, ...]:
    """Values of `IDENTITY` in a file."""
    return tuple(str(file.attrs.get(key, "")) for key in IDENTITY)


def lazy_dataset(path: str | os.PathLike[str], file: h5py.File, group: str | None = None) -> xr.Dataset:
    """Variables of an open result file over their dimensions, without reading samples.

    Parameters
    ----------
    path
        Name of the file, for errors.
    file
        Open file; if it is closed, the dataset opens it again to read samples.
    group
        Group to read; None for the signals or tables.
    """
    import h5py
    import xarray as xr
    from xarray.core.indexing import LazilyIndexedArray

    name = os.fspath(path)
    where = member(file, group) if group else file
    handle = ReopenedFile.of(name, file)
    arrays = {key: item for key, item in members(where).items() if isinstance(item, h5py.Dataset)}
    dimensions = Dimensions(file)
    over = {key: dimensions.of(item) for key, item in arrays.items()}
    lengths = _lengths(arrays, over)
    variables = {}
    # read the status before the values: a growing file must not give a status without values
    for key, item in sorted(arrays.items(), key=lambda pair: not pair[0].endswith("_status")):
        if item.attrs.get("NAME", b"").startswith(_BARE):
            continue
        dims = over[key]
        shape = tuple(lengths[dim] for dim in dims)
        data = LazilyIndexedArray(_stored_array()(handle, str(item.name), item.dtype, shape))
        variable = xr.Variable(dims, data, _attributes(item.attrs))
        if data.dtype.kind == "O":
            variable.encoding["dtype"] = str
        if item.chunks:
            variable.encoding["preferred_chunks"] = dict(zip(dims, item.chunks, strict=True))
        variables[key] = variable
    variables |= _complex(variables)
    coords = {key: v for key, v in variables.items() if v.dims == (key,)}
    plain = {key: v for key, v in variables.items() if key not in coords}
    dataset = xr.decode_cf(xr.Dataset(plain, coords, _attributes(where.attrs)), decode_times=False)
    dataset.set_close(handle.close)
    return dataset


def _complex(variables: dict[str, xr.Variable]) -> dict[str, xr.Variable]:
    """Complex variables from their real and imaginary parts, which are removed."""
    import xarray as xr

    found = {}
    for key in [key for key, v in variables.items() if v.attrs.get("part_of") and key.endswith("_real")]:
        real, name = variables[key], str(variables[key].attrs["part_of"])
        if f"{name}_imag" not in variables:
            raise ValueError(f"the imaginary part of {name} is missing")
        imag = variables.pop(f"{name}_imag")
        attrs = {word: text for word, text in variables.pop(key).attrs.items() if word != "part_of"}
        found[name] = xr.Variable(real.dims, real.values + 1j * imag.values, attrs)
    return found


@functools.cache
def _stored_array() -> Any:
    """Class of lazily read samples; created here because its base class is in xarray."""
    from xarray.backends import BackendArray
    from xarray.core import indexing

    class StoredArray(BackendArray):
        """Samples of one array of a file, up to the common length of all channels."""

        def __init__(
            self, file: ReopenedFile, name: str, stored: np.dtype[Any], shape: tuple[int, ...]
        ) -> None:
            self.file, self.name, self.stored, self.shape = file, name, stored, shape
            # xarray marks variable-length texts by this dtype
            self.dtype = np.dtype("O", metadata={"element_type": str}) if stored.kind == "O" else stored

        def __reduce__(self) -> tuple[Any, ...]:
            return _restored, (self.file, self.name, self.stored, self.shape)

        def __getitem__(self, key: Any) -> Any:
            """Read a selection: integers, slices, and one index array."""
            support = indexing.IndexingSupport.OUTER_1VECTOR
            return indexing.explicit_indexing_adapter(key, self.shape, support, self._read)

        def _read(self, key: tuple[Any, ...]) -> Any:
            within = tuple(
                slice(*k.indices(n)) if isinstance(k, slice) else k
                for k, n in zip(key, self.shape, strict=True)
            )
            try:
                stored = self.file.item(self.name)
                samples = (stored.asstr() if self.dtype.kind == "O" else stored)[within]
                if self.dtype.kind == "S":  # xarray decodes it later, where the name of the file is unknown
                    samples.tobytes().decode()
                return samples
            except DAMAGE as error:
                raise damaged(self.file.path, error) from error

    return StoredArray


def _restored(file: ReopenedFile, name: str, stored: np.dtype[Any], shape: tuple[int, ...]) -> Any:
    """Copy of lazily read samples."""
    return _stored_array()(file, name, stored, shape)


def _lengths(arrays: Mapping[str, h5py.Dataset], over: Mapping[str, tuple[str, ...]]) -> dict[str, int]:
    """Length of every dimension; for a growing one the minimum over all channels."""
    found = {key: arrays[key].shape[0] for key, dims in over.items() if dims == (key,)}
    for key, item in arrays.items():
        for dim, length, limit in zip(over[key], item.shape, item.maxshape, strict=True):
            if limit is None:
                found[dim] = min(found[dim], length)
    return found


def _attributes(stored: Mapping[str, Any]) -> dict[str, Any]:
    """Attributes without those for netCDF dimensions; texts as str, single numbers as scalars."""
    found: dict[str, Any] = {}
    for key, value in stored.items():
        if key in _OF_NETCDF:
            continue
        if isinstance(value, bytes):
            value = value.decode("utf-8", "replace")
        elif isinstance(value, np.ndarray) and value.size == 1:
            value = value.reshape(-1)[0]
        found[key] = value
    return found
