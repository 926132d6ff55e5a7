# SPDX-License-Identifier: Apache-2.0
"""Beams as stations (bodies with six coordinates) and the beam elements between them.

The stations are children of the body at the first end: a beam on a rotating hub starts with the correct
speed, and its coordinates are deflections relative to that body.
"""

from __future__ import annotations

import functools
import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import ModelError
from pitchpoint.elements.beams.record import RECORD, beam_row
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.model.frames import axes_of, beam_frame, beam_length, carrying_end
from pitchpoint.model.openfast.elastodyn import read_elastodyn
from pitchpoint.multibody.beam_section import Beam, Section, rectangle, tube
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.joints import FLOATING
from pitchpoint.system.rules.bank import Bank
from pitchpoint.system.rules.bodies import beam_numbers, end_of
from pitchpoint.system.rules.structure_files import change_time

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam as BeamPart
    from pitchpoint.model.model import Model
    from pitchpoint.system.rules.places import Places

Array = NDArray[np.float64]

BARE = 1e-9
"""Mass and inertia of a station relative to those of a beam element; a body must not be massless."""


@dataclass(frozen=True)
class Piece:
    """One element of a beam: its stiffness, mass, rotation of its axes and centre of mass along them."""

    beam: Beam
    twist: float = 0.0
    center: tuple[float, float] = (0.0, 0.0)

    @property
    def parts(self) -> list[tuple[str, Beam, Array]]:
        """Elements by the end of their name, and their offset: one, or stiffness and mass apart."""
        if self.center == (0.0, 0.0):
            return [("", self.beam, np.zeros(3))]
        bare = replace(self.beam, rho=0.0), replace(self.beam, E=0.0, G=0.0)
        return [("", bare[0], np.zeros(3)), (".mass", bare[1], np.array([*self.center, 0.0]))]


def beam_stations(model: Model) -> dict[int, Body]:
    """Stations of all beams by their number in the records."""
    found, first = {}, beam_numbers(model)
    for name, part in model.beams.items():
        (root, axes), length = _line(model, part)
        pieces = _pieces(model, name, length)
        parent = end_of(model, carrying_end(model, part.ends[0]))[0]
        for k, (number, share) in enumerate(part.stations.items()):
            beam = pieces[k].beam
            found[first[name] + k] = Body(
                name=f"{name}.{number}",
                motion=FLOATING,
                parent=parent,
                position=tuple(root + axes[:, 2] * share * length),
                axes=axes,
                mass=BARE * beam.mass,
                inertia=BARE * beam.mass * beam.length**2 * np.eye(3),
            )
    return found


def beam_bank(places: Places) -> Bank:
    """Elements of all beams."""
    model = places.model
    rows, names = [np.zeros(0, RECORD)], []
    for name, part in model.beams.items():
        _, length = _line(model, part)
        nodes = beam_nodes(places, name)
        for k, (one, two, piece) in enumerate(
            zip(nodes[:-1], nodes[1:], _pieces(model, name, length), strict=True), start=1
        ):
            turn = about_z(piece.twist)
            for end, beam, offset in piece.parts:
                rows.append(
                    beam_row(
                        beam,
                        bodies=(one[0], two[0]),
                        nodes=(one[1] + one[2] @ turn @ offset, two[1] + two[2] @ turn @ offset),
                        axes=(one[2] @ turn, two[2] @ turn),
                        eta=part.internal_damping,
                        gravity=model.gravity or (0.0, 0.0, 0.0),
                    )
                )
                names.append((name if part.pieces == 1 else f"{name}.{k}") + end)
    return Bank("beam", np.concatenate(rows), tuple(names))


def about_z(angle: float) -> Array:
    """Rotation about the z axis, shape (3, 3)."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def beam_nodes(places: Places, name: str) -> list[tuple[int, Array, Array]]:
    """Nodes of a beam from its first end: body, position and section axes in the frame of that body."""
    model = places.model
    part, first = model.beams[name], beam_numbers(model)[name]
    axes = beam_frame(model, part)[1]
    inner = [(first + k, np.zeros(3), np.eye(3)) for k in range(part.pieces - 1)]
    return [_clamped(model, places, part.ends[0], axes), *inner, _clamped(model, places, part.ends[1], axes)]


def _line(model: Model, part: BeamPart) -> tuple[tuple[Array, Array], float]:
    """First end in world axes with all coordinates zero [m], section axes as columns, and length [m]."""
    (root, axes), length = beam_frame(model, part), beam_length(model, part)
    assert root is not None and length is not None  # all bodies of a model have a position
    return (root, axes), length


def _clamped(model: Model, places: Places, end: str, axes: Array) -> tuple[int, Array, Array]:
    """Number of the body at an end; node and section axes in the frame of that body."""
    number, node, own = places.end(end)
    return number, node, own @ axes_of(model, end).T @ axes


def _pieces(model: Model, name: str, length: float) -> list[Piece]:
    """Elements of a beam, all of one length."""
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
    table = table_of(model, name)
    ends = np.linspace(0.0, 1.0, part.pieces + 1)
    return [_tapered(table.mean(a, b, length), length / part.pieces) for a, b in itertools.pairwise(ends)]


def _tapered(mean: Mapping[str, float], length: float) -> Piece:
    """Element with given stiffnesses; its rotary inertia is that of a homogeneous section."""
    area = 1.0
    section = Section(
        A=area,
        I_1=mean["bending_1"] / mean["axial"],
        I_2=mean["bending_2"] / mean["axial"],
        J=mean["torsion"] / mean["axial"],
        kappa_1=0.0,
        kappa_2=0.0,
    )
    stiff = mean["axial"] / area
    beam = Beam(section=section, length=length, E=stiff, G=stiff, rho=mean["mass"] / area)
    return Piece(beam, mean["twist"], (mean["center_1"], mean["center_2"]))


def table_of(model: Model, name: str) -> BeamTable:
    """Properties of a beam over its length, from its lists or from its file."""
    given = model.beams[name].properties
    at = f"beams.{name}.properties"
    assert given is not None
    try:
        if given.elastodyn is None:
            return BeamTable(**given.lists)  # type: ignore[arg-type]
        table = _contents(given.elastodyn, change_time(given.elastodyn))
        own = {k: v for k, v in given.lists.items() if k != "position"}
        return replace(table, **{k: np.interp(table.position, given.position, v) for k, v in own.items()})
    except ModelError as error:
        raise ModelError(
            [p.changed(where=f"{at}: {p.where}".rstrip(": ")) for p in error.problems], model.file
        ) from None


@functools.lru_cache(maxsize=16)
def _contents(path: str, stamp: int) -> BeamTable:
    return read_elastodyn(path)


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
