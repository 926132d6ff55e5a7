# SPDX-License-Identifier: Apache-2.0
"""Complete geometry of a rolling bearing from a designation, catalogue data or given rolling elements."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.bearings.clearance import CLASSED, axial_play, clearance_of
from pitchpoint.geometry.bearings.designation import Catalogued, by_designation
from pitchpoint.geometry.bearings.inner import (
    BALL_TYPES,
    GROOVES,
    INNER_SPHERE,
    NEEDLE_TYPES,
    ROW_SPACING,
    TYPES,
    WASHERS,
    InnerGeometry,
    inner_geometry,
)

if TYPE_CHECKING:
    from pitchpoint.model.components.rolling_bearing import RollingBearing

BOTH, POSITIVE, NEGATIVE, FLOATING = "both_directions", "positive", "negative", "no_direction"
ABSORPTION = (BOTH, POSITIVE, NEGATIVE, FLOATING)
GIVEN = ("ball", "roller")
"""Types whose rolling elements are given."""
INCLINED = ("angular_contact_ball", "tapered_roller", "thrust_ball")
"""Types with one contact angle: they support axial forces in one direction and do not float."""
ANGLED = (
    *("angular_contact_ball", "double_row_angular_contact_ball", "self_aligning_ball"),
    *("tapered_roller", "spherical_roller"),
)
"""Types whose contact angle is one of their catalogue data."""
CATALOGUE_ANGLE = dict.fromkeys(
    ("tapered_roller", "spherical_roller", "self_aligning_ball"), ": arctan(e/1.5) with e of the catalogue"
)
"""Where the contact angle is in a catalogue that lists the factor e instead."""
UPRIGHT = {
    "deep_groove_ball": "it follows from the clearance; with a nominal angle, use type: angular_contact_ball",
    "thrust_ball": "it is 90 deg; with another angle, use type: angular_contact_ball",
}
"""Contact angle of ball bearings in which it cannot be given, and what to use instead."""
BOUGHT = (
    *("inner_diameter", "outer_diameter", "width"),
    *("radial_dynamic_load_rating", "radial_static_load_rating"),
)
"""Keys of catalogue data."""
ELEMENTS = ("elements", "element_diameter", "pitch_diameter")
"""Keys of the rolling elements."""


@dataclass(frozen=True)
class BearingGeometry:
    """Rolling elements, boundary dimensions and clearance of a bearing.

    Attributes
    ----------
    kind
        "ball", "roller", or one of `geometry.bearings.inner.TYPES`.
    rows, elements
        Number of rows, and of rolling elements of a row.
    element_diameter, pitch_diameter
        Diameters [m].
    contact_angle
        Contact angle; > 0 supports an inner ring loaded in +z; of double-row bearings > 0 [rad].
    effective_length
        Effective length of a roller [m]; None for balls and for rollers of a given stiffness.
    grooves
        Groove radii of inner and outer ring over the ball diameter; None for rollers.
    clearance
        Radial internal clearance [m].
    clearance_class
        Its class; None if it is given or set on mounting.
    absorbs
        Axial forces on the shaft that the bearing supports, one of `ABSORPTION`.
    bore, outside, width
        Boundary dimensions [m]; None if only the elements are given.
    dynamic, static
        Load ratings [N]; None if only the elements are given.
    rated
        Dynamic load rating by ISO 281 with the estimated elements [N]; None without estimate.
    designation
        Designation in the table; None without.
    row_distance
        Distance of the rows of a rigid double-row bearing [m]; 0 for the others.
    axial_clearance
        Axial play between flanges of cylindrical rollers [m]; None without flanges.
    """

    kind: str
    rows: int
    elements: int
    element_diameter: float
    pitch_diameter: float
    contact_angle: float
    effective_length: float | None
    grooves: tuple[float, float] | None
    clearance: float
    clearance_class: str | None
    absorbs: str
    bore: float | None = None
    outside: float | None = None
    width: float | None = None
    dynamic: float | None = None
    static: float | None = None
    rated: float | None = None
    designation: str | None = None
    row_distance: float = 0.0
    axial_clearance: float | None = None

    @property
    def is_ball(self) -> bool:
        """Whether the contacts are points."""
        return self.kind == "ball" or self.kind in BALL_TYPES

    @property
    def one_shoulder(self) -> bool:
        """Whether the balls of a row have a shoulder on one side only and come apart in the other direction.

        Examples
        --------
        >>> from pitchpoint.model.components.rolling_bearing import RollingBearing
        >>> RollingBearing(designation="7208B", axial_force_absorption="positive").geometry.one_shoulder
        True
        >>> RollingBearing(designation="6208").geometry.one_shoulder
        False
        """
        one_way = self.absorbs in (POSITIVE, NEGATIVE) or self.kind == "double_row_angular_contact_ball"
        return self.is_ball and one_way

    @property
    def aligns(self) -> bool:
        """Whether the rings tilt without resistance."""
        return self.kind in ("spherical_roller", "self_aligning_ball")

    @property
    def floats(self) -> bool:
        """Whether the bearing follows the shaft along its axis."""
        return self.absorbs == FLOATING

    @property
    def groove_distance(self) -> float:
        """Distance of the groove centres [m]; 0 for rollers and without grooves."""
        return 0.0 if self.grooves is None else (sum(self.grooves) - 1.0) * self.element_diameter


def bearing_geometry(part: RollingBearing) -> BearingGeometry:
    """Complete geometry of a bearing; `RollingBearing.geometry` is this value, computed once.

    Raises
    ------
    GeometryError
        With the first problem, at the key of the component.
    """
    bought = _bought(part)
    if bought is None:
        return _given(part)
    if part.contact_angle is not None and bought.kind not in ANGLED:
        why = UPRIGHT.get(bought.kind, "it is 0; with an angle, use type: tapered_roller")
        raise GeometryError(
            f"does not apply to {bought.kind.replace('_', ' ')} bearings",
            where="contact_angle",
            value=f"{math.degrees(part.contact_angle):.6g} deg",
            remedy=f"remove it: {why}",
        )
    angle = bought.angle if part.contact_angle is None else abs(part.contact_angle)
    if bought.kind == "thrust_ball":
        angle = 0.5 * math.pi
    absorbs = _absorbs(part, bought)
    kind, bore = bought.kind, bought.bore
    if bought.raceway is not None:  # the inner ring only carries the raceway
        kind, bore = "needle_roller_on_shaft", bought.raceway
    inner = inner_geometry(kind, bore, bought.outside, bought.width, bought.dynamic, bought.static, angle)
    clearance, group = _clearance(part, bought)
    size = part.element_diameter or inner.element_diameter
    rigid = bought.kind == "double_row_angular_contact_ball"
    return BearingGeometry(
        kind=bought.kind,
        rows=inner.rows,
        elements=part.elements or inner.elements,
        element_diameter=size,
        pitch_diameter=part.pitch_diameter or inner.pitch_diameter,
        contact_angle=(-angle if absorbs == NEGATIVE else angle) + 0.0,  # no -0.0
        effective_length=part.effective_length or inner.effective_length,
        grooves=part.grooves or _grooves(bought.kind, inner, angle),
        clearance=clearance,
        clearance_class=group,
        absorbs=absorbs,
        bore=bought.bore,
        outside=bought.outside,
        width=bought.width,
        dynamic=bought.dynamic,
        static=bought.static,
        rated=inner.dynamic,
        designation=bought.designation or None,
        row_distance=ROW_SPACING * size if rigid else 0.0,
        axial_clearance=_axial_clearance(part, bought, absorbs),
    )


def _grooves(kind: str, inner: InnerGeometry, angle: float) -> tuple[float, float] | None:
    """Groove radii over the ball diameter; the outer one of a self-aligning bearing is a sphere."""
    if kind not in BALL_TYPES:
        return None
    if kind == "thrust_ball":
        return WASHERS
    if kind == "self_aligning_ball":
        around = inner.pitch_diameter / math.cos(angle) / inner.element_diameter
        return INNER_SPHERE, 0.5 * (1.0 + around)
    return GROOVES


def _axial_clearance(part: RollingBearing, bought: Catalogued, absorbs: str) -> float | None:
    """Axial play between the flanges of cylindrical rollers [m]; None without flanges."""
    if bought.kind != "cylindrical_roller" or absorbs == FLOATING:
        return None
    if part.axial_clearance is not None:
        return part.axial_clearance
    return 0.5 * sum(axial_play(bought.bore)) if absorbs == BOTH else 0.0


def _given(part: RollingBearing) -> BearingGeometry:
    """Geometry of a bearing with given rolling elements."""
    _together(part, ELEMENTS, "")
    values: Any = part
    angle = part.contact_angle or 0.0
    upright = FLOATING if part.type == "roller" or part.grooves is None else BOTH  # at a constant angle of 0
    absorbs = part.axial_force_absorption or (
        upright if angle == 0.0 else POSITIVE if angle > 0.0 else NEGATIVE
    )
    if part.axial_force_absorption is not None and absorbs in (POSITIVE, NEGATIVE):
        if angle == 0.0:
            raise GeometryError(
                "requires a contact angle",
                where="axial_force_absorption",
                value=absorbs,
                remedy="give contact_angle, or both_directions or no_direction",
            )
        angle = math.copysign(angle, 1.0 if absorbs == POSITIVE else -1.0)
    return BearingGeometry(
        kind=part.type or "ball",
        rows=1,
        elements=values.elements,
        element_diameter=values.element_diameter,
        pitch_diameter=values.pitch_diameter,
        contact_angle=angle,
        effective_length=part.effective_length if part.type == "roller" else None,
        grooves=part.grooves if part.type != "roller" else None,
        clearance=part.clearance or 0.0,
        clearance_class=None,
        absorbs=absorbs,
        bore=part.inner_diameter,
        outside=part.outer_diameter,
        width=part.width,
    )


def _bought(part: RollingBearing) -> Catalogued | None:
    """Catalogue data by designation or as given; None for given rolling elements."""
    if part.designation is not None:
        try:
            found = by_designation(part.designation)
        except GeometryError as error:
            told = error.problem
            raise GeometryError(
                told.text, where="designation", value=told.value, limit=told.limit, remedy=told.remedy
            ) from None
        if part.type is not None and part.type != found.kind:
            raise GeometryError(
                f"is not the type of {part.designation}",
                where="type",
                value=part.type,
                remedy=f"remove it, or write {found.kind}",
            )
        given = [name for name in BOUGHT if getattr(part, name) is not None]
        if given:
            raise GeometryError(
                f"is given in addition to designation: {part.designation}",
                where=given[0],
                remedy="remove one of them; with other load ratings, give type and all data instead of "
                "designation",
            )
        return found
    if part.type is None and part.elements is None:
        given = [name for name in BOUGHT if getattr(part, name) is not None]
        if given:
            raise GeometryError(
                f"gives {', '.join(given)} without type",
                remedy=f"add type ({', '.join(TYPES)}), or give designation",
            )
    if part.type is None or part.type in GIVEN:
        return None
    needed = (*BOUGHT, "contact_angle") if part.type in ANGLED else BOUGHT
    _together(part, needed, f" of a {part.type.replace('_', ' ')} bearing")
    values: Any = part
    if values.inner_diameter >= values.outer_diameter:
        raise GeometryError(
            "is not smaller than the outside diameter",
            where="inner_diameter",
            value=f"{values.inner_diameter * 1e3:.6g} mm",
            limit=f"< {values.outer_diameter * 1e3:.6g} mm",
            remedy="correct one of them",
        )
    return Catalogued(
        "",
        part.type,
        values.inner_diameter,
        values.outer_diameter,
        values.width,
        values.radial_dynamic_load_rating,
        values.radial_static_load_rating,
        angle=abs(part.contact_angle or 0.0),
        group=part.clearance_class,
    )


def _together(part: RollingBearing, names: tuple[str, ...], what: str) -> None:
    """Check that a bearing has all the named data."""
    missing = [name for name in names if getattr(part, name) is None]
    sets = f"type with {', '.join(BOUGHT)}, or {', '.join(ELEMENTS)} of given rolling elements"
    remedy = f"give designation, or {sets}"
    if missing == ["contact_angle"]:
        remedy = f"add contact_angle{CATALOGUE_ANGLE.get(str(part.type), ' of the catalogue')}"
    if missing:
        raise GeometryError(f"has no {', '.join(missing)}{what}", remedy=remedy)


def _absorbs(part: RollingBearing, bought: Catalogued) -> str:
    """Axial forces that a bearing of the catalogue supports."""
    kind = bought.kind
    asked = part.axial_force_absorption
    allowed: tuple[str, ...] = (BOTH, FLOATING)
    usual: str | None = BOTH
    if kind in INCLINED:
        allowed, usual = (POSITIVE, NEGATIVE), None
        if part.contact_angle is not None and part.contact_angle < 0.0:
            usual = NEGATIVE
    elif kind in NEEDLE_TYPES:
        allowed, usual = (FLOATING,), FLOATING
    elif kind == "cylindrical_roller":
        allowed, usual = _flanges(bought)
    asked = asked or usual
    if asked not in allowed:
        name = part.designation if kind == "cylindrical_roller" and part.designation else None
        bearings = name or f"{kind.replace('_', ' ')} bearings"
        why = f"is required for {bearings}" if asked is None else f"does not apply to {bearings}"
        remedy = f"write {' or '.join(allowed)}"
        if POSITIVE in allowed:
            remedy += ": the axial force on the shaft that the bearing supports, along z of the bearing"
        if allowed == (FLOATING,):
            why += ", which has no flanges" if name else ", which have no flanges"
            remedy = "use NJ (one direction) or NUP (both)" if name else "remove it"
            remedy += ", or hold the shaft by another bearing"
        raise GeometryError(why, where="axial_force_absorption", value=asked, remedy=remedy)
    return asked


def _flanges(bought: Catalogued) -> tuple[tuple[str, ...], str | None]:
    """Possible and usual axial support of a cylindrical roller bearing, by its design if that is known."""
    if not bought.designation:
        return ABSORPTION, FLOATING
    return (
        ((FLOATING,), FLOATING),
        ((POSITIVE, NEGATIVE, FLOATING), None),
        ((BOTH, FLOATING), BOTH),
    )[bought.flanges]


def _clearance(part: RollingBearing, bought: Catalogued) -> tuple[float, str | None]:
    """Radial internal clearance [m] and its class."""
    if part.clearance_class is not None:
        if part.clearance is not None:
            raise GeometryError(
                "is given in addition to clearance", where="clearance_class", remedy="remove one of them"
            )
        if bought.kind not in CLASSED:
            raise GeometryError(
                f"does not apply to {bought.kind.replace('_', ' ')} bearings, whose clearance has no classes",
                where="clearance_class",
                remedy="give clearance or preload",
            )
        if bought.designation and bought.group not in (None, part.clearance_class):
            raise GeometryError(
                f"contradicts the suffix {bought.group} of designation: {part.designation}",
                where="clearance_class",
                value=part.clearance_class,
                remedy="remove one of them",
            )
    if part.clearance is not None:
        return part.clearance, None
    if bought.kind not in CLASSED or part.preload is not None or part.preload_distance is not None:
        return 0.0, None
    group = part.clearance_class or bought.group or "CN"
    low, high = clearance_of(bought.kind, bought.bore, group)
    return 0.5 * (low + high), group
