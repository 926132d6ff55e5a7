# SPDX-License-Identifier: Apache-2.0
"""Rotors of wind turbines as blade stations on rigid bodies or on beams."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.elements.rotor.record import air_record, polar_rows, station_records, tower_rows
from pitchpoint.elements.rotor.station import RECORD, STATES
from pitchpoint.elements.signal import Pool
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.model.files import read_once
from pitchpoint.model.frames import axes_of, beam_frame, beam_length, place_of
from pitchpoint.model.rotor_input import rotor_input
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.file_errors import WindFileError
from pitchpoint.model.wind.turbsim import read_turbsim
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.beam import beam_nodes
from pitchpoint.system.rules.places import Places
from pitchpoint.system.wind import WindField

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
_turbulence = read_once(2)(read_turbsim)
WORDS = dict(zip(STATES, ("z_n", "w_n", "z_t", "w_t", "f"), strict=True))
"""Symbols of the states."""


@dataclass(frozen=True)
class Station:
    """Place, span and chord direction of one station in the world, with all coordinates zero."""

    place: Array
    span: Array
    chord: Array


def wind_rotor_bank(places: Places) -> Bank:
    """Stations of all rotors, blade by blade, from root to tip."""
    pool = Pool()
    rows: list[np.void] = []
    names: list[str] = []
    for name, part in places.model.wind_rotors.items():
        made = _rotor_rows(places, name, part, pool)
        rows += list(made)
        each = len(made) // part.blades
        names += [name] + [f"{name}.{k // each + 1}.{k % each + 1}" for k in range(1, len(made))]
    return pack("blade_station", RECORD, rows, names, pool=pool.array())


def state_names(model: Model) -> list[str]:
    """Names of the states of all stations with dynamic inflow, ROTOR.BLADE.STATION.STATE."""
    found = []
    for name, part in model.wind_rotors.items():
        if part.inflow == "dynamic":
            n = rotor_input(part).rotor.blade.span.size
            found += [
                f"{name}.{b + 1}.{k + 1}.{WORDS[field]}"
                for b in range(part.blades)
                for k in range(n)
                for field in STATES
            ]
    return found


def _rotor_rows(places: Places, name: str, part: WindRotor, pool: Pool) -> NDArray[np.void]:
    """Records of one rotor."""
    model, at = places.model, f"wind_rotors.{name}"
    given = rotor_input(part)
    rotor, flow = given.rotor, given.flow
    row = np.zeros(1, RECORD)
    row["air"] = air_record(flow)
    _set_wind(row, pool, model, _wind_of(model, part, places))
    polars = polar_rows(rotor)
    row["knots"], row["rows"] = pool.add(polars), len(polars)
    if flow.tower is not None:
        sections = tower_rows(flow.tower)
        row["tower"]["n"], row["sections"] = len(sections), pool.add(sections)
        row["tower"]["x"], row["tower"]["y"] = part.tower_position
    row["k"], row["p_k"], axes = places.end(part.hub)
    row["axis"] = axes[:, 2]
    n = rotor.blade.span.size
    rows = np.tile(row, part.blades * n)
    stall = part.stall == "dynamic"
    rows["blade"] = np.tile(station_records(rotor, flow.tip_loss, flow.hub_loss, stall), part.blades)
    rows["length"] = np.tile(_lengths(rotor), part.blades)
    rows["first"][0] = 1
    rows["hold"], rows["since"] = part.step, np.nan
    if part.inflow == "dynamic":
        rows["inflow"], rows["stall"] = 1, int(stall)
        for k, row in enumerate(rows):
            for field in STATES:
                row[field] = places.state(f"{name}.{k // n + 1}.{k % n + 1}.{WORDS[field]}")
    for k in range(part.blades):
        stations = _stations(model, part, rotor, k)
        fasten = _fastening(places, part, k, at)
        for own, station in zip(rows[k * n : (k + 1) * n], stations, strict=True):
            fasten(own, station)
    return rows


def _wind_of(model: Model, part: WindRotor, places: Places) -> str:
    """Name of the wind at a rotor: of the scenario, of the rotor, or the only one."""
    scenario = places.scenario
    return (scenario.wind if scenario is not None else None) or part.wind or next(iter(model.winds))


def blades_of(model: Model, name: str) -> tuple[Rotor, list[list[Station]]]:
    """Geometry of a rotor of a model, and the stations of its blades in the world at zero coordinates.

    Parameters
    ----------
    model
        The model.
    name
        Name of the rotor.
    """
    part = model.wind_rotors[name]
    rotor = rotor_input(part).rotor
    return rotor, [_stations(model, part, rotor, k) for k in range(part.blades)]


def _set_wind(row: NDArray[np.void], pool: Pool, model: Model, name: str) -> None:
    """Write a wind to the record of a rotor, its box of turbulence to the pool."""
    wind = model.winds[name]
    box = None if wind.box is None else _box(wind.box, f"winds.{name}.box", model.file)
    row["wind"] = WindField(wind.steady, wind.gust.data if wind.gust is not None else None, box).record
    row["box"] = -1
    if box is not None:
        numbers = box.velocity.reshape(-1)
        row["box"] = pool.add(np.resize(numbers, numbers.size + numbers.size % 2).view(np.float64))


def _lengths(rotor: Rotor) -> Array:
    """Length of blade whose load acts at each station: trapezoidal rule [m]."""
    curve = rotor.blade.curve_angle
    steps = np.diff(rotor.blade.span) / np.cos(0.5 * (curve[1:] + curve[:-1]))
    return 0.5 * (np.r_[steps, 0.0] + np.r_[0.0, steps])


def _stations(model: Model, part: WindRotor, rotor: Rotor, k: int) -> list[Station]:
    """Stations of blade k in the world: along the blade, with precone, prebend, sweep, twist and pitch."""
    centre, hub = place_of(model, part.hub), axes_of(model, part.hub)
    assert centre is not None  # all bodies of a model have a position
    turn = 2.0 * np.pi * k / part.blades
    axis = hub[:, 2]
    out = np.cos(turn) * hub[:, 0] + np.sin(turn) * hub[:, 1]
    blade = rotor.blade
    radial = np.sqrt(np.maximum(rotor.radius**2 - blade.sweep**2, 0.0))
    found = []
    for n in range(blade.span.size):
        arm = radial[n] * out - blade.sweep[n] * np.cross(axis, out)
        outward = arm / np.linalg.norm(arm)
        ahead = np.cross(axis, outward)
        slope, theta = rotor.inclination[n], blade.twist[n] + part.pitch
        normal = np.cos(slope) * axis + np.sin(slope) * outward
        found.append(
            Station(
                place=centre + arm + rotor.axial[n] * axis,
                span=np.cos(slope) * outward - np.sin(slope) * axis,
                chord=np.cos(theta) * ahead - np.sin(theta) * normal,
            )
        )
    return found


# --- how a blade follows bodies -----------------------------------------------------------------------------
def _fastening(places: Places, part: WindRotor, k: int, at: str) -> Callable[[Any, Station], None]:
    """Function that lets a record follow the bodies of blade k."""
    if part.beams:
        return _on_beam(places, part.beams[k], f"{at}.beams")
    return _on_body(places, part.bodies[k] if part.bodies else part.hub)


def _on_body(places: Places, end: str) -> Callable[[Any, Station], None]:
    number, point, axes = places.end(end)
    origin, world = places.world(end), places.axes(end)
    turn = axes @ world.T  # world to the axes of the body

    def fasten(row: Any, station: Station) -> None:
        """Rigid station on one body."""
        row["i"], row["share_i"], row["w_i"] = number, 1.0, 1.0
        row["a_i"] = point + turn @ (station.place - origin)
        row["s_i"], row["c_i"] = turn @ station.span, turn @ station.chord

    return fasten


def _on_beam(places: Places, name: str, at: str) -> Callable[[Any, Station], None]:
    model = places.model
    part = model.beams[name]
    (root, world), length = beam_frame(model, part), beam_length(model, part)
    assert root is not None and length is not None
    nodes = beam_nodes(places, name)
    ends = np.linspace(0.0, length, part.pieces + 1)

    def fasten(row: Any, station: Station) -> None:
        """Station between two nodes, by the shape functions of a beam; beyond the ends on the end."""
        local = world.T @ (station.place - root)
        offset = float(np.hypot(local[0], local[1]))
        if offset > 0.1 * length or not -0.1 * length <= local[2] <= 1.1 * length:
            raise ModelError(
                [
                    Message(
                        at,
                        f"names {name}, which is not where the blade is; distance of a station",
                        f"{max(offset, local[2] - length, -local[2]):.3g} m",
                        f"<= {0.1 * length:.3g} m, a tenth of the beam",
                        "place the ends of the beam at root and tip of the blade",
                    )
                ],
                model.file,
            )
        k = int(np.clip(np.searchsorted(ends, local[2], side="right") - 1, 0, part.pieces - 1))
        step = ends[k + 1] - ends[k]
        x = float(np.clip((local[2] - ends[k]) / step, 0.0, 1.0))
        beyond = local - np.array([0.0, 0.0, ends[k] + x * step])
        shares = 1.0 - 3.0 * x**2 + 2.0 * x**3, 3.0 * x**2 - 2.0 * x**3
        slopes = step * (x - 2.0 * x**2 + x**3), step * (x**3 - x**2)
        for end, (number, point, axes), n, h, w in zip(
            "ij", nodes[k : k + 2], shares, slopes, (1.0 - x, x), strict=True
        ):
            row[end], row[f"share_{end}"], row[f"w_{end}"] = number, n, w
            row[f"a_{end}"] = n * point + h * axes[:, 2] + w * (axes @ beyond)
            row[f"s_{end}"] = w * (axes @ (world.T @ station.span))
            row[f"c_{end}"] = w * (axes @ (world.T @ station.chord))

    return fasten


# --- files --------------------------------------------------------------------------------------------------
def _box(path: str, at: str, file: str | None) -> WindBox:
    """Turbulence of a file."""
    try:
        return _turbulence(path)
    except WindFileError as error:
        raise ModelError([Message(at, str(error))], file) from None
