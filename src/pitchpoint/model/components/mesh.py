# SPDX-License-Identifier: Apache-2.0
"""A pair of gears in mesh: position, backlash, stiffness, damping and friction."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from pitchpoint.model.component import Component
from pitchpoint.model.components.flank_contact import LEVELS, FlankContact
from pitchpoint.model.components.stiffness import LAWS, Din3990, StiffnessLaw
from pitchpoint.model.keys import choice, component, derived, integer, key, positive, quantities, quantity

# The damping is a property of the mesh: a scenario that fixes or drives a body does not change it.
CRITICAL = (
    "fraction of critical damping, from the mean stiffness and the inertias of both bodies and of the bodies "
    "attached to them (also those that a scenario fixes or drives, but not those with motion: fixed)"
)


@dataclass(frozen=True, kw_only=True)
class Backlash(Component):
    """Backlash at the centre distance of the mesh: in one of three directions, or relative to the module."""

    normal: float | None = quantity("length", "normal backlash j_bn", None, one_of="gap")
    base_tangent: float | None = quantity(
        "length", "backlash along the base tangent, j_bt", None, one_of="gap"
    )
    circumferential: float | None = quantity(
        "length", "circumferential backlash j_wt at the working pitch circle", None, one_of="gap"
    )
    factor: float | None = quantity(
        "dimensionless",
        "backlash factor: circumferential backlash over normal module",
        None,
        one_of="gap",
        later=True,
    )


@dataclass(frozen=True, kw_only=True)
class ContactDamping(Component):
    """Damping of flanks in contact; give one of d_in (with d_out), ratio, pair, restitution."""

    d_in: float | None = quantity(
        "damping", "damping while the flanks approach", None, minimum=0.0, one_of="law"
    )
    d_out: float | None = quantity(
        "damping", "damping while the flanks separate", None, minimum=0.0, display="d_in", needs="d_in"
    )
    ratio: float | None = quantity("dimensionless", CRITICAL, None, minimum=0.0, maximum=10.0, one_of="law")
    pair: float | None = quantity(
        "damping",
        "damping of one tooth pair normal to the flanks, as in an impact force law",
        None,
        minimum=0.0,
        one_of="law",
    )
    restitution: float | None = quantity(
        "dimensionless",
        "coefficient of restitution of an impact",
        None,
        one_of="law",
        minimum=0.0,
        above=True,
        maximum=1.0,
    )
    speed: float = positive("speed", "impact speed at which the restitution applies", 1.0)
    s_0: float = quantity(
        "length",
        "penetration at which the damping reaches its full value (below it only the part given by `law`); "
        "keep it below the static penetration under load",
        1e-6,
        minimum=0.0,
    )
    law: str = choice(("linear", "smooth"), "increase of the damping between 0 and s_0", "linear")


@dataclass(frozen=True, kw_only=True)
class Damper(Component):
    """Damper between the gears that also acts within the backlash; give exactly one key."""

    ratio: float | None = quantity("dimensionless", CRITICAL, None, minimum=0.0, maximum=10.0, one_of="law")
    value: float | None = quantity(
        "damping", "damping along the base tangent", None, minimum=0.0, one_of="law"
    )


@dataclass(frozen=True, kw_only=True)
class TransientDamping(Component):
    """Damper between the gears that shortens the transient at the start of a run.

    Its torque on gear 1 is proportional to the difference of the speed of gear 1 from that of gear 2 times
    the ratio; the torque on gear 2 is conjugate to it.
    """

    rate: float = positive("torsional_damping", "torque on gear 1 over the difference of the speeds")
    until: float = positive(
        "time", "end of the damping; it decreases to zero over the last tenth of this time"
    )


@dataclass(frozen=True, kw_only=True)
class Friction(Component):
    """Flank friction, smoothed around zero sliding velocity, optionally with a static coefficient."""

    mu: float = quantity(
        "dimensionless", "coefficient of friction", minimum=0.0, maximum=2.0, also=("coefficient", "dynamic")
    )
    v_eps: float = positive("speed", "sliding velocity above which mu applies", 0.01)
    static: float | None = quantity(
        "dimensionless",
        "static coefficient of friction, at static_speed",
        None,
        minimum=0.0,
        maximum=2.0,
        display="mu",
        needs="static_speed",
    )
    static_speed: float | None = positive(
        "speed",
        "sliding velocity of the static coefficient, below v_eps",
        None,
        display="v_eps",
        needs="static",
    )


@dataclass(frozen=True, kw_only=True)
class TransmissionError(Component):
    """Prescribed static transmission error e along the base tangent; springs and dampers act on u_bt - e.

    cosine and sine are harmonics 1, 2, ... of the mesh phase 2 pi psi; shaft1 and shaft2 are orders of the
    angle of the gear: e += amplitude * cos(order * angle + phase).
    """

    cosine: tuple[float, ...] = quantities("length", "cosine amplitudes of harmonics 1, 2, ...", ())
    sine: tuple[float, ...] = quantities("length", "sine amplitudes of harmonics 1, 2, ...", ())
    shaft1: tuple[tuple[int, float, float], ...] = key(
        "orders", "order: [amplitude, phase] over the angle of gear 1; stored as (order, m, rad)", ()
    )
    shaft2: tuple[tuple[int, float, float], ...] = key(
        "orders", "order: [amplitude, phase] over the angle of gear 2; stored as (order, m, rad)", ()
    )


STEEPEST = 0.1
"""Maximum misalignment of shaft axes, and of flanks in their plane of action [rad]."""


@dataclass(frozen=True, kw_only=True)
class Misalignment(Component):
    """Shaft axes misaligned by the housing: tilt of axis 2 relative to axis 1, towards positive z."""

    in_plane: float = quantity(
        "angle",
        "tilt in the plane of both axes, f_Sigma_delta over the bearing span; positive along the line from "
        "gear 1 to the pitch point",
        0.0,
        minimum=-STEEPEST,
        maximum=STEEPEST,
    )
    out_of_plane: float = quantity(
        "angle",
        "tilt across that plane, f_Sigma_beta over the bearing span; positive 90 deg counter-clockwise of "
        "that line",
        0.0,
        minimum=-STEEPEST,
        maximum=STEEPEST,
    )
    severity: float = quantity(
        "dimensionless", "scales both tilts: 0 aligned, 1 the given values", 1.0, minimum=0.0, maximum=1.0
    )

    @property
    def skew(self) -> tuple[float, float]:
        """Tilt across the plane of the axes and in it [rad]."""
        return self.severity * self.out_of_plane, self.severity * self.in_plane

    def of_flanks(self, pressure_angle: float, flank: int = 1) -> float:
        """Misalignment of the front (1) or back (-1) flanks in their plane of action [rad]; gap towards +z.

        Parameters
        ----------
        pressure_angle
            Transverse working pressure angle α_wt [rad].
        """
        across, in_plane = self.skew
        return flank * math.cos(pressure_angle) * across + math.sin(pressure_angle) * in_plane


@dataclass(frozen=True, kw_only=True)
class Mesh(Component):
    """Two gears in mesh."""

    gears: tuple[str, str] = key("names", "names of gear 1 and gear 2", length=(2, 2), names="gears")
    center_distance: float | None = positive(
        "length",
        "centre distance, positive also for internal pairs",
        None,
        maximum=50.0,
        display="zero backlash from both x",
    )
    direction: float | None = quantity(
        "angle",
        "angle from the x axis of the body of gear 1 to the line of centres from gear 1 to gear 2",
        None,
        display="0, or from the positions of the bodies",
    )
    backlash: Backlash | None = component(
        Backlash, "backlash at center_distance, instead of that from geometry"
    )
    stiffness: StiffnessLaw = key("variant", "mesh stiffness", Din3990(), of=LAWS, display="law: din3990")
    contact: FlankContact | None = key(
        "variant",
        "contact of the tooth surfaces, instead of a stiffness law",
        None,
        of=LEVELS,
        tag="level",
        later=True,
    )
    width: str = choice(
        ("exact", "slices"),
        "integration over the face width; flanks with modifications, deviations or a tooth profile are "
        "always divided into slices",
        "exact",
    )
    slices: int = integer(
        "number of slices over the face width, with width: slices or modified flanks",
        11,
        minimum=1,
        maximum=1001,
    )
    damping: ContactDamping | None = component(ContactDamping, "damping of flanks in contact")
    damper: Damper | None = component(Damper, "damper that also acts within the backlash")
    transient_damping: TransientDamping | None = component(
        TransientDamping, "damper for the start of a run", later=True
    )
    friction: Friction | None = component(Friction, "sliding friction of the flanks")
    transmission_error: TransmissionError | None = component(TransmissionError, "static transmission error")
    misalignment: Misalignment | None = component(Misalignment, "shaft axes misaligned by the housing")

    @property
    def law(self) -> StiffnessLaw:
        """Contact of the tooth surfaces if it is given, else the stiffness law."""
        return self.stiffness if self.contact is None else self.contact

    stage: str | None = derived()
    """Planetary stage, or path of the scissor gear, that contains the mesh, if any."""
    given: Any = derived()
    """The mesh as given, if the damping of its oil film follows from the lubricant."""
    a_w: float | None = derived()
    """Effective centre distance [m], signed as in ISO 21771 (negative for internal pairs)."""
    offset1: float = derived(0.0)
    """Axial position of the middle of the common face width relative to the mid-face of gear 1 [m]."""
    offset2: float = derived(0.0)
    """Axial position of the middle of the common face width relative to the mid-face of gear 2 [m]."""
    b_w: float | None = derived()
    """Common face width [m]."""
    theta: float = derived(0.0)
    """Effective angle from the x axis of the body of gear 1 to the line of centres [rad]."""
    twist: float = derived(0.0)
    """Angle from the x axis of the body of gear 1 to that of gear 2 [rad]."""
