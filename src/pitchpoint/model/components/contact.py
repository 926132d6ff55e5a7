# SPDX-License-Identifier: Apache-2.0
"""Contacts between bodies: normal force, friction, and shapes of the contact partners."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.component import Component
from pitchpoint.model.keys import (
    REQUIRED,
    boolean,
    choice,
    component,
    ends,
    integer,
    key,
    positive,
    quantities,
    quantity,
)

ENDS = "the two bodies, each of them ground, a body or BODY.MARKER; the shapes refer to these axes"
CURVES = ("circle", "polygon", "spline", "involute")
SURFACES = ("plane", "sphere", "cylinder", "cone", "torus", "triangles")
REBOUND_SPEED = 1e-3
"""Default separation speed at which the rebound force of `every_speed` is reached [m/s]."""


@dataclass(frozen=True, kw_only=True)
class ContactLaw(Component):
    """Normal force: elastic force F (u/u_0)^e of the penetration u, with damping or restitution."""

    force: float = positive("force", "elastic force F at the penetration `depth`")
    depth: float = positive("length", "penetration u_0 at which the elastic force is `force`")
    exponent: float = quantity(
        "dimensionless", "exponent e; 1.5 for Hertzian point contact", 1.5, minimum=1.0, maximum=5
    )
    damping: float = quantity("damping", "damping coefficient at full effect", 0.0, minimum=0.0)
    full_damping: float = quantity(
        "length",
        "penetration at which the damping reaches its full value; below, it increases smoothly",
        0.0,
        minimum=0.0,
    )
    restitution: float | None = quantity(
        "dimensionless",
        "instead of damping: coefficient of restitution",
        None,
        minimum=0.0,
        above=True,
        maximum=1.0,
    )
    speed: float | None = positive(
        "speed",
        "impact speed at which the restitution applies; with every_speed the separation speed at which the "
        "force has fallen to its rebound value: choose at most a tenth of the impact speeds",
        None,
        display="1 m/s, with every_speed 1 mm/s",
    )
    every_speed: bool = boolean("the same restitution at all impact speeds well above `speed`", False)

    @property
    def reference_speed(self) -> float:
        """`speed`, or its default [m/s]."""
        return self.speed or (REBOUND_SPEED if self.every_speed else 1.0)


@dataclass(frozen=True, kw_only=True)
class ContactFriction(Component):
    """Regularised friction: the coefficient rises to the static and falls to the dynamic value, smoothly."""

    static: float = quantity("dimensionless", "static coefficient of friction", minimum=0.0, maximum=10.0)
    dynamic: float = quantity(
        "dimensionless",
        "dynamic coefficient of friction",
        minimum=0.0,
        maximum=10.0,
        also=("mu", "coefficient"),
    )
    static_speed: float = positive(
        "speed", "sliding velocity at which the static coefficient is reached", 1e-3
    )
    slip_speed: float = positive(
        "speed", "sliding velocity above which the dynamic coefficient applies", 1e-2
    )


@dataclass(frozen=True, kw_only=True)
class ContactCurve(Component):
    """A curve in the x-y plane of a marker, with the material on its left in the order of its points."""

    shape: str = choice(
        CURVES,
        "circle: radius, centre x and y; polygon: corners x, y and radii; spline: points x, y; involute: "
        "base radius, start and end of the roll angle",
    )
    radius: float | None = positive("length", "radius of the circle, or base radius of the involute", None)
    x: tuple[float, ...] = quantities("length", "x of the points in order, material on the left", ())
    y: tuple[float, ...] = quantities("length", "y of the points", ())
    radii: tuple[float, ...] = quantities("length", "polygon: corner radii", (), minimum=0.0)
    closed: bool = boolean("polygon, spline: closed curve, the last point is connected to the first", True)
    hollow: bool = boolean("circle: material outside (bore)", False)
    phase: float = quantity("angle", "involute: polar angle of its start on the base circle", 0.0)
    roll: tuple[float, ...] = quantities("angle", "involute: roll angles of start and end", ())
    hand: str = choice(("left", "right"), "involute: left unwinds counter-clockwise, right clockwise", "left")


@dataclass(frozen=True, kw_only=True)
class CamContact(Component):
    """A point or roller of the first body on a curve of the second."""

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    curve: ContactCurve = component(ContactCurve, "curve of the second body", REQUIRED)
    radius: float = quantity("length", "radius of the roller; 0 for a point", 0.0, minimum=0.0)
    permanent: bool = boolean("permanent contact: a constraint without law and friction", False)
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; frictionless if omitted")
    depth: float | None = positive(
        "length",
        "largest penetration that counts as contact; deeper points are on another side",
        None,
        display="5 % of the size; if all penetrate deeper, the nearest side",
    )


@dataclass(frozen=True, kw_only=True)
class CurveContact(Component):
    """Curves of two bodies in one plane."""

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    first: ContactCurve = component(ContactCurve, "curve of the first body", REQUIRED)
    second: ContactCurve = component(ContactCurve, "curve of the second body", REQUIRED)
    permanent: bool = boolean("permanent contact: a constraint without law and friction", False)
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; frictionless if omitted")
    depth: float | None = positive(
        "length",
        "largest penetration that counts as contact; deeper points are on another side",
        None,
        display="5 % of the smaller curve; if all penetrate deeper, the nearest side",
    )
    margin: float | None = positive(
        "length", "largest gap within which contacts are searched", None, display="half the smaller curve"
    )


@dataclass(frozen=True, kw_only=True)
class ContactSurface(Component):
    """A surface in the axes of a marker.

    Triangles are read from an STL file, binary or text, or from a NumPy file with corners of shape (n, 3, 3),
    in the axes of the marker and in the given unit. Their corners are counter-clockwise seen from outside.
    """

    shape: str = choice(
        SURFACES,
        "plane: z = 0, material below; sphere, cylinder (about z), cone (opens downwards), torus (about z); "
        "triangles from a file",
    )
    radius: float | None = positive(
        "length", "radius of sphere or cylinder; torus: radius of the centre circle", None
    )
    tube: float | None = positive("length", "torus: tube radius", None)
    length: float | None = positive(
        "length",
        "cylinder: length between flat ends, centred at the origin; infinite against a sphere, and if "
        "omitted; cone: height from the tip to its base, infinite against a sphere or triangles",
        None,
    )
    half_angle: float | None = positive("angle", "cone: angle between the axis and the surface", None)
    size: tuple[float, float] | None = quantities(
        "length",
        "plane: sides along x and y of a plate, centred at the origin, that touches another plane",
        None,
        length=(2, 2),
        minimum=0.0,
        above=True,
    )
    hollow: bool = boolean("material outside; reverses triangles", False)
    file: str | None = key("file", "triangles: .stl or .npy file", None)
    unit: float | None = positive(
        "length", "triangles: length of one unit of the file; STL files do not contain theirs", None
    )
    open: bool = boolean("triangles: the surface may be open; no contact may come near its edges", False)


@dataclass(frozen=True, kw_only=True)
class SurfaceContact(Component):
    """Surfaces of two bodies in space.

    All pairs are possible; of two planes one is a plate with a `size`. For line contact (cylinder or cone on
    a plane, cylinders) the law applies to the whole line, for two planes to the whole plate; for triangles
    with any surface except a sphere it applies per square metre; otherwise to each contact point.
    """

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    first: ContactSurface = component(ContactSurface, "surface of the first body", REQUIRED)
    second: ContactSurface = component(ContactSurface, "surface of the second body", REQUIRED)
    permanent: bool = boolean(
        "permanent contact of a sphere with a surface other than triangles: a constraint without law and "
        "friction",
        False,
    )
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; frictionless if omitted")
    depth: float | None = positive(
        "length",
        "triangles, plate: largest penetration that counts as contact",
        None,
        display="fraction of the size",
    )
    line: bool = boolean(
        "two cylinders: line contact, the law applies to the whole length of the shorter cylinder; otherwise "
        "point contact where they cross; torus on a cylinder, cone or torus: law for the whole ring; sphere "
        "in a hollow cone or in the hole of a torus: law for the whole circle",
        False,
    )
    stations: int = integer("Gauss points per segment of the contact line", 8, minimum=1, maximum=8)
