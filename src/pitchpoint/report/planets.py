# SPDX-License-Identifier: Apache-2.0
"""Numbers of planetary stages: places of the planets, phases of their meshes, room between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.checks.planet_clearance import planet_gaps
from pitchpoint.model.components.planetary_stage import MeshGroup, PinError
from pitchpoint.model.planet_places import nominal_distance
from pitchpoint.system.planet_loads import as_data, loads_in, planet_loads
from pitchpoint.system.planet_positions import with_positions

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

ROUNDING = 6
"""Decimals of phases."""


def load_sharing(model: Model, data: xr.Dataset, settle_time: float = 0.0) -> dict[str, dict[str, Any]]:
    """Loads of the planets in a result, by the statistics of the run if they are stored.

    Parameters
    ----------
    model, data
        The model and its result: slow roll or time response.
    settle_time
        Start of the means of a time response without stored statistics [s].
    """
    from pitchpoint.viz.quantities import stored_statistics

    if not model.planetary_stages:
        return {}
    stored = {str(n): s for n, v in data.data_vars.items() if (s := stored_statistics(v.attrs)) is not None}
    known = loads_in(model, stored)
    if not known:
        return as_data(planet_loads(model, data, settle_time))
    return with_positions(model, known, data, settle_time)


def stages_of_model(model: Model) -> dict[str, dict[str, Any]]:
    """Numbers of all planetary stages.

    Returns
    -------
    dict
        By stage: gears and carrier, center_distance [m] without pin errors, ring_after_sun, planet_gap [m]:
        least distance between the tips of neighbouring planets (None for one planet), and by planet its angle
        [rad], pin errors [m], by step the orientation of its teeth [rad], and by mate the phases of its
        meshes after those of the first planet [base pitches], in [0, 1).
    """
    found = {}
    for name, stage in model.planetary_stages.items():
        gaps = planet_gaps(model, stage)
        angles = planet_angles(model, stage.carrier, stage.names)
        phases = {group.mate: group_phases(model, group, angles) for group in stage.groups}
        planets = {}
        for k, planet in enumerate(stage.names):
            error = stage.pin_errors.get(planet, PinError())
            planets[planet] = {
                "angle": stage.places[k],
                "tangential_pin_error": error.tangential,
                "radial_pin_error": error.radial,
                "phases": {mate: values[k] for mate, values in phases.items()},
                "orientations": {step: orientation(model, planet, step) for step in stage.steps},
            }
        found[name] = {
            "sun": stage.sun,
            "ring": stage.ring,
            "mates": [group.mate for group in stage.groups],
            "carrier": stage.carrier,
            "center_distance": nominal_distance(model, stage),
            "ring_after_sun": ring_after_sun(model, stage),
            "planet_gap": min((gap for gap, _ in gaps), default=None),
            "planets": planets,
        }
    return found


def orientation(model: Model, planet: str, step: str) -> float:
    """Angle from a tooth of a stepped planet to the next tooth of its step, at their mid-faces [rad].

    In [0, 2 pi/lcm(z_1, z_2)): other pairs of teeth have other angles.
    """
    names = planet, f"{planet}-{step}"
    pitch = math.tau / math.lcm(*(model.gears[name].number_of_teeth for name in names))
    one, two = (model.phasing.tooth_angle[name] for name in names)
    return round((two - one) / pitch, ROUNDING) % 1.0 * pitch


def ring_after_sun(model: Model, stage: PlanetaryStage) -> float | None:
    """Mesh cycles by which flanks pass the pitch point with the ring after those with the sun, in [0, 1).

    On the first planet, with a sun that drives in positive rotation against the carrier [1]_. The planet then
    rotates in the negative sense, pushed at the trailing flanks of its teeth, and pushes the ring with the
    leading ones; a flank is half a tooth thickness from the centre of its tooth at the working circle. For
    teeth of half a pitch 0 if the planet has an odd number of them, else 1/2. None without sun and ring in
    mesh with the gear given as `planet`.

    References
    ----------
    .. [1] R. G. Parker, J. Lin, Mesh phasing relationships in planetary and epicyclic gears, Journal of
       Mechanical Design 126(2), 2004, 365-370.
    """
    groups = {group.side: group.names[0] for group in stage.groups if not group.wheel.step}
    if not {"sun", "ring"} <= groups.keys():
        return None
    sun, ring = (model.pairs[groups[side]] for side in ("sun", "ring"))
    travel = [model.phasing.travel[groups[s]] / abs(p.p_et) for s, p in (("sun", sun), ("ring", ring))]
    with_sun = 0.5 - travel[0] + 0.5 * _thickness(sun.gear2, sun.d_w2)
    with_ring = travel[1] - 0.5 * _thickness(ring.gear1, ring.d_w1)
    return round(with_ring - with_sun, ROUNDING) % 1.0


def _thickness(gear: CylindricalGear, d_w: float) -> float:
    """Tooth thickness at a diameter [m], in pitches."""
    from pitchpoint.geometry.tooth_thickness import transverse_tooth_thickness

    return transverse_tooth_thickness(gear, abs(d_w)) * abs(gear.z) / (math.pi * abs(d_w))


def group_phases(model: Model, group: MeshGroup, angles: Array) -> list[float]:
    """Phases of the parallel meshes of a group after the first one [base pitches], in [0, 1).

    Meshes of planets with inner planets: from the teeth as assembled.
    """
    if group.side != "planet":
        return mesh_phases(model, group.mate, angles)
    pitches = np.array([model.phasing.travel[n] / abs(model.pairs[n].p_et) for n in group.names])
    return (np.round(pitches[0] - pitches, ROUNDING) % 1.0).tolist()


def planet_angles(model: Model, carrier: str, planets: Sequence[str]) -> Array:
    """Angles of planets about the axis of their carrier, relative to the first, with pin errors [rad]."""
    from pitchpoint.model.frames import body_frame

    origin, axes = body_frame(model, carrier)
    places = [body_frame(model, planet)[0] for planet in planets]
    start = np.zeros(3) if origin is None else origin
    way = np.array([axes.T @ ((start if p is None else p) - start) for p in places])
    angles = np.arctan2(way[:, 1], way[:, 0])
    return np.asarray(angles - angles[0])


def mesh_phases(model: Model, gear: str, angles: Array) -> list[float]:
    """Phases of the meshes of planets with a central gear after the first one, in [0, 1).

    Rounded: rounding errors of positions move a phase of zero to either side.
    """
    from pitchpoint.analysis.planet_frequencies import planet_phases

    central = model.gears[gear]
    phases = planet_phases(central.sign * central.number_of_teeth, angles)
    return (np.round(phases, ROUNDING) % 1.0).tolist()
