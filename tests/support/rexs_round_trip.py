# SPDX-License-Identifier: Apache-2.0
"""Differences of two models: geometry, places, masses, stiffness, loads and speeds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from pitchpoint.geometry.modifications import deviation, flank_range
from pitchpoint.model.frames import frame
from pitchpoint.model.stand_ins import own_parts

RIGID = np.diag([1e11, 1e11, 1e11, 1e7, 1e7, 1e7])
"""Stiffness above which a support is rigid for the import [N/m], [N m/rad]."""
TEETH = ("z", "m_n", "alpha_n", "beta", "x", "b", "d_a", "d_f", "rho_fP_star")
CONES = ("z", "m_mn", "delta", "b", "alpha_n", "beta_m", "x_hm", "x_sm", "h_am", "h_fm")
Found = Iterator[tuple[str, Any, Any]]


def differences(one: Any, two: Any) -> Found:
    """Keys of the first model whose values differ, with both values; a missing part has None.

    Names of planets and their gears are compared by their stages.
    """
    yield from _gears(one, two)
    yield from _bodies(one, two)
    yield from _meshes(one, two)
    yield from _supports(one, two)
    yield from _stages(one, two)
    yield from _loads(one, two)


def _near(a: Any, b: Any, scale: float = 1e-12) -> bool:
    if a is None or b is None or isinstance(a, str | bool) or isinstance(b, str | bool):
        return bool(a == b)
    a, b = np.asarray(a, float), np.asarray(b, float)
    return a.shape == b.shape and bool(np.allclose(a, b, rtol=1e-8, atol=scale))


def _paired(one: Any, two: Any, section: str) -> Iterator[tuple[str, Any, Any]]:
    others = getattr(two, section)
    for name, part in own_parts(getattr(one, section)).items():
        yield f"{section}.{name}", part, others.get(name)


def _gears(one: Any, two: Any) -> Found:
    for section, keys in (("gears", TEETH), ("bevel_gears", CONES)):
        for path, gear, other in _paired(one, two, section):
            if other is None:
                yield path, gear, None
                continue
            for key in keys:
                values = [getattr(g.geometry, key, None) for g in (gear, other)]
                if not _near(*values):
                    yield f"{path}.{key}", *values
            if section == "gears" and not _near(gear.bore_diameter, other.bore_diameter):
                yield f"{path}.bore_diameter", gear.bore_diameter, other.bore_diameter
            if section == "gears":
                for side in ("left", "right"):
                    roll = np.linspace(*flank_range(gear.geometry), 9)[:, None]
                    removed = [_removed(g, side, roll) for g in (gear, other)]
                    if not np.allclose(*removed, atol=1e-12):
                        yield f"{path}.modifications.{side}", *removed


def _removed(gear: Any, side: str, roll: np.ndarray) -> np.ndarray:
    """Material removed from a flank at 9 x 5 points [m]."""
    found = None if gear.modifications is None else gear.modifications.side(side)
    if found is None:
        return np.zeros((9, 5))
    z = np.linspace(-0.5, 0.5, 5) * gear.geometry.b
    return deviation(found.of_geometry(), gear.geometry, roll, z)


def _axes(body: Any) -> np.ndarray:
    return np.eye(3) if body.orientation is None else frame(body.orientation)


def _bodies(one: Any, two: Any) -> Found:
    for name, body in one.bodies.items():
        if body.stage is not None or body.of_housing:
            continue
        path, other = f"{'shafts' if name in one.shafts else 'bodies'}.{name}", two.bodies.get(name)
        if other is None:
            yield path, body, None
            continue
        if not _near(body.origin or (0.0,) * 3, other.origin or (0.0,) * 3, 1e-9):
            yield f"{path}.position", body.origin, other.origin
        if not _near(_axes(body)[:, 2], _axes(other)[:, 2], 1e-9):
            yield f"{path}.axes", _axes(body), _axes(other)
        if body.shaft is not None and (other.shaft is None or body.shaft.sections != other.shaft.sections):
            yield f"{path}.sections", body.shaft.sections, other.shaft and other.shaft.sections
        masses = [m.body_inertia(name) for m in (one, two)]
        for key in ("mass", "polar", "central"):
            values = [getattr(m, key) for m in masses]
            if not _near(*values) and body.motion != "fixed":
                yield f"{path}.{key}", *values


def _meshes(one: Any, two: Any) -> Found:
    for section, pairs in (("meshes", "pairs"), ("bevel_meshes", "bevel_pairs")):
        for path, mesh, other in _paired(one, two, section):
            name = path.partition(".")[2]
            if other is None or mesh.gears != other.gears:
                yield path, mesh, other
                continue
            key = "a_w" if section == "meshes" else "Sigma"
            a, b = (abs(getattr(getattr(m, pairs)[name], key)) for m in (one, two))
            if not _near(a, b):
                yield f"{path}.{key}", a, b
            a, b = one.backlash(name), two.backlash(name)
            if not _near(a, b):
                yield f"{path}.backlash", a, b


def _stiffness(part: Any) -> np.ndarray:
    K = np.array(part.stiffness.matrix6(), float)
    return np.where(np.eye(6) > 0, np.minimum(K, RIGID), K)


def _supports(one: Any, two: Any) -> Found:
    for section in ("bearings", "couplings"):
        for path, part, other in _paired(one, two, section):
            if other is None or not _near(_stiffness(part), _stiffness(other)):
                yield f"{path}.stiffness", _stiffness(part), other and _stiffness(other)
    for path, part, other in _paired(one, two, "rolling_bearings"):
        if other is None:
            yield path, part, None
            continue
        for key in ("designation", "clearance", "preload", "axial_force_absorption"):
            if not _near(getattr(part, key), getattr(other, key)):
                yield f"{path}.{key}", getattr(part, key), getattr(other, key)
    held = one.housing
    if held is not None and type(held) is not type(two.housing):
        yield "housing", held, two.housing
    oil = one.lubricant
    if oil is not None:
        for key in ("viscosities", "density_at_15_degree_celsius", "base", "temperature"):
            values = [getattr(m.lubricant, key, None) for m in (one, two)]
            if not _near(*values):
                yield f"lubricant.{key}", *values


def _stages(one: Any, two: Any) -> Found:
    """Planetary stages by their suns and rings: teeth, angles, distances."""

    def data(model: Any, stage: Any) -> dict[str, Any]:
        return {
            "angles": sorted(a % (2.0 * np.pi) for a in stage.places),
            "position": stage.position,
            "planet": [[w.gear.number_of_teeth, w.gear.normal_module, w.position] for w in stage.wheels],
            "pin_errors": sorted(e.radial for e in stage.pin_errors.values()),
        }

    def central(stage: Any) -> frozenset[str]:
        return frozenset(g.mate for g in stage.groups if g.side != "planet")

    others = {central(stage): stage for stage in two.planetary_stages.values()}
    for name, stage in one.planetary_stages.items():
        other = others.get(central(stage))
        if other is None:
            yield f"planetary_stages.{name}", stage, None
            continue
        mine, theirs = data(one, stage), data(two, other)
        for key, value in mine.items():
            if not _near(value, theirs[key], 1e-9):
                yield f"planetary_stages.{name}.{key}", value, theirs[key]
        if stage.names != other.names:
            yield f"planetary_stages.{name}.planet_name", stage.names, other.names


def _loads(one: Any, two: Any) -> Found:
    for section in ("loads",):
        for path, part, other in _paired(one, two, section):
            for key in ("torque", "force", "moment"):
                values = [getattr(p, key, None) for p in (part, other)]
                plain = [_law(v) for v in values]
                if plain[0] != plain[1] and not (
                    isinstance(plain[0], list) and isinstance(plain[1], list) and _near(*plain, 1e-6)
                ):
                    yield f"{path}.{key}", *values
    # the first scenario is read as one, all of them as load cases
    read = [case.speed for case in (*two.scenarios.values(), *two.load_cases.values())]
    for name, scenario in own_parts(one.scenarios).items():
        wanted = sorted(scenario.speed.values())
        if wanted and not any(_near(wanted, sorted(speed.values())) for speed in read):
            yield f"scenarios.{name}.speed", scenario.speed, read


def _law(value: Any) -> Any:
    """Numbers of constant values, names of other laws."""
    if value is None:
        return None
    if isinstance(value, tuple):
        return [getattr(v, "value", type(v).__name__) for v in value]
    found = getattr(value, "value", None)
    return type(value).__name__ if found is None else [float(found)]


def listed(path: str, model: Any, omissions: Any) -> bool:
    """Whether a difference, its part, or the reason of another mass is in the list of the writer."""
    where = [one.where for one in omissions]
    if any(path.startswith(one) or one.startswith(path) for one in where):
        return True
    section, name, key = (*path.split("."), "", "")[:3]
    if section not in ("bodies", "shafts") or key not in (*MASSES, ""):
        return False
    if any(one == f"elastic_bodies.{name}" for one in where):
        return True
    if any(one.startswith(f"{section}.{name}.") and one.rpartition(".")[2] in OF_MASS for one in where):
        return True
    body = model.bodies[name]
    return any(
        one.startswith((f"gears.{gear}.", f"bevel_gears.{gear}.")) and one.rpartition(".")[2] in OF_GEARS
        for gear in (*body.gears, *body.bevel_gears)
        for one in where
    )


MASSES = ("mass", "polar", "central")
OF_MASS = ("mass", "inertia", "transverse_inertia", "inertia_tensor", "center_of_mass", "solid")
OF_GEARS = (
    *("tooth_thickness_allowance", "bore_diameter", "rim_thickness", "polar_inertia", "transverse_inertia"),
    *("tooth_profile", "web_thickness"),
)
"""Keys that are listed, and on which the masses of bodies depend."""
