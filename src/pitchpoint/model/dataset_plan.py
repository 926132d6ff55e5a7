# SPDX-License-Identifier: Apache-2.0
"""Plan of a data set: which cases of a model are computed, and what is recorded of each.

A factor has levels; a case is one level of every factor with one seed. A level has a label and the values
that it puts at paths of the model, as in `Model.replace_all`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, TypeAlias

from pitchpoint.model.keys import Place, component, integer, key, positive, quantity, text

STOP_BAND = 80
"""Damping of what an anti-aliasing filter stops [dB]."""


@dataclass(frozen=True, kw_only=True)
class Noise:
    """White Gaussian noise on a channel; exactly one key is given."""

    snr: float | None = quantity(
        "dimensionless",
        "rms of the alternating part of the channel over that of the noise [dB]",
        None,
        one_of="level",
    )
    rms: float | None = positive(
        "dimensionless", "rms of the noise in the SI unit of the channel", None, one_of="level"
    )


@dataclass(frozen=True, kw_only=True)
class ObservedChannel:
    """An observation of the model, as results name it."""

    form: ClassVar[str] = "observation"
    channel: str = text("name of the observation, such as bearing_force[input_a.fy] or signal[NAME]")
    noise: Noise | None = component(Noise, "noise that is added")


@dataclass(frozen=True, kw_only=True)
class TachoChannel:
    """Pulses of a body that spins: 1 over half of the angle between two pulses, 0 over the other half."""

    form: ClassVar[str] = "tacho"
    body: str = text("name of the body whose spin is counted")
    pulses: int = integer("pulses per turn", minimum=1, maximum=100000)


PlannedChannel: TypeAlias = ObservedChannel | TachoChannel
CHANNELS: dict[str, type] = {c.form: c for c in (ObservedChannel, TachoChannel)}


@dataclass(frozen=True)
class Level:
    """One level of a factor.

    Parameters
    ----------
    label
        Its name in the table of cases.
    changes
        Values by path of the model.
    place
        Its place in the file.
    """

    label: str
    changes: Mapping[str, Any]
    place: Place = ()


@dataclass(frozen=True)
class PlannedCase:
    """One case: its place in the table, labels by factor, values by path, seed from 1."""

    index: int
    labels: Mapping[str, str]
    changes: Mapping[str, Any]
    seed: int


@dataclass(frozen=True, kw_only=True)
class DatasetPlan:
    """What a data set holds. Made by `model.reading.dataset_plan`, which checks it."""

    title: str = text("what the data set is", "")
    model: str = text("name of the model file, from the folder of the plan")
    scenario: str | None = text("name of the scenario of the model", None, display="the only one over time")
    seeds: int = integer("number of repetitions of every combination, with seeds 1, 2, ...", 1, minimum=1)
    sample_rate: float = positive("frequency", "samples per second of all channels")
    length: float = positive("time", "length of every case")
    settle_time: float = quantity(
        "time", "time computed before, which is not recorded", 0.0, minimum=0.0, display="that of the filter"
    )
    oversampling: int = integer(
        "the machine is sampled so many times faster, then filtered and decimated; 1: no filter",
        2,
        minimum=1,
        maximum=64,
    )
    channels: Mapping[str, PlannedChannel] = key("components", "what is recorded, by name", of=CHANNELS)
    factors: Mapping[str, tuple[Level, ...]] = field(default_factory=dict)
    """Levels of every factor, in the order of the file."""
    jitter: Mapping[str, float] = field(default_factory=dict)
    """Standard deviation of the number at a path from case to case, over the number."""
    file: str | None = None
    lines: Mapping[Place, int] = field(default_factory=dict, compare=False)
    allow_code: bool = field(default=False, compare=False)
    """Whether the levels may name Python functions; the permission of the model does not cover them."""

    @property
    def samples(self) -> int:
        """Number of samples of a channel."""
        return max(1, round(self.length * self.sample_rate))

    @cached_property
    def paths(self) -> tuple[str, ...]:
        """Every path that some level changes, in the order of appearance."""
        levels = itertools.chain.from_iterable(self.factors.values())
        return tuple(dict.fromkeys(path for level in levels for path in level.changes))

    def __len__(self) -> int:
        """Count the cases."""
        count = self.seeds
        for levels in self.factors.values():
            count *= len(levels)
        return count

    def cases(self) -> Iterator[PlannedCase]:
        """All cases, seeds varying fastest, then the last factor."""
        index = 0
        for levels in itertools.product(*self.factors.values()):
            labels = {name: level.label for name, level in zip(self.factors, levels, strict=True)}
            changes: dict[str, Any] = {}
            for level in levels:
                changes |= level.changes
            for seed in range(1, self.seeds + 1):
                yield PlannedCase(index, labels, changes, seed)
                index += 1
