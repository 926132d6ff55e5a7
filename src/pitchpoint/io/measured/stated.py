# SPDX-License-Identifier: Apache-2.0
"""Numbers that a measured file states next to its channels: sample rate, speed, fault orders of bearings.

A number is identified by its name, its unit and its plausibility. Names with several meanings, such as `rate`
or `dx`, are used only if nothing else in the file contradicts them; the notes list what was used and what was
not.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field

from pitchpoint.io.measured.units import is_unit, to_si

RATES = frozenset(
    "samplerate samplingrate samprate samplefrequency samplingfrequency samplefreq samplingfreq sampfreq "
    "sampfrequency fs sr srate fsamp fsample fsampling samplespersecond scanrate acquisitionrate abtastrate "
    "abtastfrequenz".split()
)
STEPS = frozenset(
    "dt deltat timestep timeincrement sampleinterval samplinginterval sampleperiod samplingperiod "
    "wfincrement xinc xincr xincrement xdelta deltax abtastzeit".split()
)
"""Names of a sample rate [Hz] and of its inverse [s], in lower case, without spaces and `_`."""
_VAGUE_STEPS = frozenset({"dx", "ts", "raster"})
_X_STEPS = frozenset({"increment", "delta", "step"})
"""Names of a step only in a structure of the abscissa, such as `x_values`."""
_SPEEDS = frozenset(
    "speed shaftspeed rotationalspeed rotationspeed rotatingspeed rotorspeed motorspeed inputspeed "
    "drehzahl".split()
)
_ROTATIONS = frozenset(
    "shaftrate shaftfrequency shaftfreq rotationfrequency rotationalfrequency rotfreq".split()
)
_FAULTS = ("BPFO", "BPFI", "BSF", "FTF")
_LISTED = RATES | STEPS | _VAGUE_STEPS | _SPEEDS | _ROTATIONS | {"rate", *(f.lower() for f in _FAULTS)}
_ENDINGS = {"hz": "Hz", "khz": "kHz", "rpm": "rpm", "ms": "ms", "us": "us", "s": "s"}
_UNITS = {
    "samples/s": "Hz", "samples/sec": "Hz", "samples per second": "Hz", "sa/s": "Hz", "s/s": "Hz",
    "sps": "Hz", "sec": "s", "seconds": "s", "1/min": "rpm", "r/min": "rpm", "u/min": "rpm", "min-1": "rpm",
}  # fmt: skip
_TEXT = re.compile(r"\s*([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*\[?(.*?)\]?\s*")
_FAMILY = re.compile(r"^([A-Za-z]+_?\d+)(?=_|[A-Z])(.+)$")
SLOWEST, FASTEST = 1e-2, 1e9
"""Limits of a plausible sample rate [Hz]."""
_VAGUE = (1.0, 1e8)
_TOP_SPEED = 4e3
"""Upper limit of a plausible rotation frequency [Hz]."""
AGREE = 1e-3
"""Relative difference of two statements of one sample rate: an increment may have four digits."""
SAME_SPEED = 0.02
"""Relative difference of two statements of one speed."""
_SHOWN = 4


@dataclass(frozen=True)
class Stated:
    """One number of a file.

    Attributes
    ----------
    name
        As in the file.
    value
        Frequency [Hz]: a sample rate, the inverse of an increment, or a rotation frequency.
    shown
        Value as in the file, with its unit.
    """

    name: str
    value: float
    shown: str


@dataclass(frozen=True)
class Given:
    """Statements of a file on some of its channels.

    Attributes
    ----------
    rates
        Sample rates [Hz]; they may contradict each other.
    speed
        Rotation frequency of a shaft [Hz], or None.
    fault_orders
        Orders of the fault frequencies of a bearing [-] by BPFO, BPFI, BSF, FTF.
    notes
        What was used, and what was not.
    """

    rates: tuple[Stated, ...] = ()
    speed: Stated | None = None
    fault_orders: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Number:
    name: str
    key: str
    value: float
    unit: str


class Statements:
    """Collects the numbers and texts of one file.

    Examples
    --------
    >>> found = Statements()
    >>> found.number("bearing.sr", 97656.0), found.number("bearing.rate", 25.0), found.number("load", 270.0)
    (True, True, False)
    >>> given = found.on(["bearing.gs"], ["bearing.gs"])
    >>> given.rates[0].value, given.speed.value, given.notes
    (97656.0, 25.0, ('speed 25 Hz from bearing.rate',))
    """

    def __init__(self) -> None:
        self._numbers: list[_Number] = []
        self._texts: dict[str, str] = {}

    def number(self, name: str, value: float, unit: str = "") -> bool:
        """Add a number; returns whether it is identified by its name."""
        key, ending = _key(name)
        if not _is_known(key, name):
            return False
        self._numbers.append(_Number(name, key, value, _UNITS.get(unit.strip().lower(), unit) or ending))
        return True

    def text(self, name: str, text: str) -> bool:
        """Add a text; returns whether it is a number identified by its name, such as `12.8 kHz`."""
        self._texts[name] = text.strip()
        found = _TEXT.fullmatch(text)
        return found is not None and self.number(name, float(found[1].replace(",", ".")), found[2])

    def on(self, channels: Sequence[str], arrays: Sequence[str], axis: float | None = None) -> Given:
        """Statements on some channels.

        Parameters
        ----------
        channels
            Chosen channels.
        arrays
            All channels of the file. A statement applies to the arrays in its own structure or group.
        axis
            Sample rate of the time axis [Hz], if the file has one.
        """
        near = [_segments(name) for name in channels]
        around = {prefix for parts in near for prefix in _prefixes(parts)}
        every = {prefix for name in arrays for prefix in _prefixes(_segments(name))}
        own = [n for n in self._numbers if _applies(n.name, around, every)]
        notes: list[str] = []
        rates = [one for n in own if (one := self._rate(n, notes))]
        known = axis or (rates[0].value if rates else None)
        speeds = [one for n in own if (one := _speed(n, notes))]
        for n in own:
            self._vague(n, known, rates, speeds, notes)
        nearest = sorted(_nearest(rates, near), key=lambda r: not r.shown.endswith("Hz"))
        used = {r.value for r in nearest}
        far = [f"{r.name} ({r.shown})" for r in rates if not any(abs(r.value - u) <= AGREE * u for u in used)]
        if far:
            notes.append(f"sample rate from {nearest[0].name}, not from {', '.join(far[:_SHOWN])}")
        speed = _one_speed(_nearest(speeds, near), notes)
        orders = _fault_orders(own, speed, notes)
        return Given(tuple(nearest), speed, orders, tuple(notes))

    def _rate(self, number: _Number, notes: list[str]) -> Stated | None:
        """Sample rate with an unambiguous name; its value may be impossible."""
        if number.key in RATES:
            return _hertz(number, number.unit or "Hz", notes, ("Hz", "1/s"))
        inside = number.key in _X_STEPS and _x_owner(number.name)
        return self._step(number, notes) if number.key in STEPS or inside else None

    def _step(self, number: _Number, notes: list[str]) -> Stated | None:
        """Inverse of an increment, if it is one over time."""
        return _hertz(number, number.unit or self._x_unit(number.name) or "s", notes, ("s",))

    def _x_unit(self, name: str) -> str:
        """Unit of the abscissa next to an increment; empty if not stated."""
        owner = _owner(name)
        inside = _x_owner(name)
        for other, text in self._texts.items():
            key, place = _key(other)[0], _owner(other)
            about_x = key in ("xunit", "xunits") and place == owner
            own = inside and key in ("unit", "units", "label") and place.startswith(owner)
            if (about_x or own) and text and is_unit(text):
                return text
        return ""

    def _vague(
        self,
        number: _Number,
        known: float | None,
        rates: list[Stated],
        speeds: list[Stated],
        notes: list[str],
    ) -> None:
        """Use a number with several meanings, if one of them fits the rest of the file."""
        if number.key in _VAGUE_STEPS:
            found = self._step(number, [])
            if found is None:
                return
            low, high = _VAGUE
            fits = abs(found.value / known - 1.0) <= AGREE if known else low <= found.value <= high
            if fits:
                rates.append(found)
            elif known:
                notes.append(f"{number.name} = {number.value:g} is not the sampling interval: not used")
            return
        if number.key != "rate":
            return
        value = number.value * (1e3 if number.unit == "kHz" else 1.0)
        shown = Stated(number.name, value, f"{value:g} Hz")
        if known and abs(value / known - 1.0) <= AGREE or not known and value >= 1000.0:
            rates.append(shown)
        elif known and 0.0 < value <= min(known / 20.0, 1000.0):
            speeds.append(shown)
        else:
            notes.append(f"{number.name} = {number.value:g} may be a sample rate or a speed: not used")


def is_rate(name: str) -> bool:
    """Whether a name can only be that of a sample rate or of its inverse.

    Examples
    --------
    >>> [is_rate(name) for name in ("Sampling rate", "Header.XInc", "fs_kHz", "rate", "speed")]
    [True, True, True, False, False]
    """
    return _key(name)[0] in RATES | STEPS


def _key(name: str) -> tuple[str, str]:
    """Last part of a name in lower case without separators, and the unit at its end."""
    last = re.sub(r"\[\d+\]$", "", re.split(r"[./]", name.strip())[-1])
    key = re.sub(r"[\s_\-]+", "", last.lower())
    if key not in _LISTED:
        for ending, unit in _ENDINGS.items():
            if key.endswith(ending) and key.removesuffix(ending) in _LISTED:
                return key.removesuffix(ending), unit
    return key, ""


def _fault(key: str) -> str:
    """Fault frequency in a name, as in `bpfo`, `bpfo_order`, `fault_bpfo`; empty if none."""
    found = re.fullmatch(r"(?:fault|order|freq|bearing)*(bpfo|bpfi|bsf|ftf)(orders?|freq|frequency|hz)?", key)
    return found[1].upper() if found else ""


def _is_known(key: str, name: str) -> bool:
    named = key in _LISTED or key.endswith("rpm") or bool(_fault(key))
    return named or (key in _X_STEPS and _x_owner(name))


def _owner(name: str) -> str:
    """Structure or group that contains a number."""
    return name[: max(name.rfind("."), name.rfind("/"), 0)]


def _x_owner(name: str) -> bool:
    last = re.split(r"[./]", _owner(name).lower())[-1]
    return bool(re.fullmatch(r"x(_?(values?|axis|data))?(\[\d+\])?", last))


def family_of(name: str) -> str:
    """Common prefix of the names of one record, such as X097 of X097_DE_time; empty if there is none."""
    found = _FAMILY.match(re.split(r"[./]", name)[-1])
    return found[1] if found else ""


def _segments(name: str) -> list[str]:
    """Parts of a name; the common prefix of numbered names counts as a structure.

    Examples
    --------
    >>> _segments("rig.X097_DE_time"), _segments("Channel_1_Header.fs"), _segments("x_2")
    (['rig', 'X097', '_DE_time'], ['Channel_1', '_Header', 'fs'], ['x_2'])
    """
    found: list[str] = []
    for part in re.split(r"[./]", name):
        family = _FAMILY.match(part)
        found += [family[1], family[2]] if family else [part]
    return found


def _prefixes(parts: Sequence[str]) -> list[tuple[str, ...]]:
    """All structures around a part of a file, from the whole file on."""
    return [tuple(parts[:k]) for k in range(len(parts) + 1)]


def _applies(name: str, around: Set[tuple[str, ...]], every: Set[tuple[str, ...]]) -> bool:
    """Whether the smallest structure of a statement with any array also contains a chosen channel."""
    owners = _prefixes(_segments(name)[:-1])
    return next((owner in around for owner in reversed(owners) if owner in every), False)


def _nearest(stated: Sequence[Stated], channels: Sequence[Sequence[str]]) -> list[Stated]:
    """Statements nearest to each channel."""
    inside: dict[tuple[str, ...], list[Stated]] = {}
    for one in stated:
        for owner in _prefixes(_segments(one.name)[:-1]):
            inside.setdefault(owner, []).append(one)
    owners = [next((p for p in reversed(_prefixes(c)) if p in inside), ()) for c in channels]
    return list(dict.fromkeys(one for owner in dict.fromkeys(owners) for one in inside.get(owner, ())))


def _hertz(number: _Number, unit: str, notes: list[str], dimension: Sequence[str]) -> Stated | None:
    """Rate [Hz] of a frequency or of an interval; None for units of another dimension."""
    si, factor, known = to_si(_UNITS.get(unit.strip().lower(), unit))
    shown = f"{number.value:g} {unit}"
    if not known or si not in dimension:
        notes.append(f"{number.name} = {shown} is not in {dimension[0]}: not used")
        return None
    value = number.value * factor
    return Stated(number.name, value if si != "s" else 1.0 / value if value else 0.0, shown)


def _speed(number: _Number, notes: list[str]) -> Stated | None:
    """Rotation frequency of a shaft [Hz]."""
    rpm = number.key.endswith("rpm")
    if not (rpm or number.key in _SPEEDS or number.key in _ROTATIONS):
        return None
    unit = number.unit or ("rpm" if rpm else "Hz" if number.key in _ROTATIONS else "")
    if not unit:
        notes.append(f"{number.name} = {number.value:g} is a speed without unit: not used")
        return None
    si, factor, known = to_si(unit)
    value = number.value * factor / (6.283185307179586 if si == "rad/s" else 1.0)
    if not known or si not in ("rad/s", "Hz", "1/s") or not 0.0 < value <= _TOP_SPEED:
        notes.append(f"{number.name} = {number.value:g} {unit} is not a speed of a shaft: not used")
        return None
    return Stated(number.name, value, f"{number.value:g} {unit}")


def _one_speed(speeds: Sequence[Stated], notes: list[str]) -> Stated | None:
    """The speed, if the file states one."""
    if not speeds:
        return None
    listed = ", ".join(f"{s.shown} from {s.name}" for s in speeds[:_SHOWN])
    if max(s.value for s in speeds) > (1.0 + SAME_SPEED) * min(s.value for s in speeds):
        notes.append(f"speeds differ, none is used: {listed}")
        return None
    notes.append(f"speed {listed}")
    return speeds[0]


def _fault_orders(numbers: Sequence[_Number], speed: Stated | None, notes: list[str]) -> dict[str, float]:
    """Orders of the fault frequencies of a bearing, given as orders or in Hz.

    With an outer ring at rest BPFO + BPFI is the speed times the number of rolling elements, an integer.
    """
    found = {fault: n for n in numbers if (fault := _fault(n.key))}
    if not found:
        return {}
    values = {fault: n.value for fault, n in found.items()}
    endings = {n.unit or ("Hz" if n.key.endswith("hz") else "") for n in found.values()}
    hertz = 1.0 if any("order" in n.key for n in found.values()) else 0.0
    if endings == {"Hz"} and speed is not None:
        hertz = speed.value
    elif not hertz and {"BPFO", "BPFI"} <= set(values):
        bases = [1.0] if endings != {"Hz"} else []
        bases += [speed.value] if speed is not None else []
        fits = [base for base in bases if _is_count((values["BPFO"] + values["BPFI"]) / base)]
        hertz = fits[0] if len(fits) == 1 else 0.0
    listed = ", ".join(f"{n.name} {n.value:g}" for n in found.values())
    if not hertz or min(values.values()) <= 0.0:
        notes.append(f"fault frequencies without a definite unit, not used: {listed}")
        return {}
    orders = {fault: values[fault] / hertz for fault in _FAULTS if fault in values}
    words = ", ".join(f"{fault} {order:.4g}" for fault, order in orders.items())
    notes.append(f"fault orders of the bearing from the file: {words}")
    return orders


def _is_count(elements: float) -> bool:
    """Whether this may be a number of rolling elements."""
    return 3.0 <= elements <= 60.0 and abs(elements - round(elements)) <= 0.01
