# SPDX-License-Identifier: Apache-2.0
"""Results of a speed sweep by mesh: points in the form of those of the swept mesh, and greatest values."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pitchpoint.analysis.jumps import sweep_jumps
from pitchpoint.core.extremes import greatest

Point = Mapping[str, Any]

PLACE = ("direction", "speed", "mesh_frequency")
"""Entries of a point that do not belong to a mesh; `mesh_frequency` is that of the swept mesh."""
ROUND_OFF = 1e-9
"""Alternating part of a constant, relative to its largest value."""


def swept_meshes(points: Sequence[Point]) -> list[str]:
    """Names of the meshes with results, the swept mesh first; one empty name for points without `meshes`.

    Parameters
    ----------
    points
        Points in the order of the sweep.

    Examples
    --------
    >>> swept_meshes([{"meshes": {"b": {}, "a": {}}}]), swept_meshes([{"mesh_frequency": 5.0}])
    (['b', 'a'], [''])
    """
    return list(points[0].get("meshes", {"": {}})) if points else []


def points_of_mesh(points: Sequence[Point], mesh: str) -> list[dict[str, Any]]:
    """Points with the results of one mesh of `swept_meshes`.

    The mesh force has the further statistic `magnitude`: the largest magnitude, also of forces on the back
    flank, which are negative.

    Parameters
    ----------
    points
        Points in the order of the sweep as of `sweep.speed.SweepSummary` or `io.sweep_store.read_sweep`.
    mesh
        Name of the mesh.

    Examples
    --------
    >>> force = {"min": -3.0, "max": 1.0}
    >>> points_of_mesh([{"speed": 2.0, "meshes": {"a": {"mesh_force": force}}}], "a")
    [{'speed': 2.0, 'mesh_force': {'min': -3.0, 'max': 1.0, 'magnitude': 3.0}}]
    """
    found = []
    for point in points:
        one = {key: point[key] for key in PLACE if key in point}
        one |= point["meshes"][mesh] if "meshes" in point else point
        force = one.get("mesh_force")
        if force:
            one["mesh_force"] = {**force, "magnitude": abs(greatest(force))}
        found.append(one)
    return found


@dataclass(frozen=True)
class MeshSweep:
    """Greatest values of one mesh in one direction of a sweep; NaN if they are not known.

    Attributes
    ----------
    mesh, direction
        Name of the mesh, `up` or `down`.
    points, apart
        Number of points, and of those with contact loss.
    rms, rms_at
        Largest rms of the deflection [m], and its mesh frequency [Hz].
    force, force_at
        Mesh force of the largest magnitude [N], negative on the back flank, and its mesh frequency [Hz].
    loss, loss_at, least_loss
        Largest share of the time without contact [-], its mesh frequency [Hz], and the smallest share.
    closing
        Largest speed at which the flanks meet, normal to them [m/s].
    jumps
        Mesh frequencies of the jumps of the deflection [Hz].

    All frequencies are those of the swept mesh; values that are zero throughout have none.
    """

    mesh: str
    direction: str
    points: int
    apart: int
    rms: float
    rms_at: float
    force: float
    force_at: float
    loss: float
    loss_at: float
    least_loss: float
    closing: float
    jumps: tuple[float, ...]


def mesh_sweeps(points: Sequence[Point]) -> list[MeshSweep]:
    """Greatest values of every mesh in every direction, the swept mesh first.

    Parameters
    ----------
    points
        Points in the order of the sweep as of `sweep.speed.SweepSummary` or `io.sweep_store.read_sweep`.

    Examples
    --------
    >>> row = {"mesh_force": {"min": -9.0, "max": 4.0}, "contact_loss_share": 0.2}
    >>> points = [{"direction": "up", "mesh_frequency": 5.0, "meshes": {"a": row}}]
    >>> [(one.mesh, one.force, one.loss, one.apart) for one in mesh_sweeps(points)]
    [('a', -9.0, 0.2, 1)]
    """
    found = []
    for mesh in swept_meshes(points):
        own = points_of_mesh(points, mesh)
        jumps = sweep_jumps([p for p in own if p.get("deflection")])
        for direction in dict.fromkeys(str(p["direction"]) for p in own):
            here = [p for p in own if p["direction"] == direction]
            at = [float(p["mesh_frequency"]) for p in here]
            deflections = [_alternating(p["deflection"]) if p.get("deflection") else math.nan for p in here]
            forces = [greatest(p["mesh_force"]) if p.get("mesh_force") else math.nan for p in here]
            losses = _numbers(here, "contact_loss_share")
            (rms, rms_at), (force, force_at), (loss, loss_at), (closing, _) = (
                _largest(values, at)
                for values in (deflections, forces, losses, _numbers(here, "closing_speed_max"))
            )
            found.append(
                MeshSweep(
                    mesh=mesh,
                    direction=direction,
                    points=len(here),
                    apart=sum(share > 0.0 for share in losses),
                    rms=rms,
                    rms_at=rms_at,
                    force=force,
                    force_at=force_at,
                    loss=loss,
                    loss_at=loss_at,
                    least_loss=min((share for share in losses if math.isfinite(share)), default=math.nan),
                    closing=closing,
                    jumps=tuple(jump.frequency for jump in jumps if jump.direction == direction),
                )
            )
    return found


def _numbers(points: Sequence[Point], name: str) -> list[float]:
    """Numbers of the points; NaN where there is none."""
    return [math.nan if p.get(name) is None else float(p[name]) for p in points]


def _alternating(row: Point) -> float:
    """Rms of the alternating part; round-off of a constant is zero."""
    constant = "min" in row and row["rms"] <= ROUND_OFF * abs(greatest(row))
    return 0.0 if constant else float(row["rms"])


def _largest(values: Sequence[float], at: Sequence[float]) -> tuple[float, float]:
    """Value with the largest magnitude, and its place; NaN without a value, zeros have no place."""
    known = [(value, place) for value, place in zip(values, at, strict=True) if math.isfinite(value)]
    value, place = max(known, key=lambda one: abs(one[0]), default=(math.nan, math.nan))
    return value, place if value else math.nan
