# SPDX-License-Identifier: Apache-2.0
"""Powers of a machine as plain numbers: blocks that turn, and what goes from one to the next [W]."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

OUTSIDE = -1
"""Number that represents all that is not a block: motors, brakes, surroundings."""


@dataclass(frozen=True, kw_only=True)
class PowerBlock:
    """Something that turns.

    Attributes
    ----------
    name
        Name of the body or shaft.
    speed
        Mean speed about its own axis [rad/s].
    stored
        Mean rate of the energy of its rotation [W].
    """

    name: str
    speed: float
    stored: float = 0.0


@dataclass(frozen=True, kw_only=True)
class PowerLink:
    """Power that goes from one block to another.

    Attributes
    ----------
    name, kind
        Name of the element, and drive, load, mesh, coupling, ratio or carrier.
    start, end
        Numbers of the blocks; `OUTSIDE` for what is none.
    given, taken
        Mean power that leaves the first and that reaches the second [W]; given is not negative.
    losses
        Mean powers lost on the way according to the result, by words.
    fed
        Mean power that a mesh gets from what moves with its phase: stiffness and static errors [W].
    """

    name: str
    kind: str
    start: int
    end: int
    given: float
    taken: float
    losses: Mapping[str, float] = field(default_factory=dict)
    fed: float = 0.0

    @property
    def lost(self) -> float:
        """All losses on the way [W]."""
        return sum(self.losses.values())


@dataclass(frozen=True, kw_only=True)
class PowerFlow:
    """Mean powers of a run over a span of time.

    Attributes
    ----------
    span
        Beginning and end [s].
    blocks, links
        What turns, and what goes between.
    elastic
        Mean rate of the energy in the flanks [W].
    booked
        Whether friction of some mesh counts for the gear that drives, as nothing states what it does to each.
    unfollowed
        Elements that may take or give power and are not among the links.
    """

    span: tuple[float, float]
    blocks: Sequence[PowerBlock]
    links: Sequence[PowerLink]
    elastic: float = 0.0
    booked: bool = False
    unfollowed: Sequence[str] = ()

    @property
    def put_in(self) -> float:
        """Power from outside [W]."""
        return sum(link.given for link in self.links if link.start == OUTSIDE)

    @property
    def taken_out(self) -> float:
        """Power to the outside [W]."""
        return sum(link.taken for link in self.links if link.end == OUTSIDE)

    @property
    def lost(self) -> float:
        """All losses that the result knows [W]."""
        return sum(link.lost for link in self.links)

    @property
    def fed(self) -> float:
        """Power that meshes get from what moves with their phase [W]."""
        return sum(link.fed for link in self.links)

    @property
    def stored(self) -> float:
        """Mean rate of the energy in rotation and flanks [W]."""
        return sum(block.stored for block in self.blocks) + self.elastic

    @property
    def remainder(self) -> float:
        """What none of these numbers accounts for [W]."""
        return self.put_in + self.fed - self.taken_out - self.lost - self.stored

    def left(self, block: int) -> float:
        """What comes to one block, is not stored in it and does not leave it again [W].

        Parameters
        ----------
        block
            Its number.
        """
        come = sum(link.taken for link in self.links if link.end == block)
        gone = sum(link.given for link in self.links if link.start == block)
        return come - gone - self.blocks[block].stored
