# SPDX-License-Identifier: Apache-2.0
"""Checks of files of turbulence: contents, and that they contain the rotors in all scenarios."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.model.files import read_once
from pitchpoint.model.frames import axes_of, place_of
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rotor_input import rotor_input
from pitchpoint.model.wind.box import BoxExtent
from pitchpoint.model.wind.file_errors import WindFileError
from pitchpoint.model.wind.turbsim import turbsim_extent

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.model import Model
    from pitchpoint.model.parts import Parts

_CLOSE = 1e-6
"""Relative tolerance of the edges of a box."""
_ROUND = 5.0
"""Step of the width in a remedy [m]."""
_MARGIN = 1.02
"""Room for the deflection of the blades in a remedy."""


def check_wind_boxes(parts: Parts, report: Reader) -> None:
    """Check the files of all winds, then each wind of a rotor against its blades and scenarios."""
    extents = {}
    for name, wind in parts.winds.items():
        at = ("winds", name, "box")
        if wind.box is None or at in report.tainted:
            continue
        try:
            extents[name] = box_extent(wind.box)
        except WindFileError as error:
            report.problem(at, str(error))
    for name, rotor in parts.wind_rotors.items() if extents else ():
        if ("wind_rotors", name) in report.tainted:
            continue
        reach = rotor_reach(parts, rotor)
        for wind in dict.fromkeys(_winds(parts, rotor)):
            if reach is not None and wind in extents:
                file = Path(str(parts.winds[wind].box)).name
                at = ("winds", wind, "box")
                hub = float(place_of(parts, rotor.hub)[2])  # type: ignore[index]
                _space(extents[wind], reach, hub, f"{file}, not the whole of wind_rotors.{name}", at, report)
                _time(parts, rotor, wind, reach[0], report, extents[wind])


@read_once(16)
def box_extent(path: str) -> BoxExtent:
    """Space and time of a file, read once.

    Parameters
    ----------
    path
        The file.
    """
    return turbsim_extent(path)


def winds_of_scenario(parts: Parts | Model, rotor: WindRotor) -> Iterator[tuple[str, str]]:
    """Every scenario with its wind at a rotor."""
    for name, scenario in parts.scenarios.items():
        wind = scenario.wind or rotor.wind or next(iter(parts.winds), None)
        if wind is not None:
            yield name, wind


def _winds(parts: Parts, rotor: WindRotor) -> Iterator[str]:
    """Winds at a rotor: its own, and those of the scenarios."""
    if rotor.wind is not None:
        yield rotor.wind
    yield from (wind for _, wind in winds_of_scenario(parts, rotor))


def rotor_reach(parts: Parts | Model, rotor: WindRotor) -> NDArray[np.float64] | None:
    """Lowest and highest x, y and z of the rigid turning blades, shape (3, 2) [m]; None if unknown.

    Parameters
    ----------
    parts, rotor
        Parts of the model, and the rotor.
    """
    try:
        shape = rotor_input(rotor).rotor
    except ModelError:
        return None  # reported already
    centre = place_of(parts, rotor.hub)
    if centre is None:
        return None
    axis = axes_of(parts, rotor.hub)[:, 2]
    middle = centre[:, None] + np.outer(axis, shape.axial)
    swept = np.outer(np.sqrt(np.maximum(1.0 - axis**2, 0.0)), shape.radius)
    return np.stack([(middle - swept).min(axis=1), (middle + swept).max(axis=1)], axis=1)


def _space(
    extent: BoxExtent, reach: NDArray[np.float64], hub: float, what: str, at: Place, report: Reader
) -> None:
    """Check width and height."""
    (left, right), top = reach[1], float(reach[2, 1])
    side = max(-float(left), float(right))
    if side <= extent.half_width * (1.0 + _CLOSE) and top <= extent.top * (1.0 + _CLOSE):
        return
    width = _ROUND * math.ceil(2.0 * _MARGIN * max(side, top - hub) / _ROUND)
    report.problem(
        at,
        f"are covered by {what}",
        value=f"y {-extent.half_width:.4g} to {extent.half_width:.4g} m, z to {extent.top:.4g} m",
        limit=f"y {left:.4g} to {right:.4g} m, z to {top:.4g} m",
        remedy="make a larger one, such as with pitchpoint wind "
        f"--height '{hub:.4g} m' --width '{width:g} m'",
    )


def _time(
    parts: Parts,
    rotor: WindRotor,
    wind: str,
    along: NDArray[np.float64],
    report: Reader,
    extent: BoxExtent,
) -> None:
    """Check the duration of a box that does not repeat."""
    if extent.periodic:
        return
    first, last = extent.times_at(float(along[1]))[0], extent.times_at(float(along[0]))[1]
    for name, used in winds_of_scenario(parts, rotor):
        end = parts.scenarios[name].duration or 0.0
        if used == wind and (first > _CLOSE or last < end * (1.0 - _CLOSE)):
            report.problem(
                ("winds", wind, "box"),
                f"are covered by {Path(str(parts.winds[wind].box)).name}, which does not repeat",
                value=f"{first:.4g} to {last:.4g} s",
                limit=f"0 to {end:.4g} s, the duration of scenario {name}",
                remedy="use a longer file or one that repeats, or shorten the scenario",
            )
            return
