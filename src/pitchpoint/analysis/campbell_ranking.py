# SPDX-License-Identifier: Apache-2.0
"""Critical speeds of a Campbell diagram by rank, with their sidebands; unstable modes; selection of modes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.analysis.sampled import SignalError

if TYPE_CHECKING:
    import xarray as xr

SIDEBAND = "sideband"
"""Kind of the orders that are listed with their mesh order."""
LEAST = 1e-3
"""Least participation of a listed critical speed whose response is below `LARGE`."""
LARGE = 1.0
"""Response of the machine from which a critical speed is listed: the vibration exceeds its excitation."""
MOVES = 0.01
"""Least relative change of a critical speed per relative change of a stiffness or mass that is listed."""
STEP = 0.1
"""Relative change of stiffness or mass for which outputs state the change of the critical speed."""
NO_CRITICAL_SPEED = f"none with a response of {LARGE:g} or a participation of {100.0 * LEAST:g} %"
"""What an empty list means, for outputs."""


@dataclass(frozen=True)
class RankedSpeed:
    """One line of the table of critical speeds.

    Attributes
    ----------
    index
        Index of the crossing in the dataset.
    speed, frequency
        Critical speed [rad/s] and natural frequency [Hz].
    damping_ratio
        Damping ratio of the mode at this speed.
    mode, order, whirl, source
        Name of the mode and of the order, whirl, what drives the mode.
    participation, amplification
        Share of the energy where the order acts, and amplification at resonance there.
    response
        Response of the machine at resonance, by which the lines are ranked; in files without it the
        amplification.
    separation
        Distance from the operating speed over its nearest end; NaN without operating speed.
    sidebands
        Lowest and highest speed at which sidebands of the mesh order cross the mode [rad/s]; NaN if none do.
    moved_by
        What moves the critical speed most: `stiffness of mesh stage`, `mass of rotor` (with its moments of
        inertia), and the relative change of the speed per relative change of it; the largest first. Empty in
        files without it.
    """

    index: int
    speed: float
    frequency: float
    damping_ratio: float
    mode: str
    order: str
    whirl: str
    source: str
    participation: float
    amplification: float
    response: float
    separation: float
    sidebands: tuple[float, float]
    moved_by: tuple[tuple[str, float], ...] = ()


def ranked_speeds(diagram: xr.Dataset, least: float = LEAST) -> tuple[RankedSpeed, ...]:
    """Critical speeds in order of rank; the crossings of sidebands with a mode are part of their mesh order.

    Parameters
    ----------
    diagram
        Dataset of `solve_campbell`.
    least
        Least participation of a listed crossing [-]; those with a response of at least `LARGE` are listed in
        any case.

    Raises
    ------
    SignalError
        If the dataset is not a Campbell diagram.
    """
    if "crossing_speed" not in diagram:
        raise SignalError("diagram: has no crossing_speed; give a dataset of solve_campbell")
    kinds = dict(zip(_texts(diagram, "excitation"), _texts(diagram, "excitation_kind"), strict=True))
    orders, modes = _texts(diagram, "crossing_order"), diagram["crossing_mode"].values.astype(int)
    speeds = diagram["crossing_speed"].values
    names = dict(zip(diagram["mode"].values.tolist(), _texts(diagram, "name"), strict=True))
    apart = (
        diagram["crossing_separation"].values
        if "crossing_separation" in diagram
        else np.full(len(speeds), np.nan)
    )
    ranks = "crossing_response" if "crossing_response" in diagram else "crossing_amplification"
    response = diagram[ranks].values
    bands_of: dict[tuple[str, int], list[float]] = {}
    whole = {(order, int(mode)) for order, mode in zip(orders, modes, strict=True)}
    listed = []
    for k, (order, mode) in enumerate(zip(orders, modes, strict=True)):
        base = _mesh_of(order) if kinds.get(order) == SIDEBAND else ""
        if base and (base, int(mode)) in whole:
            bands_of.setdefault((base, int(mode)), []).append(float(speeds[k]))
        elif float(diagram["crossing_participation"].values[k]) >= least or response[k] >= LARGE:
            listed.append(k)
    words = {name: _texts(diagram, f"crossing_{name}") for name in ("whirl", "source")}
    found = []
    for k in listed:
        bands = bands_of.get((orders[k], int(modes[k])), [])
        found.append(
            RankedSpeed(
                index=k,
                speed=float(speeds[k]),
                frequency=float(diagram["crossing_frequency"].values[k]),
                damping_ratio=float(diagram["crossing_damping_ratio"].values[k]),
                mode=names.get(int(modes[k]), ""),
                order=orders[k],
                whirl=words["whirl"][k],
                source=words["source"][k],
                participation=float(diagram["crossing_participation"].values[k]),
                amplification=float(diagram["crossing_amplification"].values[k]),
                response=float(response[k]),
                separation=float(apart[k]),
                sidebands=(min(bands), max(bands)) if bands else (np.nan, np.nan),
                moved_by=_moved_by(diagram, k),
            )
        )
    return tuple(found)


def _moved_by(diagram: xr.Dataset, k: int) -> tuple[tuple[str, float], ...]:
    """Components and parts whose stiffness or mass moves crossing k, the largest change first."""
    found = []
    for words, name, over in (
        ("stiffness of", "crossing_stiffness_sensitivity", "component"),
        ("mass of", "crossing_inertia_sensitivity", "part"),
    ):
        if name in diagram:
            values = zip(_texts(diagram, over), diagram[name].values[k].tolist(), strict=True)
            found += [(f"{words} {label}", value) for label, value in values if abs(value) >= MOVES]
    return tuple(sorted(found, key=lambda each: -abs(round(each[1], 8))))  # equal ones as in the model


@dataclass(frozen=True)
class UnstableRange:
    """Range of speeds in which a mode grows without excitation.

    Attributes
    ----------
    mode
        Name of the mode.
    low, high
        Ends of the range [rad/s].
    damping_ratio
        Lowest damping ratio in it.
    source
        Component that feeds energy into the mode; "" if it diverges without oscillating.
    """

    mode: str
    low: float
    high: float
    damping_ratio: float
    source: str


def unstable_ranges(diagram: xr.Dataset) -> tuple[UnstableRange, ...]:
    """Unstable modes of a diagram, lowest damping first.

    Parameters
    ----------
    diagram
        Dataset of `solve_campbell`; files of versions without this result have none.
    """
    if "unstable_mode" not in diagram:
        return ()
    names = dict(zip(diagram["mode"].values.tolist(), _texts(diagram, "name"), strict=True))
    keys = ("mode", "from", "to", "damping_ratio")
    columns = [diagram[f"unstable_{key}"].values.tolist() for key in keys]
    rows = zip(*columns, _texts(diagram, "unstable_source"), strict=True)
    return tuple(UnstableRange(names[int(mode)], *more) for mode, *more in rows)


def select_modes(
    diagram: xr.Dataset,
    modes: Sequence[int] | str | None = None,
    frequency: tuple[float, float] | None = None,
) -> xr.Dataset:
    """Diagram with some of its modes and their crossings.

    Parameters
    ----------
    diagram
        Dataset of `solve_campbell`.
    modes
        Numbers of the modes, or a part of their names, in upper or lower case.
    frequency
        Range [Hz]; modes that never enter it are omitted, as are crossings outside.

    Raises
    ------
    SignalError
        If no mode is left.
    """
    names, f = _texts(diagram, "name"), diagram["frequency"].values
    numbers = diagram["mode"].values
    keep = np.ones(len(names), bool)
    if isinstance(modes, str):
        keep &= np.array([modes.lower() in name.lower() for name in names], bool)
    elif modes is not None:
        keep &= np.isin(numbers, list(modes))
    if frequency is not None:
        keep &= ((f >= frequency[0]) & (f <= frequency[1])).any(axis=0)
    if len(names) and not keep.any():
        raise SignalError(
            f"modes: {modes!r} selects none of {len(names)} modes, such as {', '.join(names[:8])}"
        )
    chosen = diagram.isel(mode=np.flatnonzero(keep))
    inside = np.isin(diagram["crossing_mode"].values, numbers[keep])
    if frequency is not None:
        at = diagram["crossing_frequency"].values
        inside &= (at >= frequency[0]) & (at <= frequency[1])
    chosen = chosen.isel(crossing=np.flatnonzero(inside))
    if "unstable_mode" in chosen:
        chosen = chosen.isel(unstable=np.flatnonzero(np.isin(diagram["unstable_mode"].values, numbers[keep])))
    return chosen


def _mesh_of(order: str) -> str:
    """Mesh order of a sideband.

    Examples
    --------
    >>> _mesh_of("2× mesh stage − 1× rotor"), _mesh_of("mesh a + 2× b")
    ('2× mesh stage', 'mesh a')
    """
    for sign in (" − ", " + "):
        head, found, _ = order.partition(sign)
        if found:
            return head
    return order


def _texts(diagram: xr.Dataset, name: str) -> list[str]:
    """Values of a text variable; text read from files may be bytes."""
    return [x.decode() if isinstance(x, bytes) else str(x) for x in diagram[name].values.tolist()]
