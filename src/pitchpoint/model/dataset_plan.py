# SPDX-License-Identifier: Apache-2.0
"""Plan of a data set: the cases of a model to compute, and the recorded channels.

A factor has levels; a case combines one level of every factor with one seed. A level has a label and new
values by path of the model, as in `Model.replace_all`.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, TypeAlias

from pitchpoint.model.keys import Place, component, integer, key, positive, quantity, text


@dataclass(frozen=True, kw_only=True)
class Noise:
    """White Gaussian noise on a channel; give exactly one key."""

    snr: float | None = quantity(
        "dimensionless",
        "signal-to-noise ratio: rms of the alternating part of the channel over rms of the noise [dB]",
        None,
        one_of="level",
    )
    rms: float | None = positive(
        "dimensionless", "rms of the noise in the SI unit of the channel", None, one_of="level"
    )


@dataclass(frozen=True, kw_only=True)
class ObservedChannel:
    """An output of the model by its name in results."""

    form: ClassVar[str] = "observation"
    channel: str = text("name of the observation, such as bearing_force[input_a.fy] or signal[NAME]")
    noise: Noise | None = component(Noise, "added noise")


@dataclass(frozen=True, kw_only=True)
class TachoChannel:
    """Tacho signal of a rotating body: 1 over half of the pulse pitch, 0 over the other half."""

    form: ClassVar[str] = "tacho"
    body: str = text("name of the rotating body")
    pulses: int = integer("pulses per revolution", minimum=1, maximum=100000)


PlannedChannel: TypeAlias = ObservedChannel | TachoChannel
CHANNELS: dict[str, type] = {c.form: c for c in (ObservedChannel, TachoChannel)}


@dataclass(frozen=True)
class Level:
    """One level of a factor.

    Parameters
    ----------
    label
        Name in the table of cases.
    changes
        Values by path of the model.
    place
        Path in the file.
    """

    label: str
    changes: Mapping[str, Any]
    place: Place = ()


@dataclass(frozen=True)
class PlannedCase:
    """One case: index in the table, labels by factor, values by path, seed from 1."""

    index: int
    labels: Mapping[str, str]
    changes: Mapping[str, Any]
    seed: int


@dataclass(frozen=True, kw_only=True)
class DatasetPlan:
    """Contents of a data set; created and checked by `model.reading.dataset_plan`."""

    title: str = text("title of the data set", "")
    model: str = text("model file, relative to the folder of the plan")
    scenario: str | None = text("scenario of the model", None, display="the only time response")
    seeds: int = integer("number of repetitions of every combination, with seeds 1, 2, ...", 1, minimum=1)
    sample_rate: float = positive("frequency", "sampling rate of all channels")
    length: float = positive("time", "recorded duration of every case")
    settle_time: float = quantity(
        "time", "simulated time before the recording", 0.0, minimum=0.0, display="that of the filter"
    )
    oversampling: int = integer(
        "oversampling factor of the simulation before anti-aliasing filter and decimation; 1: no filter",
        2,
        minimum=1,
        maximum=64,
    )
    channels: Mapping[str, PlannedChannel] = key("components", "recorded channels by name", of=CHANNELS)
    factors: Mapping[str, tuple[Level, ...]] = field(default_factory=dict)
    """Levels of every factor, in the order of the file."""
    jitter: Mapping[str, float] = field(default_factory=dict)
    """Relative standard deviation between cases, by path of the number."""
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
        """All paths that are changed by levels, in the order of appearance."""
        levels = itertools.chain.from_iterable(self.factors.values())
        return tuple(dict.fromkeys(path for level in levels for path in level.changes))

    def __len__(self) -> int:
        """Number of cases."""
        count = self.seeds
        for levels in self.factors.values():
            count *= len(levels)
        return count

    def cases(self) -> Iterator[PlannedCase]:
        """All cases; the seed varies fastest, then the last factor."""
        index = 0
        for levels in itertools.product(*self.factors.values()):
            labels = {name: level.label for name, level in zip(self.factors, levels, strict=True)}
            changes: dict[str, Any] = {}
            for level in levels:
                changes |= level.changes
            for seed in range(1, self.seeds + 1):
                yield PlannedCase(index, labels, changes, seed)
                index += 1
