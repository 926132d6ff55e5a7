# SPDX-License-Identifier: Apache-2.0
"""Standard basic rack tooth profile (ISO 53), the tool-independent reference profile of a gear."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.plain_numbers import real_number
from pitchpoint.core.short_repr import ShortRepr


@dataclass(frozen=True, kw_only=True)
class BasicRack(ShortRepr):
    """Basic rack of a gear, lengths in normal modules.

    Parameters
    ----------
    h_aP_star
        Addendum of the basic rack, h_aP* [-].
    h_fP_star
        Dedendum of the basic rack, h_fP* [-]; the addendum of the generating tool.
    rho_fP_star
        Root fillet radius of the basic rack, ρ_fP* [-]; the tip radius of the generating tool.

    Raises
    ------
    GeometryError
        If a value is not finite, an addendum or dedendum is not positive, or the radius is negative or
        larger than the dedendum.

    Examples
    --------
    >>> BasicRack().h_fP_star
    1.25
    """

    h_aP_star: float = 1.0
    h_fP_star: float = 1.25
    rho_fP_star: float = 0.38

    def __post_init__(self) -> None:
        for name, words in (("h_aP_star", "addendum"), ("h_fP_star", "dedendum")):
            value = getattr(self, name)
            if (number := real_number(value)) is None or not 0.0 < number <= 100.0:
                raise GeometryError(
                    f"is not a {words} of a basic rack",
                    where=f"rack.{words}",
                    value=f"{value!r}",
                    limit="above 0 and at most 100 modules",
                    remedy="give it in modules, usually 1 to 1.4",
                )
        rho = self.rho_fP_star
        if (number := real_number(rho)) is None or not 0.0 <= number <= self.h_fP_star:
            raise GeometryError(
                "is not a root radius of a basic rack",
                where="rack.root_radius",
                value=f"{rho!r}",
                limit=f"0 to the dedendum {self.h_fP_star:g}",
                remedy="give it in modules, usually 0.2 to 0.4",
            )

    def h_FfP_star(self, alpha_n: float) -> float:
        """Depth of the straight flank below the datum line, h_FfP* = h_fP* − ρ_fP* (1 − sin α_n) [-].

        Examples
        --------
        >>> round(BasicRack().h_FfP_star(math.radians(20.0)), 6)
        0.999968
        """
        return self.h_fP_star - self.rho_fP_star * (1.0 - math.sin(alpha_n))

    def rho_fP_star_max(self, alpha_n: float) -> float:
        """Largest possible root radius of the rack (full rounding) [-].

        Notes
        -----
        The centre of the fillet is π/4 − h_fP* tan α_n − ρ (1 − sin α_n)/cos α_n modules from the middle of
        the space; zero is full rounding (ISO 53). A negative radius means that the flanks cross above the
        root.

        Examples
        --------
        >>> round(BasicRack().rho_fP_star_max(math.radians(20.0)), 4)
        0.4719
        """
        room = 0.25 * math.pi - self.h_fP_star * math.tan(alpha_n)
        return room * math.cos(alpha_n) / (1.0 - math.sin(alpha_n))
