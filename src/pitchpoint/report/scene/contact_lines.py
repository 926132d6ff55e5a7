# SPDX-License-Identifier: Apache-2.0
"""Contact lines of all meshes over the frames of a scene: their positions and loads.

The kernels `elements/mesh/contact_lines` and `elements/mesh/bevel/contact_lines` give the loads of each
frame, without damping: a result does not contain all velocities. Widths of bevel gears are ζ = R_m ln(R/R_m),
in which contact lines are straight, x = x_0 ± tan β_b ζ with the arc x = R_m σ from the pitch ray
(docs/theory/bevel_mesh.md).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.kernel import invoke
from pitchpoint.core.status import OK, sentence
from pitchpoint.elements.mesh.contact_lines import LINES, answer
from pitchpoint.system.meshes import is_bevel, mesh_names, mesh_places

if TYPE_CHECKING:
    from pitchpoint.system.system import System

Array = NDArray[np.float64]
Read = Callable[[str], Array | None]

STATIONS = 9
"""Number of stations along a contact line with stored loads."""


class ContactLines:
    """Contact lines of all meshes, evaluated frame by frame during a motion.

    Parameters
    ----------
    system
        The machine.
    read
        Function that returns a channel of the result at the frames, or None.
    n
        Number of frames.

    Attributes
    ----------
    meshes
        Contact lines of each mesh, by name.
    """

    def __init__(self, system: System, read: Read, n: int) -> None:
        self.system = system
        self.meshes: dict[str, MeshLines] = {}
        for name, (kind, k) in zip(mesh_names(system), mesh_places(system), strict=True):
            record = system.records[kind][k : k + 1]
            of_kind = BevelLines if is_bevel(record[0]) else MeshLines
            self.meshes[name] = of_kind(record, n, read(f"deflection[{name}]"))

    def look(self, frame: int) -> None:
        """Evaluate all meshes at the present state.

        Raises
        ------
        SolverError
            If the evaluation fails.
        """
        for mesh in self.meshes.values():
            mesh.look(frame, self.system.workspace.at)


class MeshLines:
    """Contact lines of one mesh.

    Parameters
    ----------
    record
        Record of the mesh in the system, shape (1,).
    n
        Number of frames.
    deflection
        Travel of the gears in the result, (n,) [m]; None: that of the record.

    Attributes
    ----------
    forces, loads
        By front and back flank and slot, (n, 2, p) [N], and per width at the stations, (n, 2, p, s) [N/m].
    travel
        Position of the line of pair 0 at mid-face, (n, 2) [m].
    deflection
        Travel of the gears, (n,) [m].
    line
        Path from A to E and face [m], pressure angle and backlash, (n, 6).
    first
        Record in the first frame.
    """

    cone: tuple[float, float] | None = None
    """Mean cone distance [m] and pitch cone angle of gear 2 [rad] of bevel gears, as in the first frame."""

    def __init__(self, record: NDArray[np.void], n: int, deflection: Array | None) -> None:
        self.record = record
        self.pairs = int(record[0]["n_pair"])
        self.forces = np.zeros((n, 2, self.pairs))
        self.loads = np.zeros((n, 2, self.pairs, STATIONS))
        self.travel = np.zeros((n, 2))
        self.deflection = np.zeros(n)
        self.line = np.zeros((n, 6))
        self.first: Any = None
        self._kept = deflection
        self._questions = np.zeros(2, LINES)
        self._questions["record"], self._questions["stations"] = record.ctypes.data, STATIONS
        self._questions["flank"] = (1, -1)

    def look(self, frame: int, at: int) -> None:
        """Evaluate the mesh and store its contact lines; `at` is the address of the control record."""
        b = self.record[0]
        now = b["now"]
        self.deflection[frame] = now["u"] - now["e_t"] if self._kept is None else self._kept[frame]
        for k, one in enumerate(self._questions):
            one["deflection"] = self.deflection[frame]
            one["forces"] = self.forces[frame, k].ctypes.data
            one["loads"] = self.loads[frame, k].ctypes.data
        status = invoke(self.answer(), at, self._questions.ctypes.data, len(self._questions))
        if status != OK:
            raise SolverError(sentence(status), int(status))
        self.travel[frame] = now["xi_A"] + (self._questions["pairs"] + self._questions["psi"]) * b["p_bt"]
        path = (now["xi_A"], now["xi_A"] + now["eps"] * b["p_bt"])
        self.line[frame] = (*path, *self.face(), math.atan2(now["sin_a"], now["cos_a"]), now["gap"])
        if frame == 0:
            self.first = self.record.copy()[0]

    def answer(self) -> Any:
        """Kernel that evaluates the lines."""
        return answer

    def face(self) -> tuple[float, float]:
        """Ends of the common face width, from the pitch point [m]."""
        now = self.record[0]["now"]
        return now["z_lo"], now["z_hi"]

    def placed(self, width: Array, path: Array, normal: Array) -> Array:
        """Points of the plane of action in the first frame, over width and line of action `normal` [m]."""
        now = self.first["now"]
        return np.asarray(now["P"] + width[..., None] * now["m"] + path[..., None] * normal)


class BevelLines(MeshLines):
    """Contact lines of one bevel mesh: widths are ζ, travel and deflection are those at R_m.

    Attributes
    ----------
    axes
        Across the pitch ray towards gear 2, along the tangent and along the ray, columns, (n, 3, 3).
    """

    def __init__(self, record: NDArray[np.void], n: int, deflection: Array | None) -> None:
        super().__init__(record, n, deflection)
        self.axes = np.zeros((n, 3, 3))

    @property
    def cone(self) -> tuple[float, float]:  # type: ignore[override]
        """Mean cone distance [m] and pitch cone angle of gear 2 [rad], as in the first frame."""
        b = self.first
        now = b["now"]
        return float(b["R_m"]), math.acos(float(now["axis"][1] @ now["m"]))

    def look(self, frame: int, at: int) -> None:
        """Evaluate the mesh and store its contact lines."""
        super().look(frame, at)
        now = self.record[0]["now"]
        self.axes[frame] = np.column_stack([now["e"], now["t"], now["m"]])

    def answer(self) -> Any:
        """Kernel that evaluates the lines."""
        from pitchpoint.elements.mesh.bevel.contact_lines import answer

        return answer

    def face(self) -> tuple[float, float]:
        """Ends of the common face width in ζ, from R_m [m]."""
        b = self.record[0]
        R = b["R_m"]
        return R * math.log1p(b["z_lo"] / R), R * math.log1p(b["z_hi"] / R)

    def placed(self, width: Array, path: Array, normal: Array) -> Array:
        """Points of the plane of action in the first frame, at ζ and x on the line of action `normal` [m]."""
        b, R_m = self.first, float(self.first["R_m"])
        R, sigma = R_m * np.exp(width / R_m), path / R_m
        along, across = R * np.cos(sigma) - R_m, R * np.sin(sigma)
        return np.asarray(b["now"]["P"] + along[..., None] * b["now"]["m"] + across[..., None] * normal)
