# SPDX-License-Identifier: Apache-2.0
"""Checks common to pairs of cylindrical and of bevel gears: limits and messages.

`problems` and `bevel.problems` supply values and remedies. No check raises: a loader lists all problems.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Protocol

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.tooth_problems import Gear, placed

INTERFERENCE_TOLERANCE = 0.01
"""Tolerated interference along the path of contact in modules, below usual manufacturing tolerances."""
USABLE_CONTACT_RATIO = 1.1
"""Minimum contact ratio for continuous load transfer of a pair with undercut teeth."""
NO_PAIR_IN_CONTACT = "leaves moments without a tooth pair in contact"


class Pair(Protocol):
    """Properties of a pair that the checks use."""

    @property
    def gear1(self) -> Gear:
        """Gear 1."""

    @property
    def gear2(self) -> Gear:
        """Gear 2."""

    @property
    def eps_alpha_form(self) -> float:
        """Transverse contact ratio limited by the root form circles or cones."""

    @property
    def eps_beta(self) -> float:
        """Overlap ratio."""

    @property
    def eps_gamma(self) -> float:
        """Total contact ratio."""


@dataclass(frozen=True)
class Words:
    """Terms of messages about the pairs of one kind of gears.

    Parameters
    ----------
    surface
        Root and base surface: "circle" or "cone".
    tangent
        Limit of the line of action at the base: "tangent point" or "tangent ray".
    path
        Formats a length of the path of contact.
    heights, shifts, lengths
        Remedies: for tips in roots, for tips beyond the base, for a path of contact that is too short.
    """

    surface: str
    tangent: str
    path: Callable[[float], str]
    heights: str
    shifts: str
    lengths: str


def problems_of_pair(
    pair: Pair,
    where: str,
    names: tuple[str, str] | None,
    mismatches: Callable[[], list[Message]],
    contact: Callable[[], list[Message]],
) -> list[Message]:
    """Everything that makes a pair impossible: problems of the gears, mismatches, contact problems.

    Parameters
    ----------
    pair
        The pair.
    where
        Path of the pair in the model.
    names
        Names of the gears in the messages; None omits the problems of each gear.
    mismatches, contact
        Functions that list problems; `contact` is called only if there are no others.
    """
    one, two = names or ("", "")
    alone = pair.gear1.problems(one) + pair.gear2.problems(two)
    try:
        found = (alone if names else []) + mismatches()
        # contact problems of faulty gears would only repeat their problems, with undefined values
        return found if found or alone else contact()
    except GeometryError as error:
        return [*(alone if names else []), placed(where, error)]


def unequal(
    place: str,
    what: str,
    values: tuple[float, float],
    written: Callable[[float], str],
    names: tuple[str, str],
    key: str,
) -> Message:
    """Report a quantity that differs between the gears but must be equal.

    Parameters
    ----------
    place
        Path of the gears of the pair in the model.
    what
        Name of the quantity in the plural.
    values
        Values of both gears.
    written
        Formats a value.
    names
        Names of the gears in the messages.
    key
        Key of the quantity in the model.

    Examples
    --------
    >>> print(unequal("s.gears", "helix angles", (1, 2), str, ("a", "b"), "helix_angle"))
    s.gears: a 1, b 2 have unequal helix angles (limit equal); give both gears the same helix_angle
    """
    value = f"{names[0]} {written(values[0])}, {names[1]} {written(values[1])}"
    return Message(place, f"have unequal {what}", value, "equal", f"give both gears the same {key}")


def wrong_hands(
    place: str, hands: tuple[str, str], names: tuple[str, str], internal: bool = False
) -> Message:
    """Report hands of the helices that do not match.

    Parameters
    ----------
    place
        Path of the gears of the pair in the model.
    hands, names
        Hands of both gears, and their names in the messages.
    internal
        Whether the pair is internal.

    Examples
    --------
    >>> print(wrong_hands("s.gears", ("left", "left"), ("a", "b")))
    s.gears: a left, b left have hands that do not fit an external pair (limit opposite hands); change the \
hand of one gear
    """
    kind, rule = ("internal", "equal") if internal else ("external", "opposite")
    value = f"{names[0]} {hands[0]}, {names[1]} {hands[1]}"
    message = f"have hands that do not fit an {kind} pair"
    return Message(place, message, value, f"{rule} hands", "change the hand of one gear")


def tips_in_roots(
    place: str, clearances: tuple[float, float], names: tuple[str, str], words: Words
) -> list[Message]:
    """Report negative tip clearances.

    Parameters
    ----------
    place
        Path of the pair in the model.
    clearances
        Tip clearance of gear 1 in the root of gear 2, and of gear 2 in the root of gear 1.
    names
        Names of the gears in the messages.
    words
        Terms of the messages.

    Examples
    --------
    >>> words = Words("circle", "tangent point", str, "shorten them", "", "")
    >>> print(*tips_in_roots("s.gears", (1, -2), ("a", "b"), words))
    s.gears: -2 is the tip clearance of b in the root of a (limit above 0); shorten them
    """
    return [
        Message(
            place,
            f"is the tip clearance of {tip} in the root of {root}",
            words.path(c),
            "above 0",
            words.heights,
        )
        for c, tip, root in zip(clearances, names, names[::-1], strict=True)
        if c < 0.0
    ]


def interferences(
    pair: Pair, place: str, beyond: Iterable[float], slack: float, names: tuple[str, str], words: Words
) -> list[Message]:
    """Report interference of tips beyond the mate's base circle or cone.

    Parameters
    ----------
    pair
        The pair.
    place
        Path of the gears of the pair in the model.
    beyond
        Travel of the tip of gear 2 beyond the base of gear 1, then of gear 1 beyond the base of gear 2.
    slack
        Tolerated travel.
    names
        Names of the gears in the messages.
    words
        Terms of the messages.

    Notes
    -----
    The generating rack or crown gear reaches deeper than the tip of any mate: an undercut gear has no
    material there to interfere with, and only the remaining contact ratio matters.
    """
    remains = pair.eps_alpha_form + pair.eps_beta
    found = []
    for over, mate, tip, name in zip(beyond, (pair.gear1, pair.gear2), names[::-1], names, strict=False):
        if over > slack and not (mate.undercut and remains >= USABLE_CONTACT_RATIO):
            message = f"interferes with the root of {name}: it would touch beyond the base {words.surface}"
            limit = f"the {words.tangent}, it is {words.path(over)} beyond"
            if mate.undercut:
                limit += f", and undercut leaves a contact ratio of {remains:.3g} of {USABLE_CONTACT_RATIO:g}"
            found.append(Message(place, message, f"tip of {tip}", limit, words.shifts))
    return found


def odd_contact(
    pair: Pair,
    place: str,
    ends: tuple[tuple[float, str], tuple[float, str]],
    slack: float,
    names: tuple[str, str],
    words: Words,
) -> list[Message]:
    """Report unusual properties of the contact of a possible pair.

    Parameters
    ----------
    pair
        The pair.
    place
        Path of the gears of the pair in the model.
    ends
        For gear 1 and gear 2: length of the path of contact beyond the involute, and the limit as text.
    slack
        Tolerated length.
    names
        Names of the gears in the messages.
    words
        Terms of the messages.

    Notes
    -----
    If a tip reaches below the mate's root form circle or cone, the path of contact is still that of the tips
    (as in published contact ratios), although the involute ends earlier, depending on the tool, which is
    rarely known exactly. A total contact ratio below 1 leaves moments without contact.
    """
    found = []
    for (missing, limit), mate, tip, name in zip(
        ends, (pair.gear1, pair.gear2), names[::-1], names, strict=True
    ):
        if missing > slack:
            cause = "undercut" if mate.undercut else "root fillet"
            message = f"reaches below the root form {words.surface} of {name} ({cause})"
            left = f"the transverse contact ratio left is {pair.eps_alpha_form:.4g}"
            remedy = f"{left}; shorten the tip or set the rack"
            found.append(Message(place, message, f"tip of {tip}", limit, remedy))
    if pair.eps_gamma < 1.0:
        value = f"total contact ratio {pair.eps_gamma:.4g}"
        found.append(Message(place, NO_PAIR_IN_CONTACT, value, "1", words.lengths))
    return found
