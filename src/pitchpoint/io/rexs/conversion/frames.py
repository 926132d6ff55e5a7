# SPDX-License-Identifier: Apache-2.0
"""Positions and directions of parts: axes u, v, w of REXS, and those of the model.

REXS has u along a shaft and w towards the first tooth; the gear unit has such axes too. The model has z along
a shaft and x towards tooth 0: x = w, y = -v, z = u, in the world as on every part.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from pitchpoint.io.rexs.conversion.state import Conversion
    from pitchpoint.io.rexs.document import RexsComponent

TO_MODEL = np.array([[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])
"""Rotation from the axes u, v, w of the gear unit to the world axes of the model; its own inverse."""
REFERENCE, SUPPORT, U, W = (
    *("reference_component_for_position", "support_vector"),
    *("u_axis_vector", "w_axis_vector"),
)
SKEW = 1e-6
"""Largest scalar product of the directions u and w."""
DEEPEST = 50


@dataclass(frozen=True)
class Frame:
    """Frame of a part in the world of the model.

    Attributes
    ----------
    origin
        Origin [m], shape (3,).
    axes
        Directions x, y, z as columns, shape (3, 3).
    """

    origin: np.ndarray
    axes: np.ndarray

    @property
    def z(self) -> np.ndarray:
        """Direction of the axis."""
        return self.axes[:, 2]

    def at(self, z: float) -> np.ndarray:
        """Point on the axis [m]."""
        return self.origin + z * self.z

    def along(self, direction: np.ndarray) -> Frame:
        """The same frame, turned about x by 180 deg if z would be opposite to a direction."""
        opposite = float(self.z @ direction) < 0.0
        return Frame(self.origin, self.axes * np.array([1.0, -1.0, -1.0])) if opposite else self


def frame_of(conversion: Conversion, component: RexsComponent, depth: int = 0) -> Frame | None:
    """Frame of a component; None if it has none, or a wrong one, which is a problem.

    Positions are relative to the reference component, that of the gear unit to itself.
    """
    known = conversion.frames.get(component.id)
    if known is not None:
        return known
    if SUPPORT not in component.attributes or U not in component.attributes:
        return None
    rows = [_triple(conversion, component, key) for key in (SUPPORT, U, W)]
    if any(row is None for row in rows):
        return None
    support, u, w = (np.array(row) for row in rows)
    if min(np.linalg.norm(u), np.linalg.norm(w)) < 1e-12:
        conversion.problem(component, "is a direction of zero length", U if not u.any() else W)
        return None
    u, w = u / np.linalg.norm(u), w / np.linalg.norm(w)
    if abs(u @ w) > SKEW:
        conversion.problem(
            component,
            "is not normal to u_axis_vector",
            W,
            f"{np.degrees(np.arccos(np.clip(u @ w, -1, 1))):.6g} deg",
            "90 deg",
        )
        return None
    base = Frame(np.zeros(3), np.eye(3))
    reference = conversion.value(component, REFERENCE)
    if reference is not None and reference != component.id:
        other = conversion.source.components[int(reference)]  # type: ignore[arg-type]
        if depth > DEEPEST:
            conversion.problem(component, "leads back to the component itself", REFERENCE)
            return None
        found = frame_of(conversion, other, depth + 1)
        if found is None and SUPPORT in other.attributes:
            return None
        base = found or base
    w = w - (u @ w) * u
    w /= np.linalg.norm(w)
    own = TO_MODEL @ np.column_stack([w, np.cross(u, w), u])
    frame = Frame(base.origin + base.axes @ TO_MODEL @ support, base.axes @ own)
    conversion.frames[component.id] = frame
    return frame


def place_in_world(conversion: Conversion, point: RexsComponent) -> np.ndarray | None:
    """Place of a component without axes in the world [m]; None if it has none."""
    if SUPPORT not in point.attributes:
        return None
    support = _triple(conversion, point, SUPPORT)
    reference = conversion.value(point, REFERENCE)
    other = None if reference is None else conversion.source.components[int(reference)]  # type: ignore[arg-type]
    base = None if other is None else frame_of(conversion, other)
    if support is None:
        return None
    local = TO_MODEL @ np.array(support)
    return local if base is None else base.origin + base.axes @ local


def world(frame: Frame, uvw: Sequence[float]) -> np.ndarray:
    """Vector with the components u, v, w of a part in world axes."""
    found: np.ndarray = frame.axes @ TO_MODEL @ np.array(uvw)
    return found


def _triple(conversion: Conversion, component: RexsComponent, key: str) -> tuple[float, ...] | None:
    found = conversion.value(component, key)
    if isinstance(found, tuple) and len(found) == 3 and all(isinstance(x, int | float) for x in found):
        return tuple(float(x) for x in found)  # type: ignore[arg-type]
    what = "is missing" if found is None else "is not a vector of three numbers"
    conversion.problem(component, what, key, remedy="give [u, v, w]")
    return None
