# SPDX-License-Identifier: Apache-2.0
"""Properties of a beam over its length, and their means over its pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.beam_line import BeamLine, FloatArray

STIFF_TORSION, STIFF_AXIAL = 100.0, 1e4
"""Torsional stiffness, and axial stiffness times the square of the length, over the larger bending stiffness,
of a table without them."""
_NEEDED = ("mass", "bending_1", "bending_2")
_COLUMNS = (
    *_NEEDED,
    *("torsion", "axial", "twist", "center_1", "center_2", "gyration", "elastic_1", "elastic_2"),
    *("shear_center_1", "shear_center_2", "shear_1", "shear_2", "offset_1", "offset_2"),
)
_POSITIVE = ("bending_1", "bending_2", "torsion", "axial", "shear_1", "shear_2")
_NOT_NEGATIVE = ("mass", "gyration")


@dataclass(frozen=True, eq=False, kw_only=True)
class BeamTable(BeamLine):
    """Properties of a beam, linear between the given positions.

    Parameters
    ----------
    position, twist, offset_1, offset_2, length
        As for `BeamLine`.
    mass
        Mass per length, shape (n,) [kg/m].
    bending_1, bending_2
        Bending stiffness in the direction of axis 1 and 2, shape (n,) [N m²].
    torsion
        Torsional stiffness, shape (n,) [N m²]; empty: 100 times the larger bending stiffness.
    axial
        Axial stiffness, shape (n,) [N]; empty: 1e4 times the larger bending stiffness over the square of the
        length.
    center_1, center_2
        Centre of mass along the twisted axes, shape (n,) [m]; empty for zero.
    gyration
        Radius of gyration of the mass about its centre, along the beam, shape (n,) [m]; empty: that of a
        homogeneous section with these bending and axial stiffnesses.
    elastic_1, elastic_2
        Elastic centre, where a tensile force does not bend, along the twisted axes, shape (n,) [m]; empty for
        zero.
    shear_center_1, shear_center_2
        Shear centre, where a transverse force does not twist, along the twisted axes, shape (n,) [m]; empty:
        the elastic centre.
    shear_1, shear_2
        Shear stiffness along the twisted axes, shape (n,) [N]; empty: no shear deflection.

    Raises
    ------
    ModelError
        With all lists that describe no beam.

    Examples
    --------
    >>> table = BeamTable(position=[0, 1], mass=[300, 100], bending_1=[2e9, 1e9], bending_2=[3e9, 1e9])
    >>> table.mean(0.0, 0.5, 60.0)["mass"]
    250.0
    """

    mass: FloatArray
    bending_1: FloatArray
    bending_2: FloatArray
    torsion: FloatArray = ()  # type: ignore[assignment]
    axial: FloatArray = ()  # type: ignore[assignment]
    center_1: FloatArray = ()  # type: ignore[assignment]
    center_2: FloatArray = ()  # type: ignore[assignment]
    gyration: FloatArray = ()  # type: ignore[assignment]
    elastic_1: FloatArray = ()  # type: ignore[assignment]
    elastic_2: FloatArray = ()  # type: ignore[assignment]
    shear_center_1: FloatArray = ()  # type: ignore[assignment]
    shear_center_2: FloatArray = ()  # type: ignore[assignment]
    shear_1: FloatArray = ()  # type: ignore[assignment]
    shear_2: FloatArray = ()  # type: ignore[assignment]

    def __post_init__(self) -> None:
        for name in ("position", *_COLUMNS):
            object.__setattr__(self, name, np.array(getattr(self, name), dtype=float))
        if problems := list(self._problems()):
            raise ModelError(problems)

    def _problems(self) -> list[Message]:
        found, x = self._position_problems(), self.position
        for name in _COLUMNS:
            values = getattr(self, name)
            if values.size != x.size and (values.size or name in _NEEDED):
                found.append(
                    Message(name, "is the number of values", str(values.size), f"{x.size} as of position")
                )
            elif not np.isfinite(values).all():
                found.append(Message(name, "contains values that are not finite", remedy="give numbers"))
            elif name in (*_POSITIVE, *_NOT_NEGATIVE):
                least = name in _NOT_NEGATIVE
                bad = np.flatnonzero(values < 0.0 if least else values <= 0.0)
                for k in bad[:1]:
                    limit = ">= 0" if least else "> 0"
                    found.append(Message(f"{name}[{k}]", "is out of range", f"{values[k]:g}", limit))
        return found

    def mean(self, start: float, end: float, length: float) -> dict[str, float]:
        """Mean properties of a piece.

        Parameters
        ----------
        start, end
            Ends of the piece, from 0 to 1.
        length
            Length of the beam [m].
        """
        x = self.within(start, end)
        found = {}
        for name in _COLUMNS:
            values = self._values(name, length)
            at = np.interp(x, self.position, values)
            found[name] = float(np.trapezoid(at, x)) / (end - start)
        return found

    def _values(self, name: str, length: float) -> FloatArray:
        """A property at all positions, with its default."""
        given = np.asarray(getattr(self, name))
        if given.size:
            return given
        if name.startswith("shear_center"):
            return self._values(name.replace("shear_center", "elastic"), length)
        larger = np.maximum(self.bending_1, self.bending_2)
        if name == "torsion":
            return STIFF_TORSION * larger
        return STIFF_AXIAL * larger / length**2 if name == "axial" else np.zeros(self.position.size)
