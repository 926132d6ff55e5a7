# SPDX-License-Identifier: Apache-2.0
"""Display of SI channels: unit, factor, axis title."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.units import display_unit, in_unit

Array = NDArray[np.float64]

# SI unit of a channel -> kind of quantity in `core.units`. For ambiguous units (N/m) the kind that occurs in
# time results. Units that are not listed are displayed unchanged.
_KINDS = {
    "m": "length",
    "N": "force",
    "N m": "torque",
    "N/m": "stiffness",
    "N/m^2": "stiffness_per_width",
    "Pa": "pressure",
    "W": "power",
    "J": "energy",
    "s": "time",
    "Hz": "frequency",
    "rad/s": "angular_speed",
    "m/s": "speed",
    "kg": "mass",
}
_SPELLINGS = {"N*m": "N m", "Nm": "N m", "N·m": "N m", "N/m²": "N/m^2", "1": "", "-": "", "dimensionless": ""}


@dataclass(frozen=True)
class Scale:
    """Display unit of an axis and the factor from SI values."""

    unit: str
    factor: float

    def title(self, name: str) -> str:
        """Axis title with the unit in brackets."""
        return f"{name} [{self.unit}]" if self.unit else name

    def text(self, value: float, digits: int = 4) -> str:
        """An SI value in this unit."""
        return f"{number(value * self.factor, digits)} {self.unit}".rstrip()


# Angles of channels are small tilts of shafts; angles of gears are given in degrees elsewhere.
_TILTS = ((0.1, Scale("rad", 1.0)), (1e-3, Scale("mrad", 1e3)), (0.0, Scale("µrad", 1e6)))


@dataclass(frozen=True)
class Channel:
    """One variable of a result: name, values in SI (n,), SI unit, description.

    `statistics` are those of all steps of a run (mean, rms of the alternating part, min, max): samples
    synchronous with the mesh would miss extremes between them. `contact`: numbers of the impacts of a mesh at
    all steps, of a contact state only.
    """

    name: str
    values: Array
    unit: str = ""
    long_name: str = ""
    symbol: str = ""
    statistics: Mapping[str, float] | None = None
    contact: Mapping[str, float] | None = None

    @property
    def label(self) -> str:
        """Readable name with the element.

        Examples
        --------
        >>> Channel("mesh_force[stage]", np.zeros(1), "N", "mesh force").label
        'mesh force, stage'
        """
        return channel_label(self.name)

    @property
    def words(self) -> str:
        """Short name for axes, `mesh force`; the long name is a caption."""
        return self.quantity.replace("_", " ")

    @property
    def quantity(self) -> str:
        """Name without the element: `mesh_force` of `mesh_force[stage]`."""
        return self.name.partition("[")[0]


_VECTORS = (
    "displacement",
    "bearing_force",
    "coupling_force",
    "bushing_force",
    "beam_force",
    "reaction_force",
)
_COMPONENTS = {
    "radial": "radial {0}",
    "axial": "axial {0}",
    "direction": "direction of the radial {0}",
    **{c: f"{{0}} {c}" for c in "xyz"},
    **{f"f{c}": f"{{0}} {c}" for c in "xyz"},
    **{f"m{c}": f"{{1}} moment {c}" for c in "xyz"},
    **{f"r{c}": f"tilt about {c}" for c in "xy"},
    "rz": "rotation about z",
}
"""Names of components in words: {0} the quantity, {1} its element, "bearing" of "bearing force"."""


def channel_label(name: str) -> str:
    """Readable name of a channel: quantity in words, element as named in the model.

    Examples
    --------
    >>> channel_label("mesh_force[stage_1]"), channel_label("power_balance")
    ('mesh force, stage_1', 'power balance')
    >>> channel_label("bearing_force[left.radial]"), channel_label("displacement[rotor.2.rx]")
    ('radial bearing force, left', 'tilt about x, rotor.2')
    """
    quantity, _, owner = name.partition("[")
    words, owner = quantity.replace("_", " "), owner.rstrip("]")
    place, _, component = owner.rpartition(".")
    if place and quantity in _VECTORS and component in _COMPONENTS:
        words, owner = _COMPONENTS[component].format(words, words.rpartition(" ")[0]).strip(), place
    return f"{words}, {owner}" if owner else words


def scale(unit: str, values: Iterable[float] | Array = ()) -> Scale:
    """Display unit for SI values of this size.

    Examples
    --------
    >>> scale("m", [2e-6, 5e-6])
    Scale(unit='µm', factor=1000000.0)
    >>> scale("rad/s").unit, scale("kg m^2"), scale("rad", [2e-5]).unit
    ('rpm', Scale(unit='kg m²', factor=1.0), 'µrad')
    """
    plain = _SPELLINGS.get(unit, unit)
    kind = _KINDS.get(plain)
    if kind is None and plain != "rad":
        return Scale(pretty(plain), 1.0)
    data = np.abs(
        np.asarray(list(values) if not isinstance(values, np.ndarray) else values, dtype=np.float64)
    )
    data = data[np.isfinite(data)]
    largest = float(data.max()) if data.size else 0.0
    if kind is None:
        return next(s for least, s in _TILTS if largest >= least)
    shown = display_unit(kind, largest) if largest > 0.0 else display_unit(kind)
    return Scale(pretty(shown), in_unit(1.0, kind, shown))


def channel_scale(name: str, unit: str, values: Array) -> Scale:
    """Display unit of a channel: µm and µrad for transmission errors and deflections of meshes up to 10 mm.

    Displacements below 1 mm are in µm as well.

    Parameters
    ----------
    name
        Name of the channel with its element.
    unit
        SI.
    values
        Values of the channel, in SI.

    Examples
    --------
    >>> [channel_scale(f"{q}[stage]", "m", np.array([2e-4])).unit for q in ("transmission_error", "travel")]
    ['µm', 'mm']
    """
    small = {"m": Scale("µm", 1e6), "rad": Scale("µrad", 1e6)}.get(_SPELLINGS.get(unit, unit))
    quantity = name.partition("[")[0]
    limits = {"displacement": 1e-3} if unit == "m" else {}
    limit = 1e-2 if quantity.endswith(("transmission_error", "deflection")) else limits.get(quantity, 0.0)
    sizes = np.abs(values[np.isfinite(values)])
    if small is not None and limit > 0.0 and (not sizes.size or float(sizes.max()) < limit):
        return small
    return scale(unit, values)


def pretty(unit: str) -> str:
    """Unit with superscript powers, as printed.

    Examples
    --------
    >>> pretty("kg m^2"), pretty("deg")
    ('kg m²', '°')
    """
    return unit.replace("^2", "²").replace("^3", "³").replace("deg", "°")


def printed(text: str) -> str:
    """Text with the units of model files as printed.

    Examples
    --------
    >>> printed("0.02 kg m^2 at 20 deg, 5 um per 10 mm^3, x >= -0.5")
    '0.02 kg m² at 20°, 5 µm per 10 mm³, x ≥ −0.5'
    """
    text = re.sub(r"(?<![\w.])-(?=\d)", "−", text.replace(">=", "≥").replace("<=", "≤"))
    powers = re.sub(r"(?<=[a-z])\^([23])\b", lambda found: "²³"[int(found[1]) - 2], text)
    return re.sub(r"(?<=\d)\s?deg\b", "°", re.sub(r"(?<=\d )u(?=[mNs]\b)", "µ", powers))


def number(value: float, digits: int = 5) -> str:
    """Number for tables: significant digits, without exponent for moderate magnitudes.

    Examples
    --------
    >>> number(0.15), number(1746485000.0), number(-17), number(-0.0)
    ('0.15', '1.7465·10⁹', '−17', '0')
    """
    if isinstance(value, int | np.integer) and not isinstance(value, bool):
        return str(value).replace("-", "−")
    if not np.isfinite(value) or value == 0.0:
        return "0" if value == 0.0 else str(value)
    plain = f"{value:.{digits - 1}e}"
    mantissa, _, power = plain.partition("e")
    exponent = int(power)
    if -4 <= exponent < 6:
        text = f"{value:.{max(digits - 1 - exponent, 0)}f}"
        text = text.rstrip("0").rstrip(".") if "." in text else text
    else:
        raised = str(exponent).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        text = f"{mantissa.rstrip('0').rstrip('.') if '.' in mantissa else mantissa}·10{raised}"
    return text.replace("-", "−")


def amount(value: float, unit: str, digits: int = 4) -> str:
    """SI value in a customary unit.

    Examples
    --------
    >>> amount(1.5e-6, "m"), amount(17.0, "1"), amount(3.0, "N^2/Hz")
    ('1.5 µm', '17', '3 N²/Hz')
    """
    return scale(unit, [value]).text(value, digits)


def span(low: float, high: float, unit: str = "Hz") -> str:
    """Range between two SI values in a customary unit.

    Examples
    --------
    >>> span(13.45, 26.9), span(5000.0, 10_000.0)
    ('13.45 to 26.9 Hz', '5 to 10 kHz')
    """
    best = scale(unit, [low, high])
    return f"{number(low * best.factor, 4)} to {number(high * best.factor, 4)} {best.unit}".rstrip()


ROUND_OFF = 1e-7
"""Magnitude of a damping ratio below which it is round-off."""


def damping_words(ratio: float) -> str:
    """Damping ratio in per cent; round-off is zero.

    Examples
    --------
    >>> damping_words(0.0123456), damping_words(-2.21e-17), damping_words(-0.002)
    ('1.23 %', '0 %', '−0.2 %')
    """
    return f"{number(100.0 * ratio if abs(ratio) > ROUND_OFF else 0.0, 3)} %"


def channels(data: Any) -> tuple[Array, dict[str, Channel]]:
    """Time and channels of a time result.

    Parameters
    ----------
    data
        An `xarray.Dataset` with the coordinate `time`, or a mapping of `time` and arrays or
        `Channel`s.

    Returns
    -------
    tuple
        Time [s], shape (n,), and the channels over `time` alone, by name.
    """
    time = np.asarray(getattr(data["time"], "values", data["time"]), dtype=np.float64)
    found: dict[str, Channel] = {}
    names = data.data_vars if hasattr(data, "data_vars") else data
    for name in names:
        entry = data[name]
        if str(name) == "time":
            continue
        if isinstance(entry, Channel):
            found[str(name)] = entry
            continue
        values = np.asarray(getattr(entry, "values", entry))
        if values.shape != time.shape or values.dtype.kind not in "fiub":
            continue
        attrs: Mapping[str, Any] = getattr(entry, "attrs", {})
        found[str(name)] = Channel(
            str(name),
            values.astype(np.float64),
            str(attrs.get("units", "")),
            str(attrs.get("long_name", "")),
            str(attrs.get("symbol", "")),
            stored_statistics(attrs),
            stored_contact(attrs),
        )
    return time, found


def settle_time_of(attrs: Mapping[str, Any]) -> float:
    """Start of the statistics window of a run after its first sample [s]; 0 if it is not known.

    Examples
    --------
    >>> settle_time_of({"options": '{"settle_time": 0.02}'}), settle_time_of({})
    (0.02, 0.0)
    """
    try:
        options = attrs.get("options") or "{}"
        known = json.loads(options) if isinstance(options, str) else options
        value = float(known.get("settle_time") or 0.0)
    except (ValueError, TypeError, AttributeError):  # damaged
        return 0.0
    return value if np.isfinite(value) else 0.0


def window_words(begin: float, end: float) -> str:
    """Window of the statistics of a run in words, for headings and captions.

    Examples
    --------
    >>> window_words(0.02, 0.1)
    'statistics from 20 to 100 ms'
    """
    return f"statistics from {span(begin, end, 's')}"


def stored_statistics(attrs: Mapping[str, Any]) -> dict[str, float] | None:
    """Statistics that a run stored with a channel; None if it has not finished, or if they are damaged.

    Examples
    --------
    >>> stored_statistics({"statistics": [1.0, 0.5, 0.0, 2.0]})
    {'mean': 1.0, 'rms': 0.5, 'min': 0.0, 'max': 2.0}
    >>> stored_statistics({"statistics": "{"})
    """
    numbers = np.asarray(attrs.get("statistics"))
    if numbers.shape != (4,) or numbers.dtype.kind not in "fiu" or not np.all(np.isfinite(numbers)):
        return None
    return dict(zip(("mean", "rms", "min", "max"), map(float, numbers), strict=True))


IMPACTS = (
    *("contact_loss_share", "back_contact_share", "front_impacts", "back_impacts"),
    *("closing_speed_max", "impulse_max", "rattle_index"),
)
"""Contact numbers of a mesh that are shown."""
LOADS = ("load_reversal", "impact_energy_per_revolution")
"""Further ones, which files of earlier versions do not have."""


def stored_contact(attrs: Mapping[str, Any]) -> dict[str, float] | None:
    """Contact numbers that a run stored with a contact state; None if there are none.

    Examples
    --------
    >>> stored_contact({"units": "1"})
    >>> stored_contact(dict.fromkeys(IMPACTS, 0.5))["closing_speed_max"]
    0.5
    """
    if not all(isinstance(attrs.get(name), int | float | np.number) for name in IMPACTS):
        return None
    found = {name: float(attrs.get(name, np.nan)) for name in (*IMPACTS, *LOADS)}
    return found if np.isfinite(found["contact_loss_share"]) else None
