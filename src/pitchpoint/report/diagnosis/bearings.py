# SPDX-License-Identifier: Apache-2.0
"""Rolling bearings of the option `--bearing`: by rolling elements, by designation, by fault orders."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from shlex import quote

from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import Bearing, TurningParts
from pitchpoint.core.errors import GeometryError, Message, UnitError
from pitchpoint.core.nearest import nearest
from pitchpoint.report.machine_parts import BEARING_PARTS

EXAMPLES = (
    "left:8,7.94 mm,33.5 mm,0 deg@2 (elements, diameter, pitch diameter, contact angle), left:6205@2, or "
    "left:BPFO=3.58,BPFI=5.42,BSF=2.36,FTF=0.398@2"
)
_OPTION = re.compile(r"(?:([^:@]+):)?([^:@][^@]*)(?:@(.+))?")
_FAULTS = {
    "BPFO": ("outer ring", 1.0),
    "BPFI": ("inner ring", 1.0),
    "BSF": ("rolling element", 2.0),
    "FTF": ("cage", 1.0),
}


@dataclass(frozen=True)
class GivenBearing:
    """Bearing of an option, and the source of its orders in words."""

    bearing: Bearing
    source: str


def given_bearing(text: str, parts: TurningParts, names: Mapping[str, str]) -> GivenBearing:
    """Bearing of `NAME:WHAT[@SHAFT]`, where WHAT are rolling elements, a designation or fault orders.

    Parameters
    ----------
    text
        The option.
    parts
        Rotating parts of the machine.
    names
        Names of shafts by what the user may write.

    Raises
    ------
    SignalError
        If the option cannot be read, or the bearing or its shaft is unknown.
    """
    name, orders, source, at = read_bearing(text)
    shaft = _shaft(text, at, parts, names)
    turn = float(parts.shaft(shaft).order)
    return GivenBearing(Bearing(name, {part: turn * order for part, order in orders.items()}, shaft), source)


def read_bearing(text: str) -> tuple[str, dict[str, float], str, str]:
    """Name, events per revolution of its shaft by part, source of these, and shaft of a bearing option.

    A designation without a name is the name as well.

    Raises
    ------
    SignalError
        If the option cannot be read, or the bearing is unknown or impossible.

    Examples
    --------
    >>> name, orders, _, _ = read_bearing("6205")
    >>> name, round(orders["outer ring"], 2)
    ('6205', 3.57)
    """
    match = _OPTION.fullmatch(text.strip())
    if match is None or (match[1] is None and {",", "="} & set(match[2])):
        raise SignalError(f"--bearing: {text!r} is not NAME:BEARING@SHAFT; write it as in {EXAMPLES}")
    what, at = match[2].strip(), (match[3] or "").strip()
    name = (match[1] or what).strip()
    if "=" in what:
        return name, _of_orders(text, what), "fault orders of --bearing", at
    if "," in what:
        return name, _of_elements(text, what), "rolling elements of --bearing", at
    return name, *_of_designation(text, what), at


def _shaft(text: str, at: str, parts: TurningParts, names: Mapping[str, str]) -> str:
    """Name of the shaft; the only one of the machine if it is not given."""
    if not at:
        if len(parts.shafts) == 1:
            return parts.shafts[0].name
        raise SignalError(
            f"--bearing: {text!r} has no shaft; write {quote(text + '@SHAFT')}; there are: {', '.join(names)}"
        )
    shaft = names.get(at)
    if shaft is None:
        raise SignalError(f"--bearing: no shaft {at!r}; there are: {', '.join(names)}")
    return shaft


def _of_orders(text: str, what: str) -> dict[str, float]:
    """Events per revolution of the shaft by part."""
    found = {}
    for field in what.split(","):
        key, _, value = field.partition("=")
        part, times = _FAULTS.get(key.strip().upper(), ("", 0.0))
        try:
            order = float(value)
        except ValueError:
            order = math.nan
        if not part or not 0.0 < order < 1e4:
            raise SignalError(
                f"--bearing: {text!r}: {field.strip()!r} is not a fault order; write {', '.join(_FAULTS)} "
                "with the "
                "events per revolution of the shaft, such as BPFO=3.58"
            )
        found[part] = times * order
    inner, outer = found.get("inner ring", math.inf), found.get("outer ring", 0.0)
    if outer >= inner:
        raise SignalError(
            f"--bearing: {text!r}: BPFO {outer:g} (limit below BPFI {inner:g} if the inner ring rotates); "
            "exchange them"
        )
    return found


def _of_elements(text: str, what: str) -> dict[str, float]:
    """Orders of rolling elements N,d,D[,angle]."""
    from pitchpoint.core.units import parse_quantity

    fields = what.split(",")
    if len(fields) not in (3, 4):
        raise SignalError(f"--bearing: {text!r} is not NAME:BEARING@SHAFT; write it as in {EXAMPLES}")
    try:
        count = int(fields[0])
        diameter = parse_quantity(fields[1].strip(), "length", positive=True)
        pitch = parse_quantity(fields[2].strip(), "length", positive=True)
        angle = parse_quantity(fields[3].strip(), "angle") if len(fields) == 4 else 0.0
        orders = _orders(count, diameter, pitch, angle)
    except (ValueError, UnitError) as error:
        raise SignalError(f"--bearing: {text!r}: {error}; write it as in {EXAMPLES}") from None
    if diameter > pitch * math.sin(math.pi / count):
        most = int(math.pi / math.asin(diameter / pitch))
        raise SignalError(
            f"--bearing: {text!r}: {count} rolling elements (limit {most} on this pitch diameter)"
        )
    if not 0.0 <= angle < 0.5 * math.pi:
        raise SignalError(
            f"--bearing: {text!r}: contact angle {math.degrees(angle):.4g} deg (limit 0 to 90 deg); state "
            "its unit"
        )
    return orders


def _of_designation(text: str, what: str) -> tuple[dict[str, float], str]:
    """Orders of a bearing of the tables, and their source."""
    from pitchpoint.geometry.bearings.designation import catalogue
    from pitchpoint.geometry.bearings.published import rolling_elements

    try:
        found = rolling_elements(what)
    except GeometryError as error:
        # its remedy is for model files
        near = nearest(what.upper(), catalogue(), 2)
        meant = f"did you mean {' or '.join(near)}? " if near else ""
        problem = Message("", error.problem.text, what, remedy=f"{meant}write it as in {EXAMPLES}")
        raise SignalError(f"--bearing: {text!r}: {problem}") from None
    orders = _orders(found.elements, found.element_diameter, found.pitch_diameter, found.contact_angle)
    ball, pitch = (1e3 * size for size in (found.element_diameter, found.pitch_diameter))
    size = f"{found.elements} elements of {ball:.4g} mm on {pitch:.4g} mm"
    return orders, f"{size}, {found.source or 'estimated from the load ratings of ' + found.designation}"


def _orders(elements: int, diameter: float, pitch: float, angle: float) -> dict[str, float]:
    """Events per revolution of the inner ring by part."""
    rates = bearing_frequencies(
        elements=elements,
        element_diameter=diameter,
        pitch_diameter=pitch,
        contact_angle=angle,
        speed_inner=math.tau,
    )
    orders = {part: float(getattr(rates, key)) for part, key in BEARING_PARTS.items()}
    return {part: order for part, order in orders.items() if order > 0.0}
