# SPDX-License-Identifier: Apache-2.0
"""Elastic beams between points of two bodies."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from pitchpoint.model.component import Component
from pitchpoint.model.components.six import Matrix6
from pitchpoint.model.keys import choice, component, integer, key, positive, quantities, quantity

if TYPE_CHECKING:
    from pitchpoint.geometry.materials import Material

SHAPES = (("diameter",), ("width", "height"), ("area", "bending", "torsion"))
"""Keys that define a section: round, rectangular, general."""
COMPONENTS = ("blade", "tower")
"""Parts of a windIO file that are beams."""


@dataclass(frozen=True, kw_only=True)
class BeamSection(Component):
    """Cross-section: round (diameter, bore), rectangular (width, height), or general."""

    diameter: float | None = positive("length", "round: outer diameter", None)
    bore: float = quantity(
        "length", "round: inner diameter", 0.0, minimum=0.0, range_words="from 0, below the diameter"
    )
    width: float | None = positive("length", "rectangular: side along axis 1", None)
    height: float | None = positive("length", "rectangular: side along axis 2", None)
    area: float | None = positive("area", "general: area", None)
    bending: tuple[float, ...] = quantities(
        "second_moment_of_area",
        "general: second moments of area for bending in the direction of axis 1 and axis 2",
        (),
        minimum=0.0,
        above=True,
        sample="[2.5 cm^4, 1.2 cm^4]",
    )
    torsion: float | None = positive("second_moment_of_area", "general: torsion constant", None)
    shear: tuple[float, float] = quantities(
        "dimensionless",
        "general: shear factors for axis 1 and 2; 0: no shear deflection",
        (0.0, 0.0),
        length=(2, 2),
        minimum=0.0,
        maximum=1.0,
    )

    @property
    def given(self) -> tuple[str, ...]:
        """Names of the given keys of `SHAPES`."""
        return tuple(k for shape in SHAPES for k in shape if getattr(self, k) not in (None, ()))


_POSITIVE: dict[str, Any] = {"minimum": 0.0, "above": True}
_SHEAR = "shear stiffness in the direction of the twisted axis"


def _list(dimension: str, meaning: str, display: str = "", **more: Any) -> Any:
    """Field for values at the positions; `display` describes its default."""
    return quantities(dimension, meaning, (), display=display, **more)


@dataclass(frozen=True, kw_only=True)
class BeamProperties(Component):
    """Properties over the length of a beam, linear between the given places: lists, or a file of OpenFAST or
    windIO."""

    elastodyn: str | None = key(
        "file",
        "blade or tower file of ElastoDyn, instead of mass, bending stiffness and twist: axis 1 is flapwise, "
        "or fore-aft",
        None,
    )
    beamdyn: str | None = key(
        "file",
        "input file of BeamDyn, with the blade file that it names, instead of lists: axis 1 is flapwise, the "
        "ends of the beam are those of the blade on the pitch axis",
        None,
        later=True,
    )
    windio: str | None = key(
        "file",
        "turbine in the ontology windIO, instead of lists: axis 1 is flapwise, or fore-aft; the ends are "
        "those of the pitch axis or of the tower",
        None,
        needs="component",
        later=True,
    )
    component: str | None = choice(COMPONENTS, "part of the windIO file", None, needs="windio", later=True)
    position: tuple[float, ...] = quantities(
        "dimensionless", "places from the first end, 0, to the second, 1", (), minimum=0.0, maximum=1.0
    )
    mass: tuple[float, ...] = quantities("mass_per_length", "mass per length", (), minimum=0.0)
    bending_1: tuple[float, ...] = _list(
        "bending_stiffness", "bending stiffness E I in the direction of axis 1", **_POSITIVE
    )
    bending_2: tuple[float, ...] = _list(
        "bending_stiffness", "bending stiffness E I in the direction of axis 2", **_POSITIVE
    )
    torsion: tuple[float, ...] = _list(
        "bending_stiffness",
        "torsional stiffness G J",
        "stiff: 100 times the larger bending stiffness",
        **_POSITIVE,
    )
    axial: tuple[float, ...] = _list(
        "force",
        "axial stiffness E A",
        "stiff: 1e4 times the larger bending stiffness over the square of the length",
        **_POSITIVE,
    )
    twist: tuple[float, ...] = _list(
        "angle", "rotation of axes 1 and 2 about the beam, from the first end to the second", "0"
    )
    center_1: tuple[float, ...] = _list(
        "length", "position of the centre of mass along the twisted axis 1", "0"
    )
    center_2: tuple[float, ...] = _list(
        "length", "position of the centre of mass along the twisted axis 2", "0"
    )
    gyration: tuple[float, ...] = _list(
        "length",
        "radius of gyration of the mass about its centre, along the beam",
        "that of a homogeneous section",
        minimum=0.0,
        later=True,
    )
    elastic_1: tuple[float, ...] = _list(
        "length",
        "position of the elastic centre, where a tensile force does not bend, along the twisted axis 1",
        "0",
        later=True,
    )
    elastic_2: tuple[float, ...] = _list(
        "length", "position of the elastic centre along the twisted axis 2", "0", later=True
    )
    shear_center_1: tuple[float, ...] = _list(
        "length",
        "position of the shear centre, where a transverse force does not twist, along the twisted axis 1",
        "that of the elastic centre",
        later=True,
    )
    shear_center_2: tuple[float, ...] = _list(
        "length",
        "position of the shear centre along the twisted axis 2",
        "that of the elastic centre",
        later=True,
    )
    shear_1: tuple[float, ...] = _list("force", f"{_SHEAR} 1", "no shear deflection", later=True, **_POSITIVE)
    shear_2: tuple[float, ...] = _list("force", f"{_SHEAR} 2", "no shear deflection", later=True, **_POSITIVE)
    stiffness: tuple[Matrix6, ...] = key(
        "matrices",
        "instead of stiffnesses and centres: stiffness matrix of the section at each place, in SI units. "
        "Forces along the twisted axes 1 and 2 and the beam, then moments about them, for the strains in this"
        " order",
        (),
        needs="inertia",
        later=True,
    )
    inertia: tuple[Matrix6, ...] = key(
        "matrices",
        "with stiffness, instead of mass, centre and radius of gyration: mass matrix of the section at each "
        "place, in the same order",
        (),
        needs="stiffness",
        later=True,
    )
    damping: tuple[float, ...] = _list(
        "time",
        "with stiffness: internal damping over stiffness for each of the six strains",
        "0",
        minimum=0.0,
        needs="stiffness",
        later=True,
    )
    offset_1: tuple[float, ...] = _list(
        "length",
        "prebend: position of the curved axis of the beam from the line between its ends, along axis 1 "
        "without twist",
        "0",
        later=True,
    )
    offset_2: tuple[float, ...] = _list(
        "length", "sweep: likewise along axis 2 without twist", "0", later=True
    )

    @property
    def further_files(self) -> tuple[str, ...]:
        """Files that the file of BeamDyn names."""
        if self.beamdyn is None:
            return ()
        from pitchpoint.model.openfast.beamdyn import beamdyn_files

        return beamdyn_files(self.beamdyn)

    @property
    def lists(self) -> dict[str, tuple[Any, ...]]:
        """The lists that are given, by key."""
        names = ("position", "mass", "bending_1", "bending_2", *OPTIONAL, *MATRICES)
        return {name: values for name in names if (values := getattr(self, name))}


OPTIONAL = (
    *("torsion", "axial", "twist", "center_1", "center_2", "gyration", "elastic_1", "elastic_2"),
    *("shear_center_1", "shear_center_2", "shear_1", "shear_2", "offset_1", "offset_2"),
)
"""Lists of `BeamProperties` that have defaults."""
MATRICES = ("stiffness", "inertia", "damping")
"""Section matrices of `BeamProperties`, and their damping."""
BESIDE_MATRICES = ("position", "twist", "offset_1", "offset_2", *MATRICES)
"""Lists that a beam with section matrices can have."""
FILES = ("elastodyn", "beamdyn", "windio")
"""Files that replace lists of `BeamProperties`."""
IN_FILE = ("mass", "bending_1", "bending_2", "twist")
"""Lists of `BeamProperties` that a file of ElastoDyn replaces."""


@dataclass(frozen=True, kw_only=True)
class Beam(Component):
    """Timoshenko beam between two points, clamped to both bodies, for large rotations and deflections."""

    ends: tuple[str, str] = key(
        "ends",
        "the two ends: ground, a body, BODY.MARKER or a station of another beam; free of load in "
        "the initial position",
        length=(2, 2),
    )
    section: BeamSection | None = component(BeamSection, "constant cross-section", None, one_of="section")
    properties: BeamProperties | None = component(
        BeamProperties,
        "instead of section and material: properties over the length, as of a blade or tower",
        None,
        one_of="section",
        later=True,
    )
    diameters: tuple[float, ...] = quantities(
        "length",
        "with properties: outer diameters at equal distances from the first to the second end, for the scene",
        (),
        minimum=0.0,
        above=True,
        display="3 % of the length",
        later=True,
    )
    axis: tuple[float, float, float] | None = quantities(
        "dimensionless",
        "direction of axis 1 of the section, in the world",
        None,
        length=(3, 3),
        display="x of the world, or y for a beam along x",
    )
    material: Material | str = key(
        "material", "name in materials or in the library, or the properties", "steel"
    )
    pieces: int = integer(
        "number of beam elements of equal length; between them are the stations BEAM.2, BEAM.3, ..., which "
        "can be named where BODY.MARKER can",
        4,
        minimum=1,
        maximum=1000,
    )
    internal_damping: float = quantity(
        "time",
        "internal damping over stiffness, in axes that rotate with the beam: the damping ratio of a mode is "
        "half of it times the angular frequency. Above 0 it replaces the damping of section matrices",
        0.0,
        minimum=0.0,
    )

    @cached_property
    def stations(self) -> dict[str, float]:
        """Positions of the stations between the elements by number, over the length of the beam [-].

        The ends, 1 and `pieces` + 1, belong to the bodies there.

        Examples
        --------
        >>> Beam(ends=("ground", "tip"), section=BeamSection(diameter=0.02), pieces=4).stations
        {'2': 0.25, '3': 0.5, '4': 0.75}
        """
        return {str(k + 1): k / self.pieces for k in range(1, self.pieces)}

    @property
    def material_data(self) -> Material:
        """Material properties, from the library if given by name."""
        from pitchpoint.geometry.materials import Material, material

        return self.material if isinstance(self.material, Material) else material(self.material)
