# SPDX-License-Identifier: Apache-2.0
"""Nomenclature: symbol, REXS id, units, meaning and source of every quantity.

Axis labels, dataset attributes and the documentation are generated from `nomenclature.csv`, so that a
quantity is defined once. Result channels are looked up without the element name in brackets.
"""

from __future__ import annotations

import csv
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from pitchpoint.core.errors import PitchpointError

_PARTS = {
    "beam_force": {"mx": "beam_moment", "my": "beam_moment", "mz": "beam_moment"},
    "displacement": {"rx": "tilt", "ry": "tilt", "rz": "angle"},
    "bearing_force": {
        "mx": "bearing_moment",
        "my": "bearing_moment",
        "mz": "bearing_moment",
        "direction": "bearing_direction",
    },
    "coupling_force": {"mx": "coupling_moment", "my": "coupling_moment", "mz": "coupling_moment"},
    "bushing_force": {"mx": "bushing_moment", "my": "bushing_moment", "mz": "bushing_moment"},
}


class Entry(NamedTuple):
    """Row of the table; texts may be empty.

    `values` is "states" for a quantity with a few whole numbers as values, "modulo" for one that starts again
    after a period, and empty otherwise. A filter would create values that the first two do not have.
    """

    identifier: str
    symbol: str
    rexs: str
    unit: str
    dimension: str
    display: str
    meaning: str
    source: str
    values: str = ""


@lru_cache(maxsize=1)
def table() -> dict[str, Entry]:
    """All rows by identifier, in the order of the file."""
    with Path(__file__).with_name("nomenclature.csv").open(encoding="utf-8", newline="") as file:
        rows = [Entry(**row) for row in csv.DictReader(file, restval="")]
    return {row.identifier: row for row in rows}


def lookup(name: str) -> Entry:
    """Row of an identifier or of a result channel.

    Parameters
    ----------
    name
        Identifier such as "eps_alpha", or channel such as "mesh_force[stage]" or "bearing_force[front.mx]".

    Raises
    ------
    PitchpointError
        If the table has no such row.

    Examples
    --------
    >>> lookup("mesh_force[stage]").unit, lookup("bearing_force[front.mx]").unit
    ('N', 'N m')
    """
    base, _, rest = name.partition("[")
    part = rest.rstrip("]").rpartition(".")[2]
    key = _PARTS.get(base, {}).get(part, base)
    try:
        return table()[key]
    except KeyError:
        raise PitchpointError(f"the nomenclature has no row for {name!r}") from None


def label(name: str) -> str:
    """Label of an axis or table column: meaning and symbol.

    Parameters
    ----------
    name
        Identifier or result channel.

    Examples
    --------
    >>> label("eps_alpha")
    'transverse contact ratio ε_α'
    """
    row = lookup(name)
    short = row.meaning.split(";")[0].split(":")[0]
    return f"{short} {row.symbol}".rstrip()


def unit(name: str) -> str:
    """SI unit of an identifier or result channel; "1" if dimensionless.

    Parameters
    ----------
    name
        Identifier or result channel.

    Examples
    --------
    >>> unit("c_prime")
    'N/m^2'
    """
    return lookup(name).unit


def symbol(name: str) -> str:
    """Symbol of an identifier or result channel; empty if the table has none.

    Parameters
    ----------
    name
        Identifier or result channel.

    Examples
    --------
    >>> symbol("transmission_error[stage]"), symbol("no_such_channel")
    ('u_bt', '')
    """
    try:
        return lookup(name).symbol
    except PitchpointError:
        return ""


def can_be_filtered(name: str) -> bool:
    """Whether a low-pass filter may be applied to a result channel; also True for names without a row.

    Parameters
    ----------
    name
        Result channel.

    Examples
    --------
    >>> [can_be_filtered(f"{c}[stage]") for c in ("mesh_force", "contact_state", "mesh_phase")]
    [True, False, False]
    """
    try:
        return not lookup(name).values
    except PitchpointError:
        return True


def attributes(name: str) -> dict[str, str]:
    """Attributes of a variable in a dataset: units, long_name, symbol.

    Parameters
    ----------
    name
        Identifier or result channel.

    Examples
    --------
    >>> attributes("deflection[stage]")["units"]
    'm'
    """
    row = lookup(name)
    return {"units": row.unit, "long_name": row.meaning, "symbol": row.symbol}


def markdown_table() -> str:
    """Nomenclature as a Markdown table, for the documentation."""
    heads = ("identifier", "symbol", "REXS id", "SI unit", "shown in", "meaning", "source")
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    for row in table().values():
        cells = (f"`{row.identifier}`", row.symbol, row.rexs, row.unit, row.display, row.meaning, row.source)
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"
