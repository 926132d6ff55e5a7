# SPDX-License-Identifier: Apache-2.0
"""Tooth contacts over the frames of a scene: contact lines and their loads, from the kernels.

The state of each frame is restored in the compiled system (`motion`), and the contact lines are evaluated
there (`contact_lines`). Their loads are elastic; one factor per pair scales them to the pair forces of the
result, damping included.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.hertz import flank_radius, half_width, peak_pressure, plane_strain_compliance
from pitchpoint.core.kernel import plain
from pitchpoint.elements.mesh.record import PHASE
from pitchpoint.elements.mesh.tooth_pairs import pair_teeth
from pitchpoint.report.scene.contact_lines import BevelLines, ContactLines, MeshLines, Read
from pitchpoint.report.scene.motion import shown_bodies
from pitchpoint.system.meshes import mesh_names
from pitchpoint.viz.scene.contacts import ContactFlank, FlankSurface, SceneContact

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.report.scene.motion import Motion
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

PLACES = 65
"""Number of points of the path of contact with stored unit pressure."""
GRID = (9, 11)
"""Points of a flank pattern over its width and along the path."""
STEADY = 2e-8
"""Motion of a pitch point [m], and rotation of its axes times the path, below which one row suffices."""


def scene_contacts(
    model: Model, system: System, lines: ContactLines, moved: Motion, read: Read
) -> tuple[list[SceneContact], list[str]]:
    """Contacts of all meshes, and remarks on them.

    Parameters
    ----------
    model, system
        The machine.
    lines
        Contact lines evaluated by the meshes.
    moved
        Where its bodies are over the same frames.
    read
        Gives a channel of the result at the frames, or None.
    """
    found, notes = [], []
    shown = shown_bodies(system)
    for name, mesh in lines.meshes.items():
        m = mesh_names(system).index(name)
        if mesh.first["source"] == PHASE:
            notes.append(
                f"mesh {name}: its stiffness law has no single tooth pairs, so contact lines have no loads"
            )
        forces, loads = _as_kept(name, mesh, read)
        at = moved.pitch_points[:, m]
        axes = np.swapaxes(moved.directions[:, m][:, (1, 0, 2)], 1, 2)
        if isinstance(mesh, BevelLines):
            axes = mesh.axes
        path = tuple(float(x) for x in mesh.line[0, :2])
        steady = max(_moves(at), _moves(axes) * max(abs(x) for x in path)) < STEADY
        rows = slice(0, 1) if steady else slice(None)
        state = read(f"contact_state[{name}]")
        back = bool(np.any(forces[:, 1])) or (state is not None and bool(np.any(np.isin(state, (-1.0, 2.0)))))
        found.append(
            SceneContact(
                name=name,
                at=at[rows],
                axes=axes[rows],
                pressure_angle=mesh.line[rows, 4],
                base_helix=math.atan(float(mesh.first["tan_b"])),
                base_pitch=float(mesh.first["p_bt"]),
                width=(float(mesh.line[0, 2]), float(mesh.line[0, 3])),
                path=(path[0], path[1]),
                cone=mesh.cone,
                penetration=_penetration(name, mesh, read),
                unit_pressure=_unit_pressure(model, name, path) if mesh.pairs else None,
                flanks=[
                    ContactFlank(
                        side=side,
                        travel=mesh.travel[:, k],
                        forces=forces[:, k],
                        loads=loads[:, k],
                        surfaces=_surfaces(model, name, mesh, side, moved, shown),
                    )
                    for k, side in enumerate((1, -1))
                    if side == 1 or back
                ],
            )
        )
    return found, notes


def _moves(values: Array) -> float:
    return float(np.ptp(values, axis=0).max())


def _as_kept(name: str, mesh: MeshLines, read: Read) -> tuple[Array, Array]:
    """Forces and loads of all slots, scaled to the forces in the result, damping included."""
    kept = [read(f"pair_force[{name}.{k}]") for k in range(mesh.pairs)]
    if any(one is None for one in kept) or not kept:
        return mesh.forces, mesh.loads
    both = np.stack([np.asarray(one) for one in kept], axis=1)
    forces = np.stack([np.maximum(both, 0.0), np.minimum(both, 0.0)], axis=1)
    factor = np.divide(forces, mesh.forces, out=np.zeros_like(forces), where=mesh.forces != 0.0)
    return forces, mesh.loads * factor[..., None]


def _unit_pressure(model: Model, name: str, path: tuple[float, ...]) -> Array:
    """Hertzian pressure of a load of 1 N/m at equally spaced points from A to E [Pa], from both materials.

    For bevel gears it applies at the mean cone distance.

    A load per width equals the load per length of the contact line: force and length both grow by 1/cos β_b.
    """
    materials = [model.toothed[gear].material_data for gear in model.every_mesh[name].gears]
    compliances = [plane_strain_compliance(m.youngs_modulus, m.poisson_ratio) for m in materials]
    xi = np.linspace(path[0], path[1], PLACES)
    if name in model.pairs:
        pair = model.pairs[name]
        radius = flank_radius(pair.T1C + xi, pair.T1T2, pair.gear1.beta_b)
    else:
        bevel = model.bevel_pairs[name]
        # the spherical involute of roll σ has the geodesic radius R tan σ
        sigma = bevel.sigma_w + xi / bevel.R_m
        rho_1, rho_2 = (bevel.R_m * np.tan(angle) for angle in (sigma, bevel.sigma_T - sigma))
        radius = flank_radius(rho_1, rho_1 + rho_2, bevel.beta_b)
    width = half_width(1.0, radius, *compliances)
    return np.asarray(peak_pressure(1.0, width))


def _penetration(name: str, mesh: MeshLines, read: Read) -> Array:
    """Penetration of front and back flanks [m] from the channels of the nearer one and its side."""
    nearer = read(f"penetration[{name}]")
    cos_b = math.cos(math.atan(float(mesh.first["tan_b"])))
    x = mesh.deflection
    if nearer is None:
        nearer = (np.abs(x) - 0.5 * mesh.line[:, 5]) * cos_b
    farther = nearer - 2.0 * np.abs(x) * cos_b
    front = x >= 0.0
    return np.stack([np.where(front, nearer, farther), np.where(front, farther, nearer)], axis=1)


def _surfaces(
    model: Model, name: str, mesh: MeshLines, side: int, moved: Motion, shown: list[int]
) -> list[FlankSurface]:
    """Flanks of both gears within the path of contact, swept by the contact lines of the kernel.

    At a width z the flanks of pair 0 are at `line` on the line of action, displaced by half of the
    penetration to both sides; a flank moves along the path when its gear rotates by the travel over its base
    radius.
    """
    b = mesh.first
    now = b["now"]
    k = 0 if side > 0 else 1
    width = np.linspace(mesh.line[0, 2], mesh.line[0, 3], GRID[0])[:, None]
    path = np.linspace(mesh.line[0, 0], mesh.line[0, 1], GRID[1])[None, :]
    line = mesh.travel[0, k] + side * float(b["tan_b"]) * width
    half = 0.5 * (side * mesh.deflection[0] - 0.5 * mesh.line[0, 5])
    normal = side * now["cos_a"] * now["t"] + now["sin_a"] * now["e"]
    points = mesh.placed(width, path, normal)
    found = []
    for gear, (field, sign) in enumerate((("i", 1.0), ("j", -1.0))):
        body, z = int(b[field]), int(b[f"z{gear + 1}"])
        turn = sign * side * (path - line - sign * half) / float(b[f"r_b{gear + 1}"])
        here = (points - moved.place[0, body]) @ moved.axes[0, body]
        angle = -(moved.angle[0, body] + turn)
        c, s = np.cos(angle), np.sin(angle)
        placed = np.stack(
            [c * here[..., 0] - s * here[..., 1], s * here[..., 0] + c * here[..., 1], here[..., 2]], axis=-1
        )
        own = model.every_mesh[name].gears[gear]
        if isinstance(mesh, BevelLines):
            tooth, step = _bevel_tooth_at(model, own, placed), side if gear else -side
        else:
            pair_0 = b.copy()
            pair_0["now"]["flank"], pair_0["now"]["tooth"] = side, 0
            tooth = int(plain(pair_teeth)(pair_0, 0)[gear]) % abs(z)
            step = -side if gear == 0 else side * (1 if z > 0 else -1)
        found.append(
            FlankSurface(
                body=shown.index(body),
                gear=own,
                teeth=abs(z),
                points=placed,
                turn=-sign * side * 2.0 * math.pi / z,
                tooth=tooth,
                step=step,
            )
        )
    return found


def _bevel_tooth_at(model: Model, gear: str, points: Array) -> int:
    """Number of the tooth of a flank.

    Parameters
    ----------
    model
        The machine.
    gear
        Name of the gear.
    points
        Points of the flank in the frame of its body, over face and path, shape (nz, nx, 3) [m].

    Notes
    -----
    On the pitch cone at R_m a flank is about a quarter pitch from the middle of its tooth.
    """
    part = model.bevel_gears[gear]
    shape = part.geometry
    apex = model.bodies[str(model.body_of(gear))].bevel_gears[gear]
    own = (points - np.array([0.0, 0.0, apex])) * np.array([1.0, part.direction, part.direction])
    R = np.linalg.norm(own, axis=-1)
    polar = np.arccos(own[..., 2] / R)
    near = np.unravel_index(
        np.argmin(np.abs(polar - shape.delta) + np.abs(np.log(R / shape.R_m))), polar.shape
    )
    x, y, _ = own[near]
    spiral = shape.spiral_rate * math.log(R[near] / shape.R_m)
    angle = math.atan2(y, x) - spiral - part.direction * model.bevel_angles[gear]
    return round(angle * shape.z / math.tau) % shape.z
