# SPDX-License-Identifier: Apache-2.0
"""Marked events of a result: contact loss, impacts, contact of the other flanks, faulty teeth in mesh.

They are determined from the stored samples, with linear interpolation between samples; a note is added if the
tooth frequency is too high for this.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.units import format_quantity
from pitchpoint.viz.scene.contacts import ContactFlank, FlankSurface, SceneContact
from pitchpoint.viz.scene.content import SceneMark

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.tooth_faults import BevelFault, ToothFault
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]
Span = tuple[float, float]

MAX_MARKS = 100
"""Maximum number of marks of one kind in one mesh; the longest or strongest are retained."""
SEEN = 0.25
"""Maximum tooth pairs per sample interval at which events between samples are detected."""
BOTH = 2
"""Contact state in which front and back flanks touch."""


def scene_marks(
    model: Model, result: xr.Dataset, contacts: Sequence[SceneContact], frames: Array
) -> tuple[list[SceneMark], list[str]]:
    """All marks in order of time, and notes on omitted ones.

    Parameters
    ----------
    model, result
        The machine and its run.
    contacts
        Its meshes over the frames.
    frames
        Times of the frames [s], shape (n,).
    """
    marks: list[SceneMark] = []
    notes: list[str] = []
    time = np.asarray(result["time"].values, dtype=np.float64)
    for contact in contacts:
        found = [*contact_marks(result, contact, time), *fault_marks(model, contact, frames)]
        for kind in dict.fromkeys(mark.kind for mark, _ in found):
            same = sorted((one for one in found if one[0].kind == kind), key=lambda one: -one[1])
            marks += [mark for mark, _ in same[:MAX_MARKS]]
            if len(same) > MAX_MARKS:
                size = "strongest" if kind == "impact" else "longest"
                words = kind.replace("_", " ")
                notes.append(
                    f"mesh {contact.name}: {len(same)} marks of {words}; the {MAX_MARKS} {size} are shown"
                )
        passing = _passing(contact, frames)
        if passing * _step(time) > SEEN:
            notes.append(
                f"mesh {contact.name}: {passing * _step(time):.2g} tooth pairs per sample interval; "
                "contact loss between samples is not marked"
            )
        elif passing * _step(frames) > 1.0:
            notes.append(
                f"mesh {contact.name}: {passing * _step(frames):.2g} tooth pairs per frame interval; "
                "patterns show separate lines"
            )
    return sorted(marks, key=lambda mark: mark.time), notes


def _step(time: Array) -> float:
    return float(np.median(np.diff(time))) if time.size > 1 else 0.0


def _passing(contact: SceneContact, frames: Array) -> float:
    """Maximum number of tooth pairs per second."""
    if frames.size < 2:
        return 0.0
    pairs = contact.flanks[0].travel / contact.base_pitch
    return float(np.abs(np.diff(pairs) / np.diff(frames)).max())


def contact_marks(result: xr.Dataset, contact: SceneContact, time: Array) -> list[tuple[SceneMark, float]]:
    """Marks of contact loss, impacts and the other flanks of one mesh, each with its weight [s, m/s].

    Parameters
    ----------
    result
        The run.
    contact
        The mesh.
    time
        Of all samples [s], shape (n,).
    """
    name = contact.name
    needed = [f"{word}[{name}]" for word in ("contact_state", "penetration", "deflection")]
    if any(word not in result for word in needed) or time.size < 2:
        return []
    state, nearer, x = (np.asarray(result[word].values, dtype=np.float64) for word in needed)
    state = np.rint(state).astype(np.int64)
    farther = nearer - 2.0 * np.abs(x) * math.cos(contact.base_helix)
    front = np.where(x >= 0.0, nearer, farther)
    back = np.where(x >= 0.0, farther, nearer)
    found = []
    for start, end in _runs(state == 0):
        gone = (
            float(time[0])
            if start == 0
            else _crossing(time, back if state[start - 1] == -1 else front, start)
        )
        regained = float(time[-1])
        if end < time.size:
            side = back if state[end] == -1 else front
            word = "back flank" if state[end] == -1 else "front flank"
            regained, speed = _impact(time, side, start, end)
            caption = f"{name}, {word}, closing at {format_quantity(speed, 'speed')}"
            found.append((SceneMark(regained, "impact", caption), speed))
        if start > 0:
            found.append((SceneMark(gone, "contact_loss", name, regained), regained - gone))
    # the working flanks are those in contact most of the time; contact of the others is marked
    other, kind, side = -1, "back_flank", back
    if np.count_nonzero(state == -1) > np.count_nonzero(state == 1):
        other, kind, side = 1, "front_flank", front
    for start, end in _runs((state == other) | (state == BOTH)):
        begins = float(time[0]) if start == 0 else _crossing(time, side, start)
        ends = float(time[-1]) if end == time.size else _crossing(time, side, end)
        found.append((SceneMark(begins, kind, name, ends), ends - begins))
    return found


def _runs(holds: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First sample and the one after the last of every interval in which a condition holds."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], holds, [False]]).astype(np.int8)))
    return [(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _crossing(time: Array, y: Array, k: int) -> float:
    """Time of the zero of y between the samples k - 1 and k; the middle if y does not change sign."""
    a, b = float(y[k - 1]), float(y[k])
    share = a / (a - b) if (a > 0.0) != (b > 0.0) else 0.5
    return float(time[k - 1] + share * (time[k] - time[k - 1]))


def _impact(time: Array, y: Array, start: int, end: int) -> Span:
    """Time and closing speed [m/s] of an impact after a separation in the samples from `start` to `end`.

    The speed is that between the last two separated samples; for a single one, that from it into the contact.
    """
    k = end - 1 if end - start > 1 else end
    speed = float((y[k] - y[k - 1]) / (time[k] - time[k - 1])) if k > 0 else 0.0
    if speed <= 0.0:
        return _crossing(time, y, end), 0.0
    ahead = max(0.0, -float(y[end - 1])) / speed
    return float(min(time[end - 1] + ahead, time[end])), speed


def fault_marks(model: Model, contact: SceneContact, frames: Array) -> list[tuple[SceneMark, float]]:
    """Intervals in which teeth with faults are in mesh, each with its duration [s].

    Parameters
    ----------
    model
        Model with the faults.
    contact
        The mesh.
    frames
        Times of its travel [s], shape (n,).
    """
    found: list[tuple[SceneMark, float]] = []
    gears: Mapping[str, Gear | BevelGear] = model.gears if contact.cone is None else model.bevel_gears
    for flank in contact.flanks:
        if len(contact.flanks) > 1 and not np.any(flank.forces):
            continue
        for number, surface in enumerate(flank.surfaces):
            gear = gears[surface.gear]
            for label, fault in gear.tooth_faults.items():
                tooth = getattr(fault, "tooth", None)
                if tooth is None or fault.severity == 0.0:
                    continue
                if not _concerns(fault, flank.side, number == 1 and getattr(gear, "type", "") == "internal"):
                    continue
                caption = f"{surface.gear}, tooth {tooth} ({label.replace('_', ' ')}) in {contact.name}"
                for begins, ends in tooth_in_mesh(contact, flank, surface, tooth, frames):
                    found.append((SceneMark(begins, "faulty_tooth", caption, ends), ends - begins))
    return found


def _concerns(fault: ToothFault | BevelFault, side: int, turned: bool) -> bool:
    """Whether a fault is on the flanks of one side; for internal gears left and right are exchanged."""
    front = "right" if turned else "left"
    behind = "left" if turned else "right"
    return getattr(fault, "flank", "both") in ("both", front if side > 0 else behind)


def tooth_in_mesh(
    contact: SceneContact, flank: ContactFlank, surface: FlankSurface, tooth: int, frames: Array
) -> list[Span]:
    """Time spans in which a contact line of a tooth is between A and E anywhere on the face [s].

    Parameters
    ----------
    contact, flank, surface
        Mesh, flank side, and gear.
    tooth
        Number of the tooth.
    frames
        Times of the travel [s], shape (n,).
    """
    pitch, z = contact.base_pitch, surface.teeth
    ends = [flank.side * math.tan(contact.base_helix) * width for width in contact.width]
    low, high = contact.path[0] - max(ends), contact.path[1] - min(ends)
    first = (tooth - surface.tooth) * surface.step % z  # one of z pairs has this tooth
    least = math.floor((float(flank.travel.min()) - high) / pitch)
    most = math.ceil((float(flank.travel.max()) - low) / pitch)
    found: list[Span] = []
    for pair in range(least + (first - least) % z, most + 1, z):
        found += _stays(frames, flank.travel - pair * pitch, low, high)
    return sorted(found)


def _stays(time: Array, y: Array, low: float, high: float) -> list[Span]:
    """Intervals in which y, interpolated linearly, is between low and high."""
    instants = [float(time[0]), float(time[-1])]
    for level in (low, high):
        k = np.flatnonzero((y[:-1] > level) != (y[1:] > level))
        instants += (time[k] + (level - y[k]) / (y[k + 1] - y[k]) * (time[k + 1] - time[k])).tolist()
    instants.sort()
    found: list[Span] = []
    for a, b in zip(instants, instants[1:], strict=False):
        if b > a and low < np.interp(0.5 * (a + b), time, y) < high:
            if found and found[-1][1] == a:
                a = found.pop()[0]
            found.append((a, b))
    return found
