# SPDX-License-Identifier: Apache-2.0
"""Numerical results of the shovel gearbox: geometry, contact parameters, forces and spectra.

`story.py` makes a page of them. Each function takes a model or a run and gives a dataclass.
"""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.signal import resample_poly

from pitchpoint import Model, compile_model, load_model, solve_time
from pitchpoint.analysis.fault_frequencies import TrainFrequencies, train_frequencies
from pitchpoint.analysis.harmonics import harmonic_table, read_tones
from pitchpoint.contact.stiffness.hertz import hertz_constant

if TYPE_CHECKING:
    import xarray as xr

HERE = Path(__file__).parent
RECORD, SETTLE, RATED = 15.0, 3.0, 740.0
"""Length of a record at speed and time before it [s], speed of the motors [1/min]."""
RATE, THINNED = 430.4, 5
"""Sample rate of the paper [Hz], 6456 steps in 15 s, and how many of our samples make one of them."""
STAGES = ("stage_1", "stage_2", "stage_3")
SHAFTS = ("input", "second", "third", "output")
FAULT = "gears.Z5.faults.broken.severity"

PRINTED: dict[str, tuple[float, float, float]] = {
    "ratio": (7.3636, 5.666, 3.273),
    "mesh_frequency": (135.667, 20.099, 3.251),
    "stiffness": (6.824e5, 8.102e5, 10.941e5),  # N/mm^1.5, Table 4
}
TOTAL_RATIO, PINION_SPEED, PINION_PERIOD, READ_PERIOD = 136.56, 17.734, 3.38, 3.37
LOSSLESS = (51.60e3, 261.2e3, 861.2e3)
"""Normal forces that follow from 437 kN m without losses, T/(r_b cos beta_b) [N]."""


@dataclass(frozen=True)
class Run:
    """One simulation.

    Attributes
    ----------
    label
        What the page calls it.
    file, scenario
        Where it comes from.
    changes
        Values that differ from the file, by path.
    data
        All channels over time.
    settle
        Start of the record [s].
    processor_s
        Processor time [s]: on a busy machine the wall-clock time is not reliable.
    """

    label: str
    file: str
    scenario: str
    changes: Mapping[str, Any]
    data: xr.Dataset = field(repr=False)
    settle: float
    processor_s: float

    @property
    def rate(self) -> float:
        """Sample rate [Hz]."""
        times = self.data.time.values
        return (times.size - 1) / float(times[-1] - times[0])

    @property
    def real_time_factor(self) -> float:
        """Simulated time over processor time of the solver [-]."""
        return float(self.data.time[-1]) / self.processor_s

    def record(self, channel: str) -> np.ndarray:
        """Samples of a channel from `settle` on, without the last one: whole steps of the record."""
        start = round(self.settle * self.rate)
        return np.asarray(self.data[channel].values[start:-1], dtype=np.float64)

    def thinned(self, channel: str) -> np.ndarray:
        """The record at the sample rate of the paper, free of what lies above half of it."""
        values = self.record(channel)
        mean = values.mean()
        return np.asarray(mean + resample_poly(values - mean, 1, THINNED), dtype=np.float64)

    def times(self, thinned: bool = False) -> np.ndarray:
        """Times of the samples of `record` or of its decimated form, from 0 on [s]."""
        rate = self.rate / THINNED if thinned else self.rate
        n = round((self.data.time.size - 1 - round(self.settle * self.rate)) * rate / self.rate)
        return np.arange(n) / rate


def simulate(
    label: str,
    file: str = "paper.yaml",
    scenario: str = "rated",
    *,
    record: float = RECORD,
    settle: float = SETTLE,
    **changes: Any,
) -> Run:
    """Run a scenario, with other values where they are given (dots of a path as two underscores).

    Parameters
    ----------
    label
        What the page calls the run.
    file, scenario
        File next to this one, and a scenario of it.
    record, settle
        Length of the record and time before it [s].
    changes
        Other values by path.
    """
    given = {path.replace("__", "."): value for path, value in changes.items()}
    where = f"scenarios.{scenario}"
    times = {f"{where}.duration": settle + record, f"{where}.settle_time": settle}
    model = load_model(HERE / file).replace_all({**times, **given})
    system = compile_model(model, scenario)
    begun = time.process_time()
    data = solve_time(system)
    return Run(label, file, scenario, times | given, data, settle, time.process_time() - begun)


def healthy_and_faulty(record: float = RECORD) -> tuple[Run, Run]:
    """The rated gearbox as it should be, and with the broken tooth of Z5."""
    return simulate("healthy", record=record), simulate("faulty", record=record, **{FAULT: 1})


def without_friction(record: float = 3.0) -> Run:
    """The rated gearbox without friction in its meshes, for the forces that follow from the torques."""
    meshes = load_model(HERE / "paper.yaml").meshes
    still = {f"meshes.{mesh}.friction": None for mesh in meshes}
    return simulate("no friction", record=record, **still)


# ------------------------------------------------------------------------------------------------- geometry


@dataclass(frozen=True)
class Stage:
    """One stage as the model has it.

    Attributes
    ----------
    mesh, gears
        Names.
    teeth, ratio
        Numbers of teeth of pinion and wheel, and their ratio [-].
    reference_diameter, working_diameter
        Of the pinion [m].
    stiffness_reference, stiffness_working
        Constant K of the contact [N/m^1.5] with either of them in the place of d1.
    damping_share
        Damping coefficient over K, both in N and mm [s/mm^0.5].
    penetration
        Of one pair at the force without losses [m].
    """

    mesh: str
    gears: tuple[str, str]
    teeth: tuple[int, int]
    ratio: float
    reference_diameter: float
    working_diameter: float
    stiffness_reference: float
    stiffness_working: float
    damping_share: float
    penetration: float


def stages(model: Model) -> tuple[Stage, ...]:
    """The three stages of the left side."""
    found = []
    for mesh, force in zip(STAGES, LOSSLESS, strict=True):
        pair, gears = model.pairs[mesh], model.meshes[mesh].gears
        materials = [model.gears[g].material_data for g in gears]
        moduli = tuple(m.youngs_modulus for m in materials)
        poisson = tuple(m.poisson_ratio for m in materials)
        exact, working = (hertz_constant(pair, moduli, poisson, d) for d in ("reference", "operating"))
        damping = model.meshes[mesh].damping.pair
        found.append(
            Stage(
                mesh=mesh,
                gears=gears,
                teeth=(pair.gear1.z, pair.gear2.z),
                ratio=pair.gear2.z / pair.gear1.z,
                reference_diameter=pair.gear1.d,
                working_diameter=pair.d_w1,
                stiffness_reference=exact,
                stiffness_working=working,
                damping_share=in_mm(damping, 1.0) / in_mm(working, 1.5),
                penetration=(force / working) ** (2.0 / 3.0),
            )
        )
    return tuple(found)


def in_mm(value: float, power: float) -> float:
    """A value per metre to a power, per millimetre to that power."""
    return value / 1e3**power


def frequencies(model: Model) -> TrainFrequencies:
    """Turning and mesh frequencies at the rated speed."""
    teeth = [stage.teeth for stage in stages(model)]
    return train_frequencies(teeth, RATED / 60.0 * math.tau)


# --------------------------------------------------------------------------------------------------- forces


@dataclass(frozen=True)
class ToothForce:
    """Normal force of one stage.

    Attributes
    ----------
    channel
        Channel of the run.
    mean, rms
        Mean and alternating rms [N].
    lossless
        Mean without friction [N].
    frequency
        Mesh frequency that its harmonics fit [Hz].
    amplitude
        Shape (n,). Amplitudes of its harmonics [N].
    others, background
        Shape (3,). Amplitudes at the mesh frequencies of all stages, and of the lines around [N].
    """

    channel: str
    mean: float
    rms: float
    lossless: float
    frequency: float
    amplitude: np.ndarray
    others: np.ndarray
    background: np.ndarray


def tooth_forces(run: Run, frictionless: Run, expected: np.ndarray) -> tuple[ToothForce, ...]:
    """Means, mesh frequencies, and the ripple of every stage in every other one."""
    found = []
    for mesh, frequency in zip(STAGES, expected, strict=True):
        channel = f"normal_force[{mesh}]"
        values = run.record(channel)
        table = harmonic_table(values - values.mean(), run.rate, frequency, harmonics=5)
        tones = read_tones(values - values.mean(), run.rate, expected, reach=1e-3 * expected)
        found.append(
            ToothForce(
                channel=channel,
                mean=float(values.mean()),
                rms=float(values.std()),
                lossless=float(frictionless.record(channel).mean()),
                frequency=table.fundamental,
                amplitude=table.amplitude,
                others=tones.amplitude,
                background=tones.background,
            )
        )
    return tuple(found)


@dataclass(frozen=True)
class SupportForce:
    """Force of one bearing in one direction: channels and [N], on rigid shafts and on elastic ones.

    Attributes
    ----------
    bearing, axis
        Such as `third_a` and `x`.
    channel, elastic_channel
        Channels of both runs; `channel` is empty for the axial force of the second bearing.
    mean, rms, elastic_mean, elastic_rms
        Means and alternating rms [N].
    """

    bearing: str
    axis: str
    channel: str
    elastic_channel: str
    mean: float
    rms: float
    elastic_mean: float
    elastic_rms: float


def support_forces(run: Run, elastic: Run | None = None) -> tuple[SupportForce, ...]:
    """Forces of the bearings of the left side in x, y and z; the first of a shaft holds it along z."""
    found = []
    for shaft in SHAFTS:
        for end, axis in (("a", "x"), ("a", "y"), ("a", "z"), ("b", "x"), ("b", "y")):
            channel = f"signal[{shaft}_force_z]" if axis == "z" else f"signal[{shaft}_{end}_{axis}]"
            other = f"bearing_force[{shaft}_{end}.f{axis}]"
            values = run.record(channel)
            soft = np.array([np.nan]) if elastic is None else elastic.record(other)
            found.append(
                SupportForce(
                    bearing=f"{shaft}_{end}",
                    axis=axis,
                    channel=channel,
                    elastic_channel=other,
                    mean=float(values.mean()),
                    rms=float(values.std()),
                    elastic_mean=float(soft.mean()),
                    elastic_rms=float(soft.std()),
                )
            )
    return tuple(found)
