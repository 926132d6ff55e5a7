# SPDX-License-Identifier: Apache-2.0
"""Power flow of a machine as plain data: rotating blocks and the power transmitted between them [W]."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

OUTSIDE = -1
"""Number for the surroundings of the blocks: motors, brakes, environment."""


@dataclass(frozen=True, kw_only=True)
class PowerBlock:
    """Rotating block.

    Attributes
    ----------
    name
        Name of the body or shaft.
    speed
        Mean speed about its axis [rad/s].
    stored
        Mean rate of the energy of its rotation and of the deflection of a shaft [W].
    """

    name: str
    speed: float
    stored: float = 0.0


@dataclass(frozen=True, kw_only=True)
class PowerLink:
    """Power transmitted from one block to another.

    Attributes
    ----------
    name, kind
        Name of the element, and drive, load, mesh, coupling, ratio or carrier.
    start, end
        Numbers of the blocks; `OUTSIDE` for the surroundings.
    given, taken
        Mean power that leaves the first and that reaches the second block [W]; `given` is not negative.
    losses
        Mean power losses according to the result, by their description.
    fed
        Mean power supplied to a mesh by its phase-dependent stiffness and static errors [W].
    jumps
        Mean power supplied to a mesh by jumps of its stiffness where tooth pairs enter or leave [W].
    stored
        Mean rate of the elastic energy of a coupling [W].
    """

    name: str
    kind: str
    start: int
    end: int
    given: float
    taken: float
    losses: Mapping[str, float] = field(default_factory=dict)
    fed: float = 0.0
    jumps: float = 0.0
    stored: float = 0.0

    @property
    def lost(self) -> float:
        """Sum of the losses [W]."""
        return sum(self.losses.values())


@dataclass(frozen=True, kw_only=True)
class PowerFlow:
    """Mean powers of a run over a time span.

    Attributes
    ----------
    span
        Beginning and end [s].
    blocks, links
        Rotating blocks, and the power transmitted between them.
    elastic
        Mean rate of the elastic energy in the flanks, bearings and other springs outside of the blocks and
        links [W].
    damped
        Mean power dissipated by the damping of bearings and other springs that are not links, and by Rayleigh
        and modal damping [W].
    booked
        Whether friction power of a mesh is assigned to the driving gear, because its division is unknown.
    unseparated
        Meshes with stiffness jumps whose power is unknown, since the samples do not separate them.
    unfollowed
        Elements that may exchange power but are not among the links.
    """

    span: tuple[float, float]
    blocks: Sequence[PowerBlock]
    links: Sequence[PowerLink]
    elastic: float = 0.0
    damped: float = 0.0
    booked: bool = False
    unseparated: Sequence[str] = ()
    unfollowed: Sequence[str] = ()

    @property
    def put_in(self) -> float:
        """Input power [W]."""
        return sum(link.given for link in self.links if link.start == OUTSIDE)

    @property
    def taken_out(self) -> float:
        """Output power [W]."""
        return sum(link.taken for link in self.links if link.end == OUTSIDE)

    @property
    def lost(self) -> float:
        """Sum of all losses in the result [W]."""
        return sum(link.lost for link in self.links) + self.damped

    @property
    def fed(self) -> float:
        """Power supplied to meshes by phase-dependent stiffness and static errors [W]."""
        return sum(link.fed for link in self.links)

    @property
    def jumps(self) -> float:
        """Power supplied to meshes by jumps of their stiffness [W]."""
        return sum(link.jumps for link in self.links)

    @property
    def stored(self) -> float:
        """Mean rate of the energy stored in rotation and deflection [W]."""
        within = sum(block.stored for block in self.blocks) + sum(link.stored for link in self.links)
        return within + self.elastic

    @property
    def remainder(self) -> float:
        """Remainder of the power balance [W]."""
        return self.put_in + self.fed + self.jumps - self.taken_out - self.lost - self.stored

    def left(self, block: int) -> float:
        """Remainder of the power balance of one block [W].

        Parameters
        ----------
        block
            Number of the block.
        """
        come = sum(link.taken for link in self.links if link.end == block)
        gone = sum(link.given for link in self.links if link.start == block)
        return come - gone - self.blocks[block].stored
