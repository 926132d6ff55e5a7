# SPDX-License-Identifier: Apache-2.0
"""Contacts between bodies: laws of force and friction, shapes, and what touches what."""

from __future__ import annotations

from dataclasses import dataclass

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

ENDS = "the two bodies, each of them ground, a body or BODY.MARKER; shapes lie in the axes of these"
CURVES = ("circle", "polygon", "spline", "involute")
SURFACES = ("plane", "sphere", "cylinder", "cone", "torus", "triangles")
REBOUND_SPEED = 1e-3
"""Speed of separation at which a restitution for every speed has its full effect, unless given [m/s]."""


@dataclass(frozen=True, kw_only=True)
class ContactLaw:
    """Normal force: elastic force F (u/u_0)^e over the overlap u, with damping or a restitution."""

    force: float = positive("force", "elastic force F at the overlap `depth`")
    depth: float = positive("length", "overlap u_0 at which the elastic force is `force`")
    exponent: float = quantity(
        "dimensionless", "exponent e; 1.5 for rounded bodies", 1.5, minimum=1.0, maximum=5
    )
    damping: float = quantity("damping", "damping of the fully damped contact", 0.0, minimum=0.0)
    full_damping: float = quantity(
        "length", "overlap from which on the damping is all there; below it grows smoothly", 0.0, minimum=0.0
    )
    restitution: float | None = quantity(
        "dimensionless",
        "instead of damping: share of the speed that an impact gives back",
        None,
        minimum=0.0,
        above=True,
        maximum=1.0,
    )
    speed: float | None = positive(
        "speed",
        "impact speed at which the restitution holds; with every_speed the speed of separation at which the "
        "force has fallen to its rebound value: keep it a tenth of the impact speeds or less",
        None,
        display="1 m/s, with every_speed 1 mm/s",
    )
    every_speed: bool = boolean("the same restitution at all impact speeds well above `speed`", False)

    @property
    def reference_speed(self) -> float:
        """`speed`, or the default of its law [m/s]."""
        return self.speed or (REBOUND_SPEED if self.every_speed else 1.0)


@dataclass(frozen=True, kw_only=True)
class ContactFriction:
    """Friction that rises to a static coefficient and falls to a dynamic one, both with smooth steps."""

    static: float = quantity("dimensionless", "static coefficient", minimum=0.0, maximum=10.0)
    dynamic: float = quantity("dimensionless", "dynamic coefficient", minimum=0.0, maximum=10.0)
    static_speed: float = positive("speed", "sliding velocity of the static coefficient", 1e-3)
    slip_speed: float = positive("speed", "sliding velocity from which on the dynamic one holds", 1e-2)


@dataclass(frozen=True, kw_only=True)
class ContactCurve:
    """A curve in the plane of a marker, walked with the material on its left."""

    shape: str = choice(
        CURVES,
        "circle: radius, x and y of its centre; polygon: corners x, y and radii; spline: points x, y; "
        "involute: radius of the base circle, start and end of the roll",
    )
    radius: float | None = positive("length", "radius of the circle or of the base circle", None)
    x: tuple[float, ...] = quantities("length", "x of the points in the order they are walked", ())
    y: tuple[float, ...] = quantities("length", "y of the points", ())
    radii: tuple[float, ...] = quantities("length", "polygon: radius at every corner", (), minimum=0.0)
    closed: bool = boolean("polygon, spline: whether the last point is joined to the first", True)
    hollow: bool = boolean("circle: material outside", False)
    phase: float = quantity("angle", "involute: angle at which it leaves the base circle", 0.0)
    roll: tuple[float, ...] = quantities("angle", "involute: angles of roll where it begins and ends", ())
    hand: str = choice(("left", "right"), "involute: unwinds counter-clockwise or clockwise", "left")


@dataclass(frozen=True, kw_only=True)
class CamContact:
    """A point or roller of the first body on a curve of the second."""

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    curve: ContactCurve = component(ContactCurve, "the curve of the second body", REQUIRED)
    radius: float = quantity("length", "radius of the roller; 0 for a point", 0.0, minimum=0.0)
    permanent: bool = boolean("never parts: a constraint without law and friction", False)
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; none without")
    depth: float | None = positive(
        "length",
        "deepest overlap that counts; what overlaps more is another side",
        None,
        display="5 % of the size; if all overlap more, the nearest side",
    )


@dataclass(frozen=True, kw_only=True)
class CurveContact:
    """Curves of two bodies in one plane."""

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    first: ContactCurve = component(ContactCurve, "the curve of the first body", REQUIRED)
    second: ContactCurve = component(ContactCurve, "the curve of the second body", REQUIRED)
    permanent: bool = boolean("never parts: a constraint without law and friction", False)
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; none without")
    depth: float | None = positive(
        "length",
        "deepest overlap that counts; what overlaps more is another side",
        None,
        display="5 % of the smaller curve; if all overlap more, the nearest side",
    )
    margin: float | None = positive(
        "length", "largest gap that is looked for", None, display="half the smaller curve"
    )


@dataclass(frozen=True, kw_only=True)
class ContactSurface:
    """A surface in the axes of a marker.

    Triangles come from an STL file, binary or text, or from a NumPy file with corners of shape (n, 3, 3), in
    the axes of the marker and in the given unit. They run counter-clockwise seen from outside.
    """

    shape: str = choice(
        SURFACES,
        "plane: z = 0, material below; sphere, cylinder (about z), cone (opens downwards), torus (about z); "
        "triangles from a file",
    )
    radius: float | None = positive("length", "of sphere, cylinder or ring of the torus", None)
    tube: float | None = positive("length", "torus: radius of its tube", None)
    length: float | None = positive(
        "length",
        "cylinder: its length between flat ends, its middle at the origin; infinite against a sphere or "
        "triangles",
        None,
    )
    half_angle: float | None = positive("angle", "cone: angle between axis and surface", None)
    hollow: bool = boolean("material outside; triangles are reversed", False)
    file: str | None = key("file", "triangles: their file, .stl or .npy", None)
    unit: float | None = positive(
        "length", "triangles: length of one unit of the file; STL files do not contain theirs", None
    )
    open: bool = boolean("triangles: the surface may have borders, which nothing gets near to", False)


@dataclass(frozen=True, kw_only=True)
class SurfaceContact:
    """Surfaces of two bodies in space.

    A sphere against anything, a cylinder or torus on a plane, cylinders crossed, parallel or one in
    the bore of the other, triangles against anything. The law counts for the whole line of cylinders along
    their length, and of triangles against anything but a sphere for one square metre.
    """

    ends: tuple[str, str] = ends(ENDS, length=(2, 2))
    first: ContactSurface = component(ContactSurface, "the surface of the first body", REQUIRED)
    second: ContactSurface = component(ContactSurface, "the surface of the second body", REQUIRED)
    permanent: bool = boolean(
        "a sphere that never leaves a surface other than triangles: a constraint without law and friction",
        False,
    )
    law: ContactLaw | None = component(ContactLaw, "normal force; required unless permanent")
    friction: ContactFriction | None = component(ContactFriction, "friction; none without")
    depth: float | None = positive(
        "length", "triangles: deepest overlap that counts", None, display="a part of the size"
    )
    line: bool = boolean(
        "two cylinders: they touch along their length, the law is that of the whole of the shorter one; "
        "otherwise at the one place where they cross",
        False,
    )
    stations: int = integer("Gauss points along every part of a line in touch", 8, minimum=1, maximum=8)
