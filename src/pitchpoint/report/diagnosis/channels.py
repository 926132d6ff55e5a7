# SPDX-License-Identifier: Apache-2.0
"""Which channels are tested, and which meshes and bearings each of them is near to."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from shlex import quote

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import TurningParts
from pitchpoint.core.nearest import hint

PREFERRED = (
    ("signal",),
    ("acceleration",),
    ("bearing_force", "support_force"),
    ("transmission_error", "mesh_force"),
)
"""Quantities of result files tested by default: sensors first, then internal quantities."""
USUAL, MOST = 6, 12
"""Default number of channels of a result, and the largest one if meshes and bearings require more."""
_TOKEN = re.compile(r"[A-Za-z]+|\d+")


@dataclass(frozen=True)
class Places:
    """Where channels are on the machine, by the options or by their names.

    Attributes
    ----------
    parts
        Rotating parts of the machine.
    bodies
        Names of shafts by what the user may write.
    given
        Parts named by the user for a channel.
    meshes_at
        Meshes at each body of a model. Equal meshes of several sides of a machine are merged in `parts`, but
        a channel is near those of its side only.
    """

    parts: TurningParts
    bodies: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    meshes_at: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def near(self, channel: str) -> frozenset[str]:
        """Meshes and bearings next to a channel; empty if unknown.

        A channel is near the parts that an option names for it, else near the mesh, bearing or body with the
        longest name within its own name. That of a body is near all meshes and bearings of its shaft, that of
        a bearing also near the meshes of its shaft.

        Examples
        --------
        >>> from pitchpoint.analysis.turning_parts import train_parts
        >>> places = Places(train_parts([(21, 40), (17, 60)]))
        >>> sorted(places.near("acc mesh 2")), sorted(places.near("shaft 2 x")), sorted(places.near("acc"))
        (['mesh 2'], ['mesh 1', 'mesh 2'], [])
        """
        names = self.given.get(channel) or self._named_in(channel)
        return frozenset(part for name in names for part in self._around(name))

    def singly(self, channel: str) -> frozenset[str]:
        """Meshes and bearings next to a channel, each of merged ones by its own name.

        Examples
        --------
        >>> from pitchpoint.analysis.turning_parts import Mesh, Shaft, TurningParts
        >>> mesh = Mesh("left or right", ("z1", "z2"), (20, 40), ("a or a2", "b or b2"))
        >>> shafts = (Shaft("a or a2", 1), Shaft("b or b2", 0.5))
        >>> bodies = {"a": "a or a2", "a2": "a or a2"}
        >>> parts, sides = TurningParts(shafts, (mesh,)), {"a": ("left",), "a2": ("right",)}
        >>> places = Places(parts, bodies, meshes_at=sides)
        >>> sorted(places.singly("force a2")), sorted(places.near("force a2"))
        (['right'], ['left or right'])
        """
        names = self.given.get(channel) or self._named_in(channel)
        found = set()
        for name in names:
            around = {single for part in self._around(name) for single in each(part)}
            meshes = {single for mesh in self.parts.meshes for single in each(mesh.name)}
            if name in self.meshes_at:
                around = around - meshes | set(self.meshes_at[name])
            elif name in meshes:
                around = {name}
            found |= around
        return frozenset(found)

    def known(self) -> list[str]:
        """Names that a channel may be near to: bearings, meshes, shafts."""
        shafts = [shaft.name for shaft in self.parts.shafts]
        singles = [b.name for b in self.parts.bearings] + [n for m in self.parts.meshes for n in each(m.name)]
        return list(dict.fromkeys([*singles, *shafts, *self.bodies]))

    def _named_in(self, channel: str) -> list[str]:
        """Names with the most words within the name of a channel."""
        words = _words(channel)
        found: dict[str, int] = {}
        for name in self.known():
            own = _words(name)
            # a number alone is that of a channel, not of a shaft
            if not own or (len(own) == 1 and own[0].isdecimal()):
                continue
            if any(words[k : k + len(own)] == own for k in range(len(words) - len(own) + 1)):
                found[name] = len(own)
        return [name for name, count in found.items() if count == max(found.values())]

    def _around(self, name: str) -> set[str]:
        """Meshes and bearings at a mesh, a bearing or a shaft."""
        meshes, bearings = self.parts.meshes, self.parts.bearings
        held = {b.shaft for b in bearings if b.name == name} - {""}
        found = {b.name for b in bearings if b.name == name}
        found |= {m.name for m in meshes if name == m.name or name in each(m.name)}
        shaft = self.bodies.get(name, name) if not found else ""
        found |= {b.name for b in bearings if shaft and b.shaft == shaft}
        return found | {m.name for m in meshes if {shaft, *held} & set(m.shafts)}

    def all_parts(self) -> list[str]:
        """Names of all meshes and bearings, each of merged ones by its own name."""
        merged = [m.name for m in self.parts.meshes] + [b.name for b in self.parts.bearings]
        return [name for one in merged for name in each(one)]

    def remark(self, tested: Iterable[str], more: bool) -> list[str]:
        """Remark on meshes and bearings without a tested channel near them; none if no place is known.

        Parameters
        ----------
        tested
            Tested channels.
        more
            Whether the file has further channels.
        """
        tested = list(tested)
        seen = frozenset().union(*map(self.singly, tested))
        lost = [part for part in self.all_parts() if part not in seen]
        if not seen:
            return []
        inside = [name for name in tested if _is_internal(name)]
        notes = []
        if inside and len(inside) < len(tested):
            sensed = frozenset().union(*(self.singly(name) for name in tested if name not in inside))
            blind = [part for part in self.all_parts() if part not in sensed]
            if blind:
                notes.append(f"no sensor is near {', '.join(blind)}: {', '.join(inside)} tested instead")
        if lost:
            remedy = "; --all-channels tests all" if more else ""
            notes.append(f"no tested channel is near {', '.join(lost)}{remedy}")
        return notes


def each(merged: str) -> list[str]:
    """Single names of merged parts.

    Examples
    --------
    >>> each("left or right")
    ['left', 'right']
    """
    return merged.split(" or ")


def preferred(names: Sequence[str], places: Places | None = None) -> list[str]:
    """Default channels of a result for a diagnosis.

    Six of the first quantity of `PREFERRED` that the result has, or up to twelve if the meshes and bearings
    require more: one near each of them, of the further quantities only where no sensor is near.

    Parameters
    ----------
    names
        Channels of the result.
    places
        Where they are.

    Examples
    --------
    >>> preferred(["angle[a]", "mesh_force[m]", "transmission_error[m]", "speed[a]"])
    ['transmission_error[m]', 'mesh_force[m]']
    """
    found = next((one for group in PREFERRED if (one := _of(group, names))), [])
    count = min(USUAL, len(found))
    # spread over the list, because neighbours are often from one shaft
    spread = [found[k * len(found) // count] for k in range(count)]
    if places is None:
        return spread
    near = {name: places.singly(name) for name in every_quantity(names)}
    sensed = frozenset().union(*(near[name] for name in found))
    if not sensed:
        return spread
    chosen = spread
    if not sensed <= frozenset().union(*(near[name] for name in spread)):
        chosen = _nearest(found, near, sensed, MOST)
        chosen += [name for name in spread if name not in chosen][: max(USUAL - len(chosen), 0)]
    # internal quantities only next to what no sensor is near to
    for group in PREFERRED[1:]:
        chosen += _nearest(_of(group, names), near, set(places.all_parts()) - sensed, MOST - len(chosen))
        sensed = sensed.union(*(near[name] for name in chosen))
    return [name for name in near if name in chosen]


def _nearest(
    names: Sequence[str], near: Mapping[str, frozenset[str]], wanted: AbstractSet[str], most: int
) -> list[str]:
    """Few channels that are near to as many of the wanted parts as possible, radial ones first."""
    chosen: list[str] = []
    left = set(wanted)
    while left and len(chosen) < most:
        best = max(names, key=lambda name: (len(near[name] & left), "axial" not in name), default="")
        if not best or not near[best] & left:
            break
        chosen.append(best)
        left -= near[best]
    return chosen


def every_quantity(names: Sequence[str]) -> list[str]:
    """All channels of the quantities of `PREFERRED`, in the order of the file."""
    return _of(tuple(quantity for group in PREFERRED for quantity in group), names)


def _of(quantities: Sequence[str], names: Sequence[str]) -> list[str]:
    """Channels of quantities, ordered by quantity; the direction of a force, an angle that jumps, is none."""
    kept = [name for name in names if not name.endswith(".direction]")]
    return [name for quantity in quantities for name in kept if name.partition("[")[0] == quantity]


def given_places(texts: Sequence[str], channels: Iterable[str], places: Places) -> dict[str, tuple[str, ...]]:
    """Parts by channel of the options `--sensor CHANNEL=PART`; `*` in CHANNEL matches any characters.

    Raises
    ------
    SignalError
        If an option cannot be read, or its channel or part is unknown.
    """
    names, known = list(channels), places.known()
    found: dict[str, tuple[str, ...]] = {}
    for text in texts:
        channel, sign, part = (piece.strip() for piece in text.rpartition("="))
        if not sign or not channel or not part:
            raise SignalError(
                f"--sensor: {text!r} is not CHANNEL=PART; write it as in acc_1=left, where left is a "
                "bearing, a mesh or a shaft"
            )
        if part not in known:
            raise SignalError(f"--sensor: no bearing, mesh or shaft {part!r}; {hint(part, known)}")
        for name in matching(channel, names, "--sensor"):
            found[name] = (*found.get(name, ()), part)
    return found


def matching(pattern: str, names: Sequence[str], option: str) -> list[str]:
    """Channels of a name, in which `*` matches any characters.

    Raises
    ------
    SignalError
        If there is none.

    Examples
    --------
    >>> matching("*_DE_time", ["X105_DE_time", "X105_FE_time"], "--sensor")
    ['X105_DE_time']
    """
    if pattern in names:
        return [pattern]
    expression = ".*".join(re.escape(piece) for piece in pattern.split("*"))
    found = [name for name in names if re.fullmatch(expression, name)]
    if not found:
        raise SignalError(f"{option}: no channel {quote(pattern)}; {hint(pattern, names, 3)}")
    return found


def _is_internal(name: str) -> bool:
    """Whether a channel is an internal quantity of a simulation, not that of a sensor."""
    return any(name.startswith(f"{quantity}[") for group in PREFERRED[2:] for quantity in group)


def _words(name: str) -> list[str]:
    """Words and numbers of a name, in lower case."""
    return [word.lower() for word in _TOKEN.findall(name)]
