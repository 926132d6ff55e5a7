# SPDX-License-Identifier: Apache-2.0
"""A pair of gears in mesh: places, backlash, and the laws of their flanks."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.stiffness import LAWS, Din3990, StiffnessLaw
from pitchpoint.model.keys import choice, component, derived, integer, key, positive, quantities, quantity

# The damping belongs to the mesh: a scenario that holds or drives a body does not change it.
CRITICAL = (
    "share of critical damping, from the mean stiffness and the inertias of both bodies and of what hangs "
    "on them (those that a scenario holds or drives too; not those with motion: fixed)"
)


@dataclass(frozen=True, kw_only=True)
class Backlash:
    """Total gap at the centre distance of the mesh; exactly one of the three directions is given."""

    normal: float | None = quantity("length", "total gap normal to the flanks, j_bn", None, one_of="gap")
    base_tangent: float | None = quantity(
        "length", "total gap along the base tangent, j_bt", None, one_of="gap"
    )
    circumferential: float | None = quantity(
        "length", "total gap along the working circle, j_wt", None, one_of="gap"
    )


@dataclass(frozen=True, kw_only=True)
class ContactDamping:
    """Damping of the flanks while they touch; one of d_in (with d_out), ratio, pair, restitution."""

    d_in: float | None = quantity(
        "damping", "damping while the flanks approach", None, minimum=0.0, one_of="law"
    )
    d_out: float | None = quantity(
        "damping", "damping while they move apart", None, minimum=0.0, display="d_in", needs="d_in"
    )
    ratio: float | None = quantity("dimensionless", CRITICAL, None, minimum=0.0, maximum=10.0, one_of="law")
    pair: float | None = quantity(
        "damping",
        "damping of one tooth pair normal to its flanks, as of an impact force",
        None,
        minimum=0.0,
        one_of="law",
    )
    restitution: float | None = quantity(
        "dimensionless",
        "share of the speed that an impact gives back",
        None,
        one_of="law",
        minimum=0.0,
        above=True,
        maximum=1.0,
    )
    speed: float = positive("speed", "speed of the impact at which the restitution holds", 1.0)
    s_0: float = quantity(
        "length",
        "penetration at which the damping reaches its full value (below it only the part given by `law`); "
        "keep it below the static penetration under load",
        1e-6,
        minimum=0.0,
    )
    law: str = choice(("linear", "smooth"), "growth of the damping from 0 to s_0", "linear")


@dataclass(frozen=True, kw_only=True)
class Damper:
    """Damper between the gears that also acts inside the gap; exactly one key is given."""

    ratio: float | None = quantity("dimensionless", CRITICAL, None, minimum=0.0, maximum=10.0, one_of="law")
    value: float | None = quantity(
        "damping", "damping along the base tangent", None, minimum=0.0, one_of="law"
    )


@dataclass(frozen=True, kw_only=True)
class Friction:
    """Friction of the flanks, smoothed around zero sliding velocity, with a static coefficient or without."""

    mu: float = quantity("dimensionless", "coefficient of friction", minimum=0.0, maximum=2.0)
    v_eps: float = positive("speed", "sliding velocity from which on mu holds", 0.01)
    static: float | None = quantity(
        "dimensionless",
        "static coefficient, at static_speed",
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
class TransmissionError:
    """Static transmission error e along the base tangent; springs and dampers act on u_bt - e.

    cosine and sine run over the mesh phase (harmonics 1, 2, ... of 2 pi psi); shaft1 and shaft2 over the
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


@dataclass(frozen=True, kw_only=True)
class Misalignment:
    """Axes tilted by the housing: tilt of axis 2 against axis 1, on its way up z."""

    in_plane: float = quantity(
        "angle",
        "tilt in the plane of both axes, f_Sigma_delta over the span, positive along the line from gear 1 to "
        "the pitch point",
        0.0,
        minimum=-0.1,
        maximum=0.1,
    )
    out_of_plane: float = quantity(
        "angle",
        "tilt across that plane, f_Sigma_beta over the span, positive a quarter turn counter-clockwise of it",
        0.0,
        minimum=-0.1,
        maximum=0.1,
    )
    severity: float = quantity(
        "dimensionless", "share of both that is there: 0 is aligned", 1.0, minimum=0.0, maximum=1.0
    )

    @property
    def skew(self) -> tuple[float, float]:
        """Tilt across the plane of the axes and in it [rad]."""
        return self.severity * self.out_of_plane, self.severity * self.in_plane


@dataclass(frozen=True, kw_only=True)
class Mesh:
    """Two gears in mesh."""

    gears: tuple[str, str] = key("names", "names of gear 1 and gear 2", length=(2, 2), names="gears")
    center_distance: float | None = positive(
        "length",
        "centre distance, positive for internal pairs too",
        None,
        maximum=50.0,
        display="zero backlash from both x",
    )
    direction: float | None = quantity(
        "angle",
        "angle of the line of centres from gear 1 to gear 2, from the x axis of the body of gear 1",
        None,
        display="0, or from the positions of the bodies",
    )
    backlash: Backlash | None = component(
        Backlash, "total gap at center_distance, instead of the one of the geometry"
    )
    stiffness: StiffnessLaw = key("variant", "mesh stiffness", Din3990(), of=LAWS, display="law: din3990")
    width: str = choice(
        ("exact", "slices"),
        "how the face width is integrated; flanks with modifications, deviations or profiles of their own "
        "are always cut into slices",
        "exact",
    )
    slices: int = integer(
        "number of slices when width is 'slices' or flanks have a shape of their own",
        11,
        minimum=1,
        maximum=1001,
    )
    damping: ContactDamping | None = component(ContactDamping, "damping of touching flanks")
    damper: Damper | None = component(Damper, "damper that also acts inside the gap")
    friction: Friction | None = component(Friction, "sliding friction of the flanks")
    transmission_error: TransmissionError | None = component(TransmissionError, "static transmission error")
    misalignment: Misalignment | None = component(Misalignment, "axes tilted by the housing")
    a_w: float | None = derived()
    """Centre distance in force [m], signed as in ISO 21771 (negative for internal pairs)."""
    offset1: float = derived(0.0)
    """Axial position of the middle of the common face width on gear 1, from its mid-face [m]."""
    offset2: float = derived(0.0)
    """Axial position of the middle of the common face width on gear 2, from its mid-face [m]."""
    b_w: float | None = derived()
    """Common face width [m]."""
    theta: float = derived(0.0)
    """Angle of the line of centres in force, from gear 1 to gear 2 and from the x axis of its body [rad]."""
    twist: float = derived(0.0)
    """Angle of the x axis of the body of gear 2, from that of gear 1 [rad]."""
