# SPDX-License-Identifier: Apache-2.0
"""Curves, contacts and spectra of a scene as entries of its header, see `docs/scene_format.md`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.viz.scene.contacts import ContactFlank, SceneContact
from pitchpoint.viz.scene.content import SceneChannel
from pitchpoint.viz.scene.packing import LENGTH, Block, unseen
from pitchpoint.viz.scene.spectrum import Array, SceneMap, SceneSpectrum

FINE, COARSE = 65535, 2047
"""Quantisation steps of a curve: shown by default, and others."""
MEAN = 63
"""Quantisation steps of a mean between minimum and maximum."""


def channel_entries(channels: Sequence[SceneChannel], block: Block) -> dict[str, Any]:
    """Entries `curves` and `channels` of a header; their numbers are written to the block.

    Parameters
    ----------
    channels
        Curves; those with equal times share a table, those with equal steps a column.
    block
        Numbers of the scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    tables: dict[tuple[int, bytes], _Table] = {}
    entries = []
    for channel in channels:
        values = (channel.least, channel.most, channel.mean)
        if not all(np.isfinite(x).all() for x in values):
            raise ValueError(f"{channel.name}: contains non-finite numbers")
        steps = FINE if channel.first else COARSE
        table = tables.setdefault((steps, channel.times.tobytes()), _Table(len(tables), channel))
        low, high = float(channel.least.min()), float(channel.most.max())
        # an offset in full precision: a torque of 1e5 N m may have a ripple of 1 N m
        step, low = float(f"{(high - low) / steps * (1.0 + 1e-5):.10g}"), float(f"{low:.12g}")
        least, most, mean = (np.rint((x - low) / (step or 1.0)).astype(np.int64) for x in values)
        share = np.rint(MEAN * (mean - least) / np.maximum(most - least, 1)).astype(np.int64)
        entry: dict[str, Any] = {
            "name": channel.name,
            "label": channel.label,
            "unit": channel.unit,
            "shown_unit": channel.shown_unit,
            "scale": channel.scale,
            "curve": [table.number, table.column(least, most, share)],
            "from": [low, step],
        }
        if channel.first:
            entry["first"] = True
        if channel.group:
            entry["group"] = {"name": channel.group, "label": channel.group_label, "planet": channel.planet}
        entries.append(entry)
    return {"curves": [table.entry(block) for table in tables.values()], "channels": entries}


class _Table:
    """Curves over the same times; equal columns are stored once."""

    def __init__(self, number: int, first: SceneChannel) -> None:
        self.number, self.times = number, first.times
        self.columns: dict[bytes, tuple[int, np.ndarray, np.ndarray, np.ndarray]] = {}

    def column(self, least: np.ndarray, most: np.ndarray, share: np.ndarray) -> int:
        """Index of the column with these steps."""
        key = least.tobytes() + most.tobytes() + share.tobytes()
        return self.columns.setdefault(key, (len(self.columns), least, most, share))[0]

    def entry(self, block: Block) -> dict[str, Any]:
        """Header entry; numbers are written to the block."""
        least, most, share = (
            np.stack([column[k] for column in self.columns.values()], axis=1) for k in (1, 2, 3)
        )
        found = {"times": block.put(self.times, "f8"), "least": block.put_whole(least)}
        if np.any(most != least):
            found |= {"span": block.put_whole(most - least), "mean": block.put_whole(share)}
        return found


_LOADS, _FORCES = 255, 8191
"""Quantisation steps of loads, which are shown as colours, and of forces, which are shown as numbers."""
_GAP = 5e-9
"""Largest error of a penetration [m]."""


def contact_entry(contact: SceneContact, block: Block) -> dict[str, Any]:
    """Header entry of one mesh; its numbers are written to the block.

    Parameters
    ----------
    contact
        The mesh.
    block
        Numbers of the scene.

    Raises
    ------
    ValueError
        If a number is not finite.
    """
    for track in (contact.at, contact.axes, contact.pressure_angle, contact.penetration):
        if not np.isfinite(track).all():
            raise ValueError(f"{contact.name}: contains non-finite numbers")
    # precision of an angle by its effect at the ends of the lines
    angle = LENGTH / max(map(abs, (*contact.width, *contact.path)))
    found = {
        "name": contact.name,
        "at": block.put_track(contact.at, LENGTH),
        "axes": block.put_track(_quaternions(contact.axes), 0.5 * angle),
        "pressure_angle": block.put_track(contact.pressure_angle, angle),
        "base_helix": contact.base_helix,
        "base_pitch": contact.base_pitch,
        "width": list(contact.width),
        "path": list(contact.path),
        **({} if contact.cone is None else {"cone": list(contact.cone)}),
        "penetration": block.put_track(contact.penetration, unseen(contact.penetration, _GAP)),
        "flanks": [_flank(flank, block) for flank in contact.flanks],
    }
    if contact.unit_pressure is not None:
        found["unit_pressure"] = block.put(contact.unit_pressure, "f4")
    return found


def _flank(flank: ContactFlank, block: Block) -> dict[str, Any]:
    found: dict[str, Any] = {"side": flank.side, "travel": block.put_track(flank.travel, LENGTH)}
    if flank.forces.shape[1]:
        # zero remains exact: it means no contact of a pair
        found["forces"] = block.put_steps(flank.forces, _largest(flank.forces) / _FORCES)
        found["loads"] = block.put_steps(flank.loads, _largest(flank.loads) / _LOADS, across=True)
    found["surfaces"] = [
        {
            "body": surface.body,
            "gear": surface.gear,
            "teeth": surface.teeth,
            "points": block.put_steps(surface.points, 1e-7 * _largest(surface.points)),
            "turn": surface.turn,
            "tooth": surface.tooth,
            "step": surface.step,
        }
        for surface in flank.surfaces
    ]
    return found


def _largest(values: NDArray[np.float64]) -> float:
    return float(np.abs(values).max(initial=0.0))


def _quaternions(axes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Quaternions (x, y, z, w) of frames, shape (n, 3, 3), with continuous signs."""
    from scipy.spatial.transform import Rotation

    found = Rotation.from_matrix(axes).as_quat()
    turned = np.sign(np.einsum("ni,ni->n", found[1:], found[:-1]))
    found[1:] *= np.cumprod(np.where(turned < 0.0, -1.0, 1.0))[:, None]
    return found


DECIBELS = 80.0
"""Dynamic range of a map below its maximum [dB]."""
_LEVELS = 255
_AMPLITUDE = 1e-3
"""Largest relative error of a line of a spectrum."""
_NOTHING = 1e-12
"""Lines below this fraction of the maximum are raised to it for the logarithmic scale."""


def spectrum_entry(spectrum: SceneSpectrum, block: Block) -> dict[str, Any]:
    """Entry of a spectrum in the header of a scene.

    Parameters
    ----------
    spectrum
        The spectrum.
    block
        Where its numbers go.

    Raises
    ------
    ValueError
        If an amplitude is not finite.
    """
    amplitude = spectrum.amplitude
    if not np.isfinite(amplitude).all():
        raise ValueError(f"{spectrum.channel}: contains non-finite numbers")
    level = np.log(np.maximum(amplitude, _NOTHING * float(amplitude.max(initial=0.0)) or 1.0))
    return {
        "channel": spectrum.channel,
        "unit": spectrum.unit,
        "of": spectrum.of,
        "resolution": spectrum.resolution,
        "lines": _lines(spectrum.lines, block),
        "amplitude": {**block.put_steps(level, 2.0 * _AMPLITUDE), "exponent": True},
    }


def map_entry(found: SceneMap, block: Block) -> dict[str, Any]:
    """Header entry of a map with its amplitudes as decibel levels.

    Parameters
    ----------
    found
        Map of the scene.
    block
        Where its numbers go.
    """
    return {
        "channel": found.channel,
        "unit": found.unit,
        "of": found.of,
        "lines": block.put(found.lines, "f4"),
        "times": block.put(found.times, "f8"),
        "most": float(found.amplitude.max()),
        "decibels": DECIBELS,
        "levels": block.put_whole(map_levels(found.amplitude)),
    }


def _lines(lines: Array, block: Block) -> dict[str, Any]:
    """Lines of a spectrum, as integers if they are multiples of one line."""
    gap = float(np.diff(lines).min(initial=float("inf")))
    number = np.rint(lines / gap)
    if not np.allclose(number * gap, lines, rtol=1e-6, atol=0.0):
        return block.put(lines, "f4")
    return {**block.put_whole(number), "scale": [float(lines[-1] / number[-1])]}


def map_levels(amplitude: Array) -> NDArray[np.uint8]:
    """Amplitudes in 255 equal decibel steps below the maximum; 0 is `DECIBELS` below it, or less.

    Parameters
    ----------
    amplitude
        Any shape, not negative, any unit.

    Examples
    --------
    >>> map_levels(np.array([1.0, 0.1, 1e-4, 0.0])).tolist()
    [255, 191, 0, 0]
    """
    least = 10.0 ** (-DECIBELS / 20.0)
    share = np.maximum(amplitude / max(float(amplitude.max()), np.finfo(np.float64).tiny), least)
    levels = np.rint(_LEVELS * (1.0 + 20.0 * np.log10(share) / DECIBELS))
    return levels.astype(np.uint8)
