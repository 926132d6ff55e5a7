# SPDX-License-Identifier: Apache-2.0
"""What is done to a model: speeds, prescribed motions, duration, sweeps, outputs."""

from __future__ import annotations

from dataclasses import dataclass

from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import choice, component, integer, key, positive, quantities, quantity, text

STIFF_METHODS = ("gstiff", "wstiff", "dassl", "constant_bdf")
"""Backward differentiation formulas: fixed, variable coefficients, fixed leading one, fixed step."""
EXPLICIT_METHODS = ("runge_kutta", "rk4", "adams")
"""Methods that solve for accelerations, whose stability the highest natural frequency limits."""
METHODS = ("generalized_alpha", *EXPLICIT_METHODS, *STIFF_METHODS, "kinematics")
ERROR_METHODS = ("runge_kutta", "gstiff", "wstiff", "dassl")
"""Methods that choose their steps by an error, which `tolerance` limits."""
FORMS = ("I3", "SI2", "SI1")
EVENTS = ("pair_entry", "pair_exit", "contact", "sliding_reversal", "stick_slip")


@dataclass(frozen=True, kw_only=True)
class Drive:
    """Prescribed motion of the spin of a body, or of a coordinate of a joint: exactly one of the keys."""

    speed: Law | None = key(
        "law",
        "speed: a value, a formula of t, {table: [[t, speed], ...]} or {python: 'file.py:function'}",
        None,
        dimension="angular_speed",
    )
    angle: Law | None = key(
        "law",
        "angle: a value, a formula of t or {table: [[t, angle], ...]} (a monotone cubic between its points, "
        "beyond them at the speed of its ends)",
        None,
        dimension="angle",
    )
    velocity: Law | None = key(
        "law", "travels: velocity, in the forms of a speed", None, dimension="speed", sample="2 m/s"
    )
    position: Law | None = key(
        "law", "travels: position, in the forms of an angle", None, dimension="length", sample="3 mm"
    )

    @property
    def rate(self) -> Law | None:
        """Prescribed speed or velocity, if one is given."""
        return self.speed if self.speed is not None else self.velocity

    @property
    def value(self) -> Law | None:
        """Prescribed angle or position, if one is given."""
        return self.angle if self.angle is not None else self.position


@dataclass(frozen=True, kw_only=True)
class Sweep:
    """Speed sweep that carries the state from point to point; one of the two ranges is given."""

    body: str = text("body whose speed is swept")
    mesh_frequency: tuple[float, float] | None = quantities(
        "frequency",
        "lowest and highest mesh frequency [Hz]",
        None,
        length=(2, 2),
        minimum=0.0,
        above=True,
        one_of="range",
    )
    speed: tuple[float, float] | None = quantities(
        "angular_speed",
        "lowest and highest speed",
        None,
        length=(2, 2),
        minimum=0.0,
        above=True,
        one_of="range",
    )
    mesh: str | None = text("mesh whose frequency counts", None, display="the only mesh of the body")
    points: int = integer("number of speeds", 101, minimum=2, maximum=1000000)
    direction: str = choice(("up", "down", "both"), "direction of the sweep", "both")
    settle_periods: int = integer("mesh periods before each measurement", 200, minimum=0, maximum=10**8)
    measure_periods: int = integer("mesh periods of each measurement", 50, minimum=1, maximum=10**8)
    steps_per_period: int | None = integer(
        "time steps per mesh period",
        None,
        minimum=8,
        maximum=100000,
        display="200 per period of the mesh and of its natural frequency",
    )


@dataclass(frozen=True, kw_only=True)
class QuasiStatic:
    """Slow roll through whole mesh periods."""

    mesh: str | None = text("mesh whose periods count", None, display="the only mesh")
    points: int = integer("points per mesh period", 100, minimum=2, maximum=10**6)
    periods: int = integer("number of mesh periods", 1, minimum=1, maximum=10**6)


@dataclass(frozen=True, kw_only=True)
class Scenario:
    """One thing to do with a model: a time response, a sweep or a quasi-static roll."""

    speed: dict[str, float] = key(
        "speeds", "start speed of bodies; the others follow from the ratios", {}, dimension="angular_speed"
    )
    drive: dict[str, Drive] = key(
        "components",
        "prescribed motion by body, for its spin, or by JOINT.COORDINATE",
        {},
        of=Drive,
        dotted=True,
    )
    start: str = choice(
        ("equilibrium", "assembled"),
        "equilibrium: flanks loaded by the loads at t = 0; assembled: all coordinates zero, mid-gap",
        "equilibrium",
    )
    hold: tuple[str, ...] = key("names", "bodies whose speed is held at its start value", ())
    duration: float | None = positive("time", "length of the time response; required without sweep", None)
    sample_rate: float | None = positive(
        "frequency",
        "samples per second; no anti-aliasing filter: content above half of it is aliased",
        None,
        display="every step",
    )
    settle_time: float | None = quantity(
        "time", "start of the window of the statistics", None, minimum=0.0, display="20 % of duration"
    )
    step: float | None = positive(
        "time",
        "time step",
        None,
        display="1/200 of the shortest period of mesh and modes, finite elements as far as excited",
    )
    tolerance: float = positive(
        "dimensionless", "relative tolerance of methods that choose their steps", 1e-7, maximum=0.1
    )
    method: str = choice(
        METHODS,
        "time integration; stiff: gstiff, wstiff, dassl with fixed, variable coefficients, fixed leading "
        "one, and constant_bdf with equal steps; kinematics: drives and loops leave no freedom, and forces "
        "follow from the motion",
        "generalized_alpha",
    )
    form: str | None = choice(
        FORMS,
        "what constraints hold on: positions (I3), positions and rates (SI2), the same with the multipliers "
        "as rates (SI1)",
        None,
        display="I3 of generalized_alpha and dassl, SI2 of the other stiff methods",
    )
    order: int | None = integer(
        "highest order of stiff methods, order of constant_bdf",
        None,
        minimum=1,
        maximum=6,
        display="5; 2 of constant_bdf",
    )
    events: tuple[str, ...] = key(
        "words",
        "events to locate and record: tooth pairs, contact of flanks, bodies and journals, sliding of "
        "flanks, friction that begins or ceases to slip; methods that choose their steps begin anew there",
        (),
        choices=EVENTS,
    )
    channels: tuple[str, ...] = key(
        "names",
        "names of the channels to store; * matches any characters, as in mesh_force[*]",
        (),
        display="all",
        later=True,
    )
    sweep: Sweep | None = component(Sweep, "speed sweep instead of one time response")
    quasi_static: QuasiStatic | None = component(QuasiStatic, "slow roll instead of a time response")

    @property
    def kind(self) -> str:
        """'sweep', 'quasi_static' or 'time'."""
        if self.sweep is not None:
            return "sweep"
        return "quasi_static" if self.quasi_static is not None else "time"

    @property
    def chosen_form(self) -> str:
        """The form of the constraints, with its default."""
        return self.form or ("SI2" if self.method in STIFF_METHODS and self.method != "dassl" else "I3")

    @property
    def statistics_start(self) -> float:
        """Time from which statistics are taken [s]."""
        if self.settle_time is not None:
            return self.settle_time
        return 0.2 * (self.duration or 0.0)
