# SPDX-License-Identifier: Apache-2.0
"""Properties of a beam over its length, from its lists or from its file."""

from __future__ import annotations

import functools
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.components.beam import FILES
from pitchpoint.model.files import at_key, states
from pitchpoint.model.openfast.beamdyn import read_beamdyn
from pitchpoint.model.openfast.elastodyn import elastodyn_part, read_elastodyn
from pitchpoint.model.windio.beam import read_windio_beam

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import BeamProperties


def beam_table_of(given: BeamProperties) -> BeamTable | SectionTable:
    """Table of a beam.

    Parameters
    ----------
    given
        Lists, section matrices or a file; lists next to a file of ElastoDyn replace or complete its columns.

    Raises
    ------
    ModelError
        With every problem, at the key.
    """
    key = next((name for name in FILES if getattr(given, name) is not None), None)
    if key is None and given.stiffness:
        return SectionTable(**given.lists)  # type: ignore[arg-type]
    if key is None:
        return BeamTable(**given.lists)  # type: ignore[arg-type]
    path = str(getattr(given, key))
    try:
        table = _contents(key, path, given.component or "", states((path, *given.further_files)))
    except ModelError as error:
        raise at_key(error, key) from None
    if isinstance(table, SectionTable):
        return table
    own: dict[str, Any] = {
        name: np.interp(table.position, given.position, values)
        for name, values in given.lists.items()
        if name != "position"
    }
    return replace(table, **own)


def part_in_file(given: BeamProperties) -> str:
    """Part of a turbine that the file of a beam describes, "blade" or "tower"; "" for lists.

    Parameters
    ----------
    given
        Lists or a file.
    """
    if given.elastodyn is not None:
        return elastodyn_part(given.elastodyn)
    return "blade" if given.beamdyn is not None else given.component or ""


@functools.lru_cache(maxsize=16)
def _contents(key: str, path: str, component: str, state: object) -> BeamTable | SectionTable:
    """Table of a file; the state of its files makes the cache read them again."""
    if key == "elastodyn":
        return read_elastodyn(path)
    return read_beamdyn(path) if key == "beamdyn" else read_windio_beam(path, component)
