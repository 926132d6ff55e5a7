# SPDX-License-Identifier: Apache-2.0
"""Values of the options --speed and --bearing of `pitchpoint diagnose`."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import Bearing, TurningParts
from pitchpoint.core.errors import UnitError

_BEARING = re.compile(r"([^:@]+):([^@]+)@(.+)")


def option_speed(text: str) -> tuple[str, float]:
    """Shaft (empty if not given) and speed [Hz] of SHAFT=QUANTITY or QUANTITY."""
    from pitchpoint.core.units import parse_quantity

    name, equals, quantity = text.rpartition("=")
    try:
        if re.fullmatch(r"\s*[-+.\deE]+\s*[kM]?Hz\s*", quantity):
            value = parse_quantity(quantity, "frequency", positive=True)
        else:
            value = parse_quantity(quantity, "angular_speed", positive=True) / math.tau
    except UnitError as error:
        raise SignalError(f"--speed: {error}") from None
    return (name.strip() if equals else ""), float(value)


def with_bearings(parts: TurningParts, texts: Sequence[str], names: Mapping[str, str]) -> TurningParts:
    """Add the bearings of the options to those of the model; `names` are the shafts by all their names."""
    found = [_bearing(text, parts, names) for text in texts]
    return replace(parts, bearings=(*parts.bearings, *found))


def _bearing(text: str, parts: TurningParts, names: Mapping[str, str]) -> Bearing:
    """Bearing from NAME:elements,d,D,angle@shaft."""
    from pitchpoint.analysis.bearing_frequencies import bearing_frequencies
    from pitchpoint.core.units import parse_quantity
    from pitchpoint.report.machine_parts import BEARING_PARTS

    example = "as in left:8,7.94 mm,33.5 mm,0 deg@2"
    match = _BEARING.fullmatch(text)
    fields = match[2].split(",") if match else []
    if match is None or len(fields) not in (3, 4):
        raise SignalError(f"--bearing: {text!r} is not NAME:elements,d,D,angle@shaft; write it {example}")
    shaft = names.get(match[3].strip())
    if shaft is None:
        raise SignalError(f"--bearing: no shaft {match[3]!r}; there are: {', '.join(names)}")
    try:
        rates = bearing_frequencies(
            elements=int(fields[0]),
            element_diameter=parse_quantity(fields[1].strip(), "length", positive=True),
            pitch_diameter=parse_quantity(fields[2].strip(), "length", positive=True),
            contact_angle=parse_quantity(fields[3].strip(), "angle") if len(fields) == 4 else 0.0,
            speed_inner=math.tau * float(parts.shaft(shaft).order),
        )
    except (ValueError, UnitError) as error:
        raise SignalError(f"--bearing: {text!r}: {error}; write it {example}") from None
    orders = {part: float(getattr(rates, key)) for part, key in BEARING_PARTS.items()}
    return Bearing(match[1].strip(), {part: rate for part, rate in orders.items() if rate > 0.0}, shaft)
