# SPDX-License-Identifier: Apache-2.0
"""Simulation scenarios: speeds, prescribed motions, duration, sweeps, outputs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pitchpoint.model.component import Component
from pitchpoint.model.components.law import Law
from pitchpoint.model.keys import (
    choice,
    component,
    derived,
    integer,
    key,
    positive,
    quantities,
    quantity,
    text,
)

STIFF_METHODS = ("gstiff", "wstiff", "dassl", "constant_bdf")
"""Backward differentiation formulas: fixed coefficients, variable coefficients, fixed leading coefficient,
fixed step."""
EXPLICIT_METHODS = ("runge_kutta", "rk4", "adams")
"""Explicit methods; the highest natural frequency limits their step."""
METHODS = ("generalized_alpha", *EXPLICIT_METHODS, *STIFF_METHODS, "kinematics")
ERROR_METHODS = ("runge_kutta", "gstiff", "wstiff", "dassl")
"""Methods with step-size control by the error tolerance `tolerance`."""
FORMS = ("I3", "SI2", "SI1")
STATISTICS = ("steps", "samples")
EVENTS = ("pair_entry", "pair_exit", "contact", "sliding_reversal", "stick_slip")


@dataclass(frozen=True, kw_only=True)
class Ripple(Component):
    """Harmonic fluctuation about the mean rotation of a drive; the mean speed is unchanged.

    The angle is phi + a sin(order phi + phase) with the mean angle phi.
    """

    order: float = positive("dimensionless", "periods per revolution of the mean angle", maximum=1e4)
    fluctuation: float | None = quantity(
        "dimensionless",
        "difference of highest and lowest speed over the mean speed",
        None,
        minimum=0.0,
        one_of="amplitude",
        sample="2 %",
    )
    angle: float | None = quantity(
        "angle", "amplitude of the angle", None, minimum=0.0, one_of="amplitude", sample="0.2 deg"
    )
    phase: float = quantity("angle", "phase at mean angle zero", 0.0)

    @property
    def amplitude(self) -> float:
        """Amplitude of the angle [rad].

        Examples
        --------
        >>> Ripple(order=2.0, fluctuation=0.02).amplitude
        0.005
        """
        return self.angle if self.angle is not None else (self.fluctuation or 0.0) / (2.0 * self.order)


@dataclass(frozen=True, kw_only=True)
class Drive(Component):
    """Prescribed motion of the spin of a body or of a joint coordinate: one of the four laws, and a ripple.

    In a speed sweep, which sets the mean speed, a ripple only.
    """

    speed: Law | None = key(
        "law",
        "speed: a value, a formula of t, {table: [[t, speed], ...]} or {python: 'file.py:function'}",
        None,
        dimension="angular_speed",
    )
    angle: Law | None = key(
        "law",
        "angle: a value, a formula of t or {table: [[t, angle], ...]} (monotone cubic interpolation, linear "
        "extrapolation)",
        None,
        dimension="angle",
    )
    velocity: Law | None = key(
        "law",
        "translational coordinates: velocity, given as `speed`",
        None,
        dimension="speed",
        sample="2 m/s",
    )
    position: Law | None = key(
        "law",
        "translational coordinates: position, given as `angle`",
        None,
        dimension="length",
        sample="3 mm",
    )
    ripple: dict[str, Ripple] = key(
        "components",
        "waves by NAME, added to the prescribed rotation",
        {},
        of=Ripple,
        later=True,
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
class Course(Component):
    """Time history of an input: a value, points or a formula."""

    value: float | None = key("value", "constant value", None, one_of="course")
    points: tuple[tuple[float, float], ...] | None = key(
        "curve",
        "points [time, value], linear between them and constant beyond the ends, or a text file",
        None,
        one_of="course",
        dimension="time",
    )
    formula: str | None = key("formula", "formula of the time t", None, one_of="course")


@dataclass(frozen=True, kw_only=True)
class Sweep(Component):
    """Speed sweep: each point starts from the final state of the previous one; give one of the two ranges."""

    body: str = text("body whose speed is swept; one without gears has the meshes of the body coupled to it")
    mesh_frequency: tuple[float, float] | None = quantities(
        "frequency",
        "lowest and highest mesh frequency, in positive rotation",
        None,
        length=(2, 2),
        minimum=0.0,
        above=True,
        one_of="range",
    )
    speed: tuple[float, float] | None = quantities(
        "angular_speed",
        "speeds of lowest and highest magnitude, both > 0 or both < 0",
        None,
        length=(2, 2),
        one_of="range",
    )
    mesh: str | None = text(
        "mesh of mesh_frequency and of the mesh periods", None, display="the only mesh of the body"
    )
    points: int = integer("number of speeds", 101, minimum=2, maximum=1000000)
    direction: str = choice(("up", "down", "both"), "direction of the sweep", "both")
    settle_periods: int = integer("mesh periods for settling at each speed", 200, minimum=0, maximum=10**8)
    measure_periods: int = integer("mesh periods evaluated at each speed", 50, minimum=1, maximum=10**8)
    steps_per_period: int | None = integer(
        "time steps per mesh period",
        None,
        minimum=8,
        maximum=100000,
        display="200 per period of the mesh and of its natural frequency",
    )


@dataclass(frozen=True, kw_only=True)
class QuasiStatic(Component):
    """Quasi-static roll through whole mesh periods."""

    mesh: str | None = text("mesh that defines the mesh period", None, display="the only mesh")
    points: int = integer("points per mesh period", 100, minimum=2, maximum=10**6)
    periods: int = integer("number of mesh periods", 1, minimum=1, maximum=10**6)


@dataclass(frozen=True, kw_only=True)
class Scenario(Component):
    """A time response, a speed sweep or a quasi-static roll of the model."""

    speed: dict[str, float] = key(
        "speeds",
        "initial speeds of bodies, mean speeds if a torque balances pulsating loads; those of other bodies "
        "follow from the gear ratios",
        {},
        dimension="angular_speed",
    )
    drive: dict[str, Drive] = key(
        "components",
        "prescribed motions by BODY, for its spin, or by JOINT.COORDINATE",
        {},
        of=Drive,
        dotted=True,
    )
    start: str = choice(
        ("equilibrium", "assembled"),
        "initial state; equilibrium: static equilibrium under the loads at t = 0, with the mean of pulsating "
        "torques and their steady vibration; assembled: all coordinates zero, teeth centred in the backlash",
        "equilibrium",
    )
    inputs: dict[str, Course] = key(
        "components",
        "courses of inputs by the NAME of the block, instead of their values",
        {},
        of=Course,
        later=True,
    )
    hold: tuple[str, ...] = key("names", "bodies whose speed is kept constant at its initial value", ())
    engaged: tuple[str, ...] | None = key(
        "names",
        "clutches and brakes that are engaged, all others are open; their bodies start with the same speed, "
        "those of brakes at rest",
        None,
        display="by their capacities",
        later=True,
    )
    duration: float | None = positive("time", "duration of the time response; required without sweep", None)
    sample_rate: float | None = positive(
        "frequency",
        "sampling rate of the output; without anti-aliasing filter: content above half of it is aliased",
        None,
        display="every step",
    )
    settle_time: float | None = quantity(
        "time", "start of the evaluation of statistics", None, minimum=0.0, display="20 % of duration"
    )
    statistics: str = choice(
        STATISTICS,
        "statistics and contact counts are over all time steps, with one more evaluation of the forces per "
        "step, or over the stored samples; always over the samples with variable steps",
        "steps",
        later=True,
    )
    step: float | None = positive(
        "time",
        "time step",
        None,
        display="1/200 of the shortest period of meshes and modes; of elastic bodies, excited modes only",
    )
    long_step: float | None = positive(
        "time",
        "time step of all bodies outside of gear trains; these take several steps `step` in it. Without gear "
        "trains all bodies take `step`",
        None,
        display="step",
        later=True,
    )
    tolerance: float = positive(
        "dimensionless", "relative tolerance of methods with step-size control", 1e-7, maximum=0.1
    )
    method: str = choice(
        METHODS,
        "time integration method; stiff (BDF): gstiff with fixed, wstiff with variable, dassl with fixed "
        "leading coefficients, constant_bdf with constant steps; kinematics: drives and loops determine all "
        "motion, and the forces follow from it (inverse dynamics)",
        "generalized_alpha",
    )
    form: str | None = choice(
        FORMS,
        "index formulation: constraints on positions (I3), stabilised with rates (SI2), also with the "
        "multipliers as rates (SI1)",
        None,
        display="I3 of generalized_alpha and dassl, SI2 of the other stiff methods",
    )
    order: int | None = integer(
        "maximum order of stiff methods; order of constant_bdf",
        None,
        minimum=1,
        maximum=6,
        display="5; 2 of constant_bdf",
    )
    events: tuple[str, ...] = key(
        "words",
        "events to locate and record: entry and exit of tooth pairs, contact of flanks, bodies and journals, "
        "sliding reversal of flanks, stick-slip transitions; methods with step-size control restart there",
        (),
        choices=EVENTS,
    )
    load_case: str | None = text(
        "load case that applies to this scenario: its speeds and loads replace those of loads and scenario; "
        "--load-case and the key load_case of the file take precedence",
        None,
        later=True,
    )
    wind: str | None = text("wind at the rotors of wind turbines, instead of their own", None, later=True)
    channels: tuple[str, ...] = key(
        "names",
        "channels to store; * matches any characters, as in mesh_force[*]",
        (),
        display="all",
        later=True,
    )
    sweep: Sweep | None = component(Sweep, "speed sweep instead of one time response")
    quasi_static: QuasiStatic | None = component(QuasiStatic, "quasi-static roll instead of a time response")

    given: Any = derived()
    """The scenario as given, if it has the speeds of a load case."""

    @property
    def kind(self) -> str:
        """'sweep', 'quasi_static' or 'time'."""
        if self.sweep is not None:
            return "sweep"
        return "quasi_static" if self.quasi_static is not None else "time"

    @property
    def chosen_form(self) -> str:
        """Index formulation, with its default."""
        return self.form or ("SI2" if self.method in STIFF_METHODS and self.method != "dassl" else "I3")

    @property
    def statistics_start(self) -> float:
        """Start of the evaluation of statistics [s]."""
        if self.settle_time is not None:
            return self.settle_time
        return 0.2 * (self.duration or 0.0)
