# SPDX-License-Identifier: Apache-2.0
"""Elements of a beam: one section for all, or those of a table of properties or of section matrices."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.geometry.section_matrix import mass_lines
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.multibody.beam_coupling import coupling, parallel_compliance
from pitchpoint.multibody.beam_section import Beam, Section, rectangle, tube

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam as BeamPart
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
SAME = 1e-6
"""Distance of two centres that are one, over the larger radius of gyration of the section."""
_NOTHING = Section(A=0.0, I_1=0.0, I_2=0.0, J=0.0, kappa_1=0.0, kappa_2=0.0)


@dataclass(frozen=True)
class Piece:
    """One element of a beam, and elements for a separate mass.

    Parameters
    ----------
    beam
        Stiffness, and mass unless it is apart.
    axes
        Section axes 1, 2 and beam axis as columns, in the axes of the beam.
    ends
        Offsets of the curved axis of the beam at both ends from the line between its ends [m].
    masses
        Elements with the mass alone, and their places along the axes 1 and 2 [m]; empty if the mass is that
        of `beam`.
    """

    beam: Beam
    axes: Array = field(default_factory=lambda: np.eye(3))
    ends: Array = field(default_factory=lambda: np.zeros((2, 3)))
    masses: tuple[tuple[Beam, tuple[float, float]], ...] = ()

    @property
    def parts(self) -> list[tuple[str, Beam, Array]]:
        """Elements by the end of their name, and the offsets of both nodes."""
        words = (".mass", ".mass_2")
        return [
            ("", self.beam, self.ends),
            *(
                (word, beam, self.ends + self.axes @ np.array([*place, 0.0]))
                for word, (beam, place) in zip(words, self.masses, strict=False)
            ),
        ]

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.beam.mass + sum(beam.mass for beam, _ in self.masses)


def beam_pieces(model: Model, name: str, length: float) -> list[Piece]:
    """Elements of a beam, all of one length along the line between its ends.

    Parameters
    ----------
    model
        The model.
    name
        Name of the beam.
    length
        Length of the line between its ends [m].
    """
    part = model.beams[name]
    if part.properties is None:
        data = part.material_data
        beam = Beam(
            section=section_of(part, data.poisson_ratio),
            length=length / part.pieces,
            E=data.youngs_modulus,
            G=data.shear_modulus,
            rho=data.density,
        )
        return [Piece(beam)] * part.pieces
    table = beam_table_of(part.properties)
    ends = np.linspace(0.0, 1.0, part.pieces + 1)
    offset = table.offset(ends)
    line = np.column_stack([offset, length * ends])
    places = np.column_stack([offset, np.zeros(ends.size)])
    found = []
    for k, (a, b) in enumerate(itertools.pairwise(ends)):
        way, own = line[k + 1] - line[k], places[k : k + 2]
        if isinstance(table, SectionTable):
            damping = np.zeros(6) if part.internal_damping else table.damping
            found.append(_coupled(table, (a, b), damping, way, own))
        else:
            found.append(_tapered(table.mean(a, b, length), way, own))
    return found


def _tapered(mean: Mapping[str, float], way: Array, ends: Array) -> Piece:
    """Element with given stiffnesses along a way; without a radius of gyration its rotary inertia is that
    of a homogeneous section."""
    length, stiff = float(np.linalg.norm(way)), mean["axial"]
    line, elastic, center = (
        (mean[f"{word}_1"], mean[f"{word}_2"]) for word in ("shear_center", "elastic", "center")
    )
    size = SAME * math.sqrt(max(mean["bending_1"], mean["bending_2"]) / stiff)
    section = Section(
        A=1.0,
        I_1=mean["bending_1"] / stiff,
        I_2=mean["bending_2"] / stiff,
        J=mean["torsion"] / stiff,
        kappa_1=mean["shear_1"] / stiff,
        kappa_2=mean["shear_2"] / stiff,
    )
    beam = Beam(section=section, length=length, E=stiff, G=stiff, rho=mean["mass"])
    axes = _along(way / length) @ about_z(mean["twist"])
    gyration = mean["gyration"]
    if max(math.hypot(*place) for place in (line, elastic, center)) <= size and gyration == 0.0:
        return Piece(beam, axes, ends)
    second = (section.I_1, section.I_2) if gyration == 0.0 else (0.5 * gyration**2,) * 2
    part = None
    if max(math.hypot(*place) for place in (line, elastic)) > size:
        compliance = parallel_compliance(
            centre=elastic,
            shear_centre=line,
            bending=(mean["bending_1"], mean["bending_2"]),
            shear=(mean["shear_1"], mean["shear_2"]),
            axial=stiff,
            torsion=mean["torsion"],
        )
        part = coupling(compliance, length)
    stiffness = replace(beam, rho=0.0, coupling=part)
    return Piece(stiffness, axes, ends, ((_mass_beam(mean["mass"], second, stiffness), center),))


def _coupled(
    table: SectionTable, piece: tuple[float, float], damping: Array, way: Array, ends: Array
) -> Piece:
    """Element with the section matrices of a piece along a way."""
    length, mean = float(np.linalg.norm(way)), table.mean(*piece)
    factor, soft = np.sqrt(damping), np.linalg.inv(mean["stiffness"])
    lost = soft @ (factor[:, None] * mean["stiffness"] * factor) @ soft
    beam = Beam(section=_NOTHING, length=length, E=0.0, G=0.0, coupling=coupling(soft, length, lost))
    masses = tuple(
        (_mass_beam(part.mass, (part.second, part.second), beam), part.place)
        for part in mass_lines(mean["inertia"])
    )
    return Piece(beam, _along(way / length) @ about_z(float(mean["twist"])), ends, masses)


def _mass_beam(mass: float, second: tuple[float, float], beam: Beam) -> Beam:
    """Element with the mass per length and its moments of inertia over the mass, for an element without."""
    section = replace(_NOTHING, A=1.0, I_1=second[0], I_2=second[1])
    phi = None if beam.coupling is None else 0.5 * (beam.phi(1) + beam.phi(2))
    return Beam(section=section, length=beam.length, E=0.0, G=0.0, rho=mass, shear=phi)


def about_z(angle: float) -> Array:
    """Rotation about the z axis, shape (3, 3)."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _along(direction: Array) -> Array:
    """Smallest rotation of the z axis to a direction, shape (3, 3)."""
    x, y, z = direction
    cross = np.array([[0.0, 0.0, x], [0.0, 0.0, y], [-x, -y, 0.0]])
    return np.asarray(np.eye(3) + cross + cross @ cross / (1.0 + z))


def section_of(part: BeamPart, nu: float) -> Section:
    """Cross-section of a beam from its shape or its section properties; nu is Poisson's ratio [-]."""
    s = part.section
    assert s is not None
    if s.diameter is not None:
        return tube(s.diameter, s.bore, nu)
    if s.width is not None and s.height is not None:
        return rectangle(s.width, s.height, nu)
    assert s.area is not None and s.torsion is not None  # a model has no other sections
    return Section(
        A=s.area,
        I_1=s.bending[0],
        I_2=s.bending[1],
        J=s.torsion,
        kappa_1=s.shear[0],
        kappa_2=s.shear[1],
    )
