# SPDX-License-Identifier: Apache-2.0
"""Bearings by designation: a table of common sizes, and the meaning of suffixes.

Source of the table: see the head of `catalogue.csv`. Suffixes: ISO 5753-1 (clearance), and the catalogues of
SKF, FAG, NSK and NTN for seals, cages, inner designs, and the clearance of miniature and motor bearings.
"""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.nearest import nearest
from pitchpoint.geometry.bearings.clearance import ALL_CLASSES, CLASSED

OFFERED = 4
"""Number of similar designations in a message."""
MAKERS = "SKF|FAG|INA|NSK|NTN|SNR|KOYO|JTEKT|NACHI|TIMKEN|URB|ZVL|ZKL|NKE|HR"
# suffixes without effect on stiffness or clearance
_SEALS = r"2HRS|2?RS[RHDL]?\d?|2RZ\d?|2?Z[RNZ]?1?|LL[UBHF]|L[UBH]|DD[UW]?|VV|2BRS"
_CAGES = (
    r"ECB?[PJMY][LA]?|EC|EM\d?|EW|ET|EJ|EG15|E1|E|TVP[2B]?|TVH|TN[9GH]?|M[ABLPS\d]?|P|PH|J\d?|XJ?|A|"
    r"BE[PJYM]?|CA?|CAM"
)
_OTHERS = r"XL|W33|P[456]|P6X|NR?|Q|F1?|C[CDJ]E?\d?|CAM?E\d?|EAE\d|V[AL]\d+|MT33|HT|LHT|GJN|WT|G\d+"
_WORD = rf"(?:{_SEALS}|{_CAGES}|{_OTHERS})"
_PLAIN = re.compile(rf"{_WORD}{_WORD}?")
_REFUSED = {
    "V": "a full complement of rolling elements",
    "VH": "a full complement of rolling elements",
    "C1": "the clearance class C1, which is not tabulated",
    "C5": "the clearance class C5, which is not tabulated",
    "DB": "a pair of bearings",
    "DF": "a pair of bearings",
}
_OTHER_TYPES = (
    (r"NKI[AS]?-?\d", "a needle roller bearing with inner ring", "give type: needle_roller and the data"),
    (
        r"(NKS?|HK|BK|HN)-?\d",
        "a needle roller bearing without inner ring",
        "give type: needle_roller_on_shaft and the data, with F_w as inner_diameter",
    ),
    (r"KB?K?-?\d", "a needle roller and cage assembly", "give type: roller and its elements"),
    (r"QJF?-?\d", "a four-point contact bearing, which is not available", ""),
    (r"29[234]\d\d", "a spherical roller thrust bearing, which is not available", ""),
    (r"(8[17][12]\d\d|AXK)", "a roller thrust bearing, which is not available", ""),
    (r"(5[234][234]\d\d)", "a double-direction or aligning thrust bearing, which is not available", ""),
    (r"20[234]\d\d", "a barrel roller bearing, which is not available", ""),
)
"""Beginning of designations that the table lacks, their type, and what to do."""
_SMALL = re.compile(r"6\d\d(?!\d)|MR-?\d")
"""Ball bearings with a bore of less than 10 mm."""
_CERAMIC = re.compile(r"HC\d?")
"""Beginning of the suffix of hybrid bearings: elements of silicon nitride."""
_CERAMIC_PAIR = "{youngs_modulus: 245 GPa, poisson_ratio: 0.3, density: 3200 kg/m^3}"
"""Material with the mean (1 - nu^2)/E of silicon nitride and steel; silicon nitride: 310 GPa (SKF, *General
Catalogue*, table of materials) and nu 0.26."""
_NUMBER = re.compile(
    r"(?:(NUP|NU|NJ|N)-?(\d{3,4})|(R?NA)-?(4[89]\d\d|4[89]-\d\d)|(6[023]-(?:22|28|32)|\d{3,5}))-?"
)
_ANGLES = (("ACD", "A5"), ("AC", "A5"), ("A5", "A5"), ("A", "A"), ("B", "B"), ("C", "C"))
"""Beginning of the suffix of angular contact bearings, and the suffix of the table: 25, 25, 25, 30, 40, 15
deg."""
_DOUBLE_ROW = re.compile(r"(BD|A|B)-?|(DN|D(?!D)|E)")
"""Beginning of the suffix of double-row angular contact bearings: those of `_DOUBLE_ROW_ANGLES`, and those of
filling slots (E) and of two inner rings (D), whose angle differs between makers."""
_DOUBLE_ROW_ANGLES = {"A": 30.0, "B": 25.0, "BD": 30.0}
"""Contact angle by suffix [deg]: A of SKF, B and BD of FAG."""


@dataclass(frozen=True)
class Catalogued:
    """One bearing of the table.

    Attributes
    ----------
    designation
        Designation in the table.
    kind
        Type, one of `geometry.bearings.inner.TYPES`.
    bore, outside, width
        Boundary dimensions d, D, B [m]; of tapered bearings the overall width T.
    dynamic, static
        Load ratings C and C_0 [N].
    angle
        Contact angle [rad].
    group
        Clearance class by the suffix; None if there is none.
    flanges
        Number of flanges that take axial forces (cylindrical rollers): 1 NJ, 2 NUP; 0 the others.
    raceway
        Raceway diameter F_w of the inner ring [m], if the table has it (needle rollers).
    by_maker
        Whether the contact angle is that of the maker of the table because the designation has no suffix of
        it, and others differ (double-row angular contact bearings).
    """

    designation: str
    kind: str
    bore: float
    outside: float
    width: float
    dynamic: float
    static: float
    angle: float
    group: str | None = None
    flanges: int = 0
    raceway: float | None = None
    by_maker: bool = False


@cache
def catalogue() -> dict[str, Catalogued]:
    """All bearings of the table by designation.

    Examples
    --------
    >>> found = catalogue()["6308"]
    >>> found.kind, found.outside, found.dynamic
    ('deep_groove_ball', 0.09, 40500.0)
    """
    found = {}
    for table in ("catalogue.csv", "catalogue_ntn.csv"):
        text = Path(__file__).with_name(table).read_text(encoding="utf-8")
        for row in csv.DictReader(line for line in text.splitlines() if not line.startswith("#")):
            d, D, B = (round(1e-3 * float(row[key]), 9) for key in ("d", "D", "B"))
            found[row["designation"]] = Catalogued(
                row["designation"],
                row["type"],
                bore=d,
                outside=D,
                width=B,
                dynamic=float(row["C"]),
                static=float(row["C0"]),
                angle=math.radians(float(row["contact_angle"] or 0.0)),
            )
    return found


def by_designation(text: str) -> Catalogued:
    """Bearing of the table with the given designation, which may have suffixes.

    Parameters
    ----------
    text
        Designation, such as "6308-2RS1/C3" or "SKF NJ 208 ECP".

    Raises
    ------
    GeometryError
        If the bearing is not in the table, or a suffix is not understood.

    Examples
    --------
    >>> found = by_designation("SKF NJ 208 ECP/C3")
    >>> found.designation, found.group
    ('NU208E', 'C3')
    >>> by_designation("6308-2RS").bore, by_designation("63/22").bore
    (0.04, 0.022)
    >>> [round(math.degrees(by_designation(name).angle)) for name in ("3208", "3208 A", "3208-B-TVH")]
    [25, 30, 25]
    """
    plain = re.sub(r"[\s/,._-]+", "-", str(text).upper().strip()).strip("-")
    plain = re.sub(rf"^(?:(?:{MAKERS})-)+", "", plain)
    match = _NUMBER.match(plain)
    if match is None:
        raise _unknown(text, plain)
    design, cylindrical, needle, size, digits = match.groups()
    rest = plain[match.end() :]
    if design is not None:
        name, rest = _cylindrical(design, cylindrical, rest)
    elif needle is not None:
        name = needle + size.replace("-", "/")
    else:
        name, rest = _numbered(text, digits, rest)
    found = catalogue().get(name)
    if found is None:
        raise _unknown(text, name)
    if needle == "NA":
        found = replace(found, raceway=catalogue()[f"R{name}"].bore)
    if found.kind == "double_row_angular_contact_ball":
        found, rest = _double_row(text, found, rest)
    found = replace(found, flanges={"NJ": 1, "NUP": 2}.get(design or "", 0))
    return replace(found, group=_group(text, rest, found))


def _cylindrical(design: str, digits: str, rest: str) -> tuple[str, str]:
    """Name in the table of a cylindrical roller bearing: the E design has larger rollers."""
    if rest.startswith("E"):
        return f"NU{digits}E", rest
    names = [f"NU{digits}", f"N{digits}"]  # the same rollers; the table has one or both
    if design == "N":
        names.reverse()
    return next((name for name in names if name in catalogue()), names[0]), rest


def _numbered(text: str, digits: str, rest: str) -> tuple[str, str]:
    """Name in the table of a bearing without prefix, and the remaining suffixes."""
    if "-" in digits:  # bores between two sizes, such as 63/22
        return digits.replace("-", "/"), rest
    if re.fullmatch(r"61[89]\d\d", digits):  # the same bearing in two systems of numbers
        digits = "6" + digits[2:]
    elif re.fullmatch(r"5[23]\d\d", digits):
        digits = "3" + digits[1:]
    inclined = [row for name, row in catalogue().items() if name[:-1] == digits and name[-1] in "ABC"]
    if not inclined or digits in catalogue():
        return digits, rest
    for begins, suffix in _ANGLES:
        if rest.startswith(begins):
            return digits + suffix, rest[len(begins) :].lstrip("-")
    angles = ", ".join(f"{row.designation} ({math.degrees(row.angle):.0f} deg)" for row in inclined)
    raise GeometryError(
        "has no letter of its contact angle, on which makers disagree",
        value=str(text),
        remedy=f"write one of {angles}; B is the usual one, and A (30 deg) is not written by all makers",
    )


def _double_row(text: str, found: Catalogued, rest: str) -> tuple[Catalogued, str]:
    """Double-row angular contact bearing with the contact angle of its suffix, and the remaining suffixes."""
    match = _DOUBLE_ROW.match(rest)
    if match is None:
        return replace(found, by_maker=True), rest
    letters, differs = match.groups()
    if differs is not None:
        raise GeometryError(
            f"has the suffix {differs}, with which the contact angle differs between makers",
            value=str(text),
            remedy=f"write {found.designation}, and give contact_angle",
        )
    return replace(found, angle=math.radians(_DOUBLE_ROW_ANGLES[letters])), rest[match.end() :]


def _group(text: str, rest: str, found: Catalogued) -> str | None:
    """Clearance class of a suffix; refuses what it does not understand."""
    words = _words(rest, found)
    classes = ["CN" if word == "C0" else word for word in words if word in (*ALL_CLASSES, "C0")]
    if len(set(classes)) > 1:
        raise GeometryError(
            f"has the clearance classes {' and '.join(classes)}",
            value=str(text),
            remedy=f"write {found.designation} with one of them",
        )
    group = classes[0] if classes and found.kind in CLASSED else None
    for word in words:
        if word in _REFUSED:
            raise GeometryError(
                f"has the suffix {word}, {_REFUSED[word]}",
                value=str(text),
                remedy=f"use {found.designation}, and give clearance or the data that differ",
            )
        if _CERAMIC.match(word):
            plain = " ".join(filter(None, (found.designation, group)))
            raise GeometryError(
                f"has the suffix {word}: elements of ceramic, and material is that of elements and rings",
                value=str(text),
                remedy=f"write {plain}, and for elements of silicon nitride in rings of steel "
                f"material: {_CERAMIC_PAIR}",
            )
        if word in (*ALL_CLASSES, "C0"):
            continue
        if word.endswith("K") and (word == "K" or _PLAIN.fullmatch(word[:-1])):
            raise GeometryError(
                "has a tapered bore (K), whose clearance is set on mounting",
                value=str(text),
                remedy=f"write {found.designation}, and give clearance",
            )
        if _PLAIN.fullmatch(word) is None:
            raise GeometryError(
                f"has the suffix {word}, which is not known",
                value=str(text),
                remedy=f"write {found.designation}, with C2, CN, C3 or C4 for the clearance",
            )
    return group


def _words(rest: str, found: Catalogued) -> list[str]:
    """Suffixes, with the clearance class as a word of its own.

    MC1 to MC6 in one word are classes of deep groove ball bearings, those of other types are a cage M and a
    class. ECM is the design EC with a cage M.
    """
    rest = re.sub(r"(?<![A-Z0-9])(HC\d?)(?=C[0-5N])", r"\1-", rest)
    cage = "0N" if found.kind == "deep_groove_ball" else "0-6N"  # classes that a cage M may precede
    rest = re.sub(rf"M(C[{cage}])(?=-|$|[A-Z])", r"M-\1", rest)
    rest = re.sub(r"(?<=[A-Z0-9])(MC[1-6]|(?<!E)CM|(?<![HM])C[0-5N])(?=-|$)", r"-\1", rest)
    rest = re.sub(r"(?<![A-Z0-9])(M?C[0-6])(?=[A-Z])", r"\1-", rest)
    return [word for word in rest.split("-") if word]


def _unknown(text: str, plain: str) -> GeometryError:
    """Problem of a designation that the table does not have, with the nearest ones."""
    for begins, what, remedy in _OTHER_TYPES:
        if re.match(begins, plain):
            other = "use bearings with the stiffness of the catalogue"
            return GeometryError(f"is {what}", value=str(text), remedy=remedy or other)
    near = nearest(plain, catalogue(), OFFERED)
    meant = f"did you mean {' or '.join(near)}? " if near else ""
    if _SMALL.match(plain):
        meant = "with a bore below 10 mm it has 603 to 609, 623 to 629 and 694 to 699; "
    return GeometryError(
        "is not in the table of bearings",
        value=str(text),
        remedy=f"{meant}other bearings: give type, inner_diameter (d), outer_diameter (D), width (B), "
        "radial_dynamic_load_rating (C) and radial_static_load_rating (C0) of the catalogue",
    )
