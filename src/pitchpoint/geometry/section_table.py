# SPDX-License-Identifier: Apache-2.0
"""Section matrices of a beam over its length, and their means over its pieces."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.beam_line import BeamLine, FloatArray
from pitchpoint.geometry.section_matrix import check_inertia, check_stiffness


@dataclass(frozen=True, eq=False, kw_only=True)
class SectionTable(BeamLine):
    """Stiffness and mass matrices of the sections of a beam, linear between the given positions.

    Strains and section forces are in the order of BeamDyn and windIO: along the axes 1, 2 and the beam, then
    about them, about the axis of the beam. A positive moment about axis 1 bends the beam against axis 2.

    Parameters
    ----------
    position, twist, offset_1, offset_2, length
        As for `BeamLine`.
    stiffness
        Section forces for the strains, symmetric and positive definite, shape (n, 6, 6) [N, N m, N m²].
    inertia
        Mass matrices, symmetric, of a flat section, shape (n, 6, 6) [kg/m, kg, kg m].
    damping
        Damping over stiffness of each strain, shape (6,) [s]: the damping matrix of a section is
        sqrt(damping_i damping_j) K_ij; empty for none.

    Raises
    ------
    ModelError
        With all matrices and lists that describe no beam.

    Examples
    --------
    >>> K, M = np.diag([1e9, 1e9, 1e10, 4e9, 1e9, 1e9]), np.diag([100.0, 100, 100, 30, 10, 40])
    >>> table = SectionTable(position=[0, 1], stiffness=[K, 0.5 * K], inertia=[M, M])
    >>> float(table.mean(0.0, 0.5)["stiffness"][2, 2])
    8750000000.0
    """

    stiffness: FloatArray
    inertia: FloatArray
    damping: FloatArray = ()  # type: ignore[assignment]

    def __post_init__(self) -> None:
        for name in ("position", "stiffness", "inertia", "damping", "twist", "offset_1", "offset_2"):
            value = np.array(getattr(self, name), dtype=float)
            if not value.size:
                value = np.zeros(6 if name == "damping" else len(self.position))
            object.__setattr__(self, name, value)
        if problems := list(self._problems()):
            raise ModelError(problems)

    def _problems(self) -> list[Message]:
        found, x = self._position_problems(), self.position
        for name in ("stiffness", "inertia", "twist", "offset_1", "offset_2"):
            values = getattr(self, name)
            if len(values) != x.size:
                text = "is the number of matrices" if values.ndim == 3 else "is the number of values"
                found.append(Message(name, text, str(len(values)), f"{x.size} as of position"))
            elif not np.isfinite(values).all():
                found.append(Message(name, "contains values that are not finite", remedy="give numbers"))
            elif values.ndim == 3:
                found += self._matrices(name, values)
        if self.damping.shape != (6,) or not (self.damping >= 0.0).all():
            shown = ", ".join(f"{x:g}" for x in self.damping.ravel())
            found.append(Message("damping", "is out of range", shown, "six values >= 0"))
        return found

    @staticmethod
    def _matrices(name: str, values: FloatArray) -> list[Message]:
        """Problems of all matrices of a list."""
        check = check_stiffness if name == "stiffness" else check_inertia
        found = []
        for k, matrix in enumerate(values):
            try:
                check(matrix)
            except ValueError as error:
                found.append(Message(f"{name}[{k}]", str(error), remedy="correct the matrix"))
        return found

    def mean(self, start: float, end: float) -> dict[str, FloatArray]:
        """Mean twist [rad], stiffness and mass matrix of a piece, shape (6, 6), in the axes of the sections.

        Parameters
        ----------
        start, end
            Ends of the piece, from 0 to 1.
        """
        x = self.within(start, end)
        columns: dict[str, FloatArray] = {"twist": np.asarray(np.interp(x, self.position, self.twist))}
        columns |= {name: self._at(getattr(self, name), x) for name in ("stiffness", "inertia")}
        found: dict[str, FloatArray] = {}
        for name, values in columns.items():
            found[name] = np.asarray(np.trapezoid(values, x, axis=0)) / (end - start)
        return found

    def _at(self, matrices: FloatArray, at: FloatArray) -> FloatArray:
        """Matrices at positions, shape (m, 6, 6)."""
        k = np.clip(np.searchsorted(self.position, at, side="right") - 1, 0, self.position.size - 2)
        w = ((at - self.position[k]) / (self.position[k + 1] - self.position[k]))[:, None, None]
        return np.asarray((1.0 - w) * matrices[k] + w * matrices[k + 1])
