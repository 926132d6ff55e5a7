# SPDX-License-Identifier: Apache-2.0
"""Power flow of a run: from drives through meshes and couplings to loads, with losses.

Powers are means of torque times speed over the samples of a result, about the axes of the bodies and of
their carriers at rest. Power of vibration transverse to the axis is not evaluated; it is part of the
remainder, which is reported for the whole machine and for every block.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import PitchpointError
from pitchpoint.elements import registry
from pitchpoint.elements.kind import MESH, RATIO, RAYLEIGH, Kind, Power
from pitchpoint.multibody.joints import TUMBLING
from pitchpoint.report.damping_losses import damped_kinds, damping_loss, started
from pitchpoint.report.jump_powers import NEEDED, jump_phases, jump_power
from pitchpoint.report.kinetic_energy import body_energy, element_energy
from pitchpoint.report.mesh_powers import mesh_powers, shows_friction
from pitchpoint.report.scene.motion import Motion, motion
from pitchpoint.report.stored_energy import Deflections, elastic_kinds
from pitchpoint.system.meshes import mesh_names, mesh_records
from pitchpoint.viz.power_flow import OUTSIDE, PowerBlock, PowerFlow, PowerLink
from pitchpoint.viz.quantities import stored_statistics
from pitchpoint.viz.run_record import after_settling

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

LOSSES = {"friction": "friction_power", "damping": "damping_power"}
ROUND_OFF = 1e-12
"""Relative loss of a link below which it counts as lossless."""
SMALL = 1e-8
"""The same for the difference of two powers, each with the error of the trapezoidal rule."""
COARSE = 1e-5
"""The same for a negative loss, which is the error of a record with few samples per vibration."""
UNKNOWN = "springs, whose deflections the result does not determine"

Place = tuple[str, int]
"""Kind and number of an element."""


class NoPowerFlowError(PitchpointError):
    """The result lacks data required for the power flow."""


def power_flow(model: Model, result: xr.Dataset, settle_time: float = 0.0) -> PowerFlow | None:
    """Mean powers of a time run after settling; None if no link connects rotating bodies.

    Parameters
    ----------
    model
        Model of the run.
    result
        Result, loaded.
    settle_time
        Settling time omitted from the means [s].

    Raises
    ------
    NoPowerFlowError
        If the result lacks required channels.
    """
    from pitchpoint.system.compile import compile_model

    system = compile_model(model, result.attrs.get("scenario") or None)
    if not any(_joins(registry.find(kind)) for kind in system.records):
        return None
    machine = Machine(model, system, result, settle_time)
    links = [*machine.sources(), *machine.meshes(), *machine.torques(), *machine.ratios()]
    links += machine.carried(links)
    return machine.flow(links)


def _joins(kind: Kind) -> bool:
    """Whether a kind transmits power between rotating bodies, for all its records."""
    power = kind.power or Power()
    return kind.role in (MESH, RATIO) or bool(power.torque and not power.source and power.where is None)


class Machine:
    """Speeds of all bodies over the samples, and their blocks."""

    def __init__(self, model: Model, system: System, result: xr.Dataset, settle_time: float) -> None:
        self.system, self.result = system, result
        time = np.asarray(result["time"].values, dtype=np.float64)
        inside = after_settling(time, settle_time) if time.size else np.zeros(0, bool)
        self.inside = inside if inside.sum() > 1 else np.ones(time.size, bool)
        self.time = time[self.inside]
        self.springs = elastic_kinds(system)
        # a record of all steps is integrated directly: the mean over steps has no half weights at the ends
        self.decimated = int(result.attrs.get("steps", time.size)) >= time.size
        self.booked = False
        if self.time.size < 2:
            raise NoPowerFlowError("the run has fewer than two samples")
        self.duration = float(self.time[-1] - self.time[0])
        self.names = system.layout.bodies
        self.parent = [0, *(int(one.parent) for one in system.bodies)]
        rest: Motion = motion(system, 1, lambda _: np.zeros(1), np.zeros(1))
        self.place, self.axes, self.axis = rest.place[0], rest.axes[0], rest.axes[0][:, :, 2]
        self.pitch_points, self.directions = rest.pitch_points[0], rest.directions[0]
        self.deflections = Deflections(system, self.ends)
        self.spin: dict[int, Array] = {}
        for b, one in enumerate(system.bodies, start=1):
            turns = any(name == "spin" for name, _ in one.coordinates)
            if turns and not one.state and one.motion not in TUMBLING:
                self.spin[b] = self.channel(f"speed[{self.names[b]}]")
        self.blocks, self.block_of = self._blocks(model)
        self.jump_phases = jump_phases(model)
        self.unseparated: list[str] = []
        self.damped: tuple[str, ...] = ()
        if self.deflections.known and not self.decimated:
            self.damped = damped_kinds(system, self.springs)
        self.strain = [self.kept(block) for block in range(len(self.blocks))]

    def channel(self, name: str) -> Array:
        """Channel over the evaluated span."""
        if name not in self.result:
            raise NoPowerFlowError(f"the result does not contain {name}")
        return np.asarray(self.result[name].values, dtype=np.float64)[self.inside]

    def ends(self, name: str) -> Array | None:
        """Channel at both ends of the span; None if it is not in the result."""
        found = self.known(name)
        return None if found is None else found[[0, -1]]

    def _blocks(self, model: Model) -> tuple[list[str], dict[int, int]]:
        """Names of the blocks, and the block of each rotating body; the stations of a shaft are one block."""
        from pitchpoint.model.shafts import station_names

        shafts = model.stations.items()
        shaft_of = {s: name for name, places in shafts for s in station_names(name, len(places))}
        blocks: list[str] = []
        block_of = {}
        for b in range(1, len(self.names)):
            own = next(self.carriers(b), 0)
            if own:
                name = shaft_of.get(self.names[own], self.names[own])
                if name not in blocks:
                    blocks.append(name)
                block_of[b] = blocks.index(name)
        return blocks, block_of

    def mean(self, values: Array | float) -> float:
        """Time average over the span, for non-uniform samples, too."""
        shown = np.broadcast_to(values, self.time.shape)
        return float(np.trapezoid(shown, self.time) / (self.time[-1] - self.time[0]))

    def mean_of(self, name: str) -> float:
        """Mean of a channel over all steps, if stored: samples may be synchronous with the teeth."""
        sampled = self.mean(self.channel(name))
        stored = stored_statistics(self.result[name].attrs) if self.decimated else None
        return sampled if stored is None else stored["mean"]

    def power(self, name: str, speed: Array | float) -> float:
        """Mean power of a force or torque."""
        force = self.channel(name)
        return self.mean(force * speed) + (self.mean_of(name) - self.mean(force)) * self.mean(speed)

    def carriers(self, b: int) -> Iterator[int]:
        """A body and the bodies that carry it, if they rotate."""
        while b:
            if b in self.spin:
                yield b
            b = self.parent[b]

    def turning(self, b: int, axis: Array) -> Array | float:
        """Speed of a body about a fixed axis [rad/s]."""
        return sum(float(axis @ self.axis[a]) * self.spin[a] for a in self.carriers(b))

    def link(self, name: str, kind: str, pair: tuple[int, int], powers: tuple[float, float]) -> PowerLink:
        """Power flow between two bodies from the powers on both, towards the body with positive power."""
        (i, j), (on_i, on_j) = (self.block_of.get(b, OUTSIDE) for b in pair), powers
        if on_j >= on_i:
            return PowerLink(name=name, kind=kind, start=i, end=j, given=-on_i, taken=on_j)
        return PowerLink(name=name, kind=kind, start=j, end=i, given=-on_j, taken=on_i)

    def sources(self) -> Iterator[PowerLink]:
        """Links of drives and loads, and of their reactions on other bodies."""
        for power, record, name, _ in self.passing(source=True):
            if power.total:
                mean = self.mean_of(power.total.format(name))
                yield self.link(name, power.source, (0, int(record[power.body])), (-mean, mean))
                continue
            i, j = int(record["i"]), int(record["j"])
            on_i = self.power(power.torque.format(name), self.turning(i, self.axis[i]))
            on_j = -self.power(power.torque.format(name), self.turning(j, self.axis[i]))
            if on_i:
                yield self.link(name, power.source, (0, i), (-on_i, on_i))
            if on_j:
                yield self.link(f"reaction of {name}", power.source, (0, j), (-on_j, on_j))

    def passing(self, source: bool) -> Iterator[tuple[Power, np.void, str, Place]]:
        """Description, record, name, and kind with number of the elements with an evaluated torque.

        They are the sources, or all others.
        """
        for kind, records in self.system.records.items():
            power = registry.find(kind).power
            if power is None or not (power.torque or power.total) or bool(power.source) != source:
                continue
            for k, (record, name) in enumerate(zip(records, self.system.names.get(kind, ()), strict=False)):
                wanted = power.where is None or power.where(record)
                if wanted and self.follows(power, record):
                    yield power, record, name, (kind, k)

    def follows(self, power: Power, record: np.void) -> bool:
        """Whether all links between rotating bodies are evaluated, for kinds with only some such records."""
        if power.source or power.where is None:
            return True
        return power.where(record) and {int(record["i"]), int(record["j"])} <= set(self.block_of)

    def meshes(self) -> Iterator[PowerLink]:
        """Links of meshes; friction power not divided between the gears is assigned to the driving gear."""
        names = mesh_names(self.system)
        for m, (record, name) in enumerate(zip(mesh_records(self.system), names, strict=True)):
            pair = int(record["i"]), int(record["j"])
            on = mesh_powers(self, m, record, name)
            losses = {word: self.mean_of(f"{what}[{name}]") for word, what in LOSSES.items()}
            if losses["friction"] and not shows_friction(self, name):
                on[int(on[1] < on[0])] -= losses["friction"]
                self.booked = True
            found = _with_losses(self.link(name, "mesh", pair, (on[0], on[1])), losses)
            fed = self.mean_of(f"parametric_power[{name}]")
            fed = fed if abs(fed) > ROUND_OFF * found.given else 0.0
            jumps = self.jumps(name)
            if jumps is None:
                self.unseparated.append(name)
            yield replace(found, fed=fed, jumps=jumps or 0.0)

    def jumps(self, name: str) -> float | None:
        """Mean power supplied by jumps of the stiffness of a mesh [W]; None if it is unknown."""
        phases = self.jump_phases.get(name, ())
        if not phases:
            return 0.0
        channels = {word: self.known(f"{word}[{name}]") for word in NEEDED}
        known = {word: values for word, values in channels.items() if values is not None}
        return jump_power(self.time, known, phases) if len(known) == len(NEEDED) else None

    def torques(self) -> Iterator[PowerLink]:
        """Links of couplings and clutches; the difference of their powers is their loss, or stored."""
        for power, record, name, place in self.passing(source=False):
            pair = int(record["i"]), int(record["j"])
            channel = power.torque.format(name)
            found = self.between(name, pair, channel)
            energy = np.diff(power.energy(record, self.channel(channel)[[0, -1]]))[0] if power.energy else 0.0
            stored = (float(energy) + self.elastic([place])) / self.duration
            found = replace(found, stored=stored if abs(stored) > ROUND_OFF * found.given else 0.0)
            lost = found.given - found.taken - stored
            # a damper supplies no power
            lost = lost if not -COARSE * found.given < lost < SMALL * found.given else 0.0
            yield _with_losses(found, {power.loss: lost})

    def elastic(self, places: Iterable[Place]) -> float:
        """Change of the elastic energy of springs over the span [J]."""
        return self.deflections.change(_by_kind(places, self.springs))

    def kept(self, block: int) -> float:
        """Change of the elastic and kinetic energy of the springs and beams of a block [J]."""
        places = self.within(block)
        first, last = element_energy(self, _by_kind(places, self.springs))
        return self.elastic(places) + float(last - first)

    def damping(self) -> float:
        """Mean power of Rayleigh damping and of springs that are not links, such as bearings [W]."""
        places = [place for block in (OUTSIDE, *range(len(self.blocks))) for place in self.within(block)]
        on = _by_kind(places, self.damped)
        on |= {kind: np.arange(self.system.records[kind].size) for kind in self.system.kinds(RAYLEIGH)}
        system = started(self.system, self.first)
        return damping_loss(system, self.known, self.time, on) if self.damped else 0.0

    def first(self, name: str) -> Array | None:
        """First sample of a channel, shape (1,); None if it is not in the result."""
        return np.asarray(self.result[name].values[:1], np.float64) if name in self.result else None

    def known(self, name: str) -> Array | None:
        """Channel over the evaluated span; None if it is not in the result."""
        return self.channel(name) if name in self.result else None

    def between(self, name: str, pair: tuple[int, int], channel: str) -> PowerLink:
        """Link of a torque on the first of two bodies and the opposite torque on the second."""
        first, second = (self.power(channel, self.turning(b, self.axis[pair[0]])) for b in pair)
        return self.link(name, "coupling", pair, (first, -second))

    def ratios(self) -> Iterator[PowerLink]:
        """Links of lossless ratios; with three bodies the first exchanges power with the other two."""
        for kind in self.system.kinds(RATIO):
            for record, name in zip(self.system.records[kind], self.system.names[kind], strict=True):
                i = int(record["i"])
                if record["linear"] or i not in self.spin:
                    continue
                for end in "jk":
                    b, share = int(record[end]), float(record[f"c_{end}"]) / float(record["c_i"])
                    if share and b in self.spin:
                        on = share * self.power(f"torque[{name}]", self.spin[b])
                        yield self.link(name, "ratio", (i, b), (-on, on))

    def carried(self, links: list[PowerLink]) -> list[PowerLink]:
        """Links from blocks to their rotating carriers: supplied power less stored power."""
        on = [0.0] * len(self.blocks)
        for link in links:
            for block, power in ((link.start, -link.given), (link.end, link.taken)):
                if block != OUTSIDE:
                    on[block] += power
        found = []
        for block in range(len(self.blocks) - 1, -1, -1):
            own = next(b for b, k in self.block_of.items() if k == block)
            above = next((a for a in self.carriers(own) if self.block_of[a] != block), 0)
            if above:
                handed = on[block] - self.stored(block)
                on[self.block_of[above]] += handed
                name = f"{self.blocks[block]} on {self.blocks[self.block_of[above]]}"
                found.append(self.link(name, "carrier", (own, above), (-handed, handed)))
        return found

    def stored(self, block: int) -> float:
        """Mean rate of the energy of a block: rotation, motion about its carriers, torsion of a shaft [W]."""
        energy = sum(body_energy(self, b) for b, k in self.block_of.items() if k == block)
        first, last = np.broadcast_to(energy, 2)
        return (float(last - first) + self.strain[block]) / self.duration

    def within(self, block: int) -> list[Place]:
        """Springs between bodies of one block, not links: pieces of a shaft; `OUTSIDE`: all others."""
        linked = {place for *_, place in self.passing(source=False)}
        found = []
        for kind in self.springs:
            for k, record in enumerate(self.system.records[kind]):
                one, two = (self.block_of.get(int(record[end]), OUTSIDE) for end in "ij")
                if (kind, k) not in linked and (one if one == two else OUTSIDE) == block:
                    found.append((kind, k))
        return found

    def unfollowed(self) -> list[str]:
        """Elements that may exchange power but are not among the links, in words."""
        found = []
        for name, records in self.system.records.items():
            kind = registry.find(name)
            if name in self.damped and (kind.power is None or kind.power.where is not None):
                continue
            power = kind.power
            lacking = power is not None and power.unknown is not None and any(map(power.unknown, records))
            if power is None or lacking or not all(self.follows(power, record) for record in records):
                found.append(kind.plural or kind.words)
        return found

    def flow(self, links: list[PowerLink]) -> PowerFlow:
        """Complete power flow."""
        own = {block: b for b, block in reversed(self.block_of.items())}
        speed = {block: self.mean(self.turning(b, self.axis[b])) for block, b in own.items()}
        names = [c.name for c in self.system.layout.channels if c.name.startswith("elastic_energy[")]
        teeth = sum(float(ends[1] - ends[0]) for name in names if (ends := self.ends(name)) is not None)
        unknown = bool(self.springs) and not self.deflections.known
        touched = {block for link in links for block in (link.start, link.end)}
        kept = [k for k in range(len(self.blocks)) if k in touched]
        number = {k: new for new, k in enumerate(kept)} | {OUTSIDE: OUTSIDE}
        return PowerFlow(
            span=(float(self.time[0]), float(self.time[-1])),
            blocks=[PowerBlock(name=self.blocks[k], speed=speed[k], stored=self.stored(k)) for k in kept],
            links=[_numbered(link, number) for link in links],
            elastic=(teeth + self.kept(OUTSIDE)) / self.duration,
            damped=self.damping(),
            booked=self.booked,
            unseparated=self.unseparated,
            unfollowed=[*self.unfollowed(), *[UNKNOWN] * unknown],
        )


def _by_kind(places: Iterable[Place], kinds: Iterable[str]) -> dict[str, NDArray[np.int64]]:
    """Numbers of elements of some kinds, by kind."""
    on: dict[str, list[int]] = {}
    for kind, k in places:
        on.setdefault(kind, []).append(k)
    return {kind: np.array(rows) for kind, rows in on.items() if kind in kinds}


def _with_losses(link: PowerLink, losses: Mapping[str, float]) -> PowerLink:
    known = {word: loss for word, loss in losses.items() if abs(loss) > ROUND_OFF * link.given}
    return replace(link, losses=known)


def _numbered(link: PowerLink, number: Mapping[int, int]) -> PowerLink:
    return replace(link, start=number[link.start], end=number[link.end])
