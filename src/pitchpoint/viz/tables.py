# SPDX-License-Identifier: Apache-2.0
"""Tables of gear, mesh and result data with symbols and units, as HTML."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

from pitchpoint.core.nomenclature import Entry, lookup, table
from pitchpoint.core.units import display_unit, in_unit
from pitchpoint.core.words import ranges
from pitchpoint.viz.quantities import number, pretty, printed

# Rows of the tables in order; symbol, description and unit are those of the nomenclature.
GEAR_ROWS = (
    "z",
    "m_n",
    "m_t",
    "alpha_n",
    "alpha_t",
    "beta",
    "beta_b",
    "x",
    "b",
    "d",
    "d_b",
    "d_a",
    "d_f",
    "d_Fa",
    "tip_chamfer",
    "tip_rounding",
    "d_Ff",
    "s_n",
    "p_t",
    "p_et",
    "mass",
    "polar_inertia",
)
MESH_ROWS = (
    "a_w",
    "a_d",
    "alpha_wt",
    "x_sum",
    "x_sum_given",
    "d_w1",
    "d_w2",
    "d_Nf1",
    "d_Nf2",
    "g_alpha",
    "eps_alpha",
    "eps_beta",
    "eps_gamma",
    "j_bt",
    "j_wt",
    "j_bn",
    "c_1",
    "c_2",
    "zeta_f1",
    "zeta_a1",
    "zeta_f2",
    "zeta_a2",
    "c_prime_law",
    "mean_mesh_stiffness",
    "c_prime",
    "c_gamma_alpha",
    "C_R",
    "C_B",
)
BEVEL_GEAR_ROWS = (
    *(
        "z",
        "m_mn",
        "m_et",
        "alpha_n",
        "beta_m",
        "x_hm",
        "x_sm",
        "b",
        "delta",
        "delta_a",
        "delta_f",
        "delta_b",
    ),
    *("R_e", "R_m", "d_e", "d_m", "d_ae", "t_xo", "h_ae", "h_fe", "s_mn", "z_v", "mass", "polar_inertia"),
)
BEVEL_MESH_ROWS = (
    *("Sigma", "u", "b", "sigma_p", "eps_alpha", "eps_beta", "eps_gamma", "j_mt", "j_mn"),
    *("c_prime_law", "mean_mesh_stiffness", "c_prime", "c_gamma_alpha", "C_B"),
)
MEASURES = (
    ("tip_thickness", "s_an", "length", "mm", "normal tip thickness"),
    ("span_teeth", "k", "dimensionless", "", "number of teeth (internal: spaces) spanned"),
    ("span", "W_k", "length", "mm", "span"),
    ("ball_diameter", "D_M", "length", "mm", "ball diameter, contact at d + 2 x mₙ"),
    ("dimension_over_balls", "M_dK", "length", "mm", "dimension over balls, internal gears: between"),
)
"""Inspection dimensions, not in the nomenclature: identifier, symbol, dimension, unit, description."""
MEASURE_ROWS = tuple(row[0] for row in MEASURES)
MAX_COLUMNS = 6
"""Maximum number of gears or meshes per table; more would not fit on paper and continue in another table."""
MAX_ROWS = 30
"""Rows of statistics shown; further rows are collapsed."""
NO_COEFFICIENT = 1e-5
"""Size of a coefficient, such as a profile shift, that counts as round-off."""
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉ₐₑₕₙₜₓ", "0123456789aehntx")


def quantity_table(rows: Sequence[str], things: Mapping[str, Mapping[str, Any]]) -> str:
    """HTML table with one row per quantity and one column per gear or mesh; empty rows are omitted.

    Rows with one letter (backlash j_bt, j_wt, j_bn) have a common unit, that of their largest value, so that
    rows and columns can be compared.

    Parameters
    ----------
    rows
        Identifiers of the nomenclature, in order.
    things
        SI values by identifier, by the name of the gear or mesh.
    """
    things = _merged(rows, things)
    if len(things) > MAX_COLUMNS:
        names = list(things)
        parts = (names[k : k + MAX_COLUMNS] for k in range(0, len(names), MAX_COLUMNS))
        return "".join(quantity_table(rows, {name: things[name] for name in part}) for part in parts)
    head = "".join(f'<th scope="col" class="num">{escape(name)}</th>' for name in things)
    body = []
    found = {key: [thing.get(key) for thing in things.values()] for key in rows}
    largest: dict[tuple[str, str], float] = {}
    for key, values in found.items():
        sizes = [abs(float(v)) for v in values if isinstance(v, int | float)]
        if sizes:
            group = _group(key)
            largest[group] = max(largest.get(group, 0.0), *sizes)
    for key, values in found.items():
        if not any(isinstance(v, int | float) for v in values):
            continue
        entry = _entry(key)
        kind = entry.dimension or "dimensionless"
        unit = entry.display if entry.display == "deg" else display_unit(kind, largest[_group(key)])
        words = entry.meaning.partition(";")[0]
        cells = "".join(f'<td class="num">{_cell(v, kind, unit)}</td>' for v in values)
        body.append(
            f'<tr><th scope="row">{escape(words)}</th><td class="sym">{symbol_html(entry.symbol)}</td>'
            f'<td class="unit">{pretty(unit)}</td>{cells}</tr>'
        )
    if not body:
        return ""
    return (
        '<div class="scroll"><table><thead><tr><th scope="col">quantity</th><th scope="col">symbol</th>'
        f'<th scope="col">unit</th>{head}</tr></thead><tbody>{"".join(body)}</tbody></table></div>'
    )


def _merged(rows: Sequence[str], things: Mapping[str, Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    """Columns with equal numbers merged under their names: gears on both sides of a machine, planets."""
    columns: list[list[str]] = []
    for name, thing in things.items():
        equal = (
            names for names in columns if all(_equal(thing.get(k), things[names[0]].get(k)) for k in rows)
        )
        names = next(equal, None)
        if names is None:
            columns.append([name])
        else:
            names.append(name)
    return {common_name(names): things[names[0]] for names in columns}


def _equal(one: Any, other: Any) -> bool:
    """Whether two values are equal as printed: pin errors change a centre distance by less."""
    if isinstance(one, int | float) and isinstance(other, int | float):
        round_off = NO_COEFFICIENT if one * other == 0.0 else 0.0
        return math.isclose(one, other, rel_tol=1e-4, abs_tol=round_off)
    return bool(one == other)


def common_name(names: Sequence[str]) -> str:
    """Names of equal parts in one heading.

    Examples
    --------
    >>> common_name(["Z1", "Z1_right"]), common_name([f"set.planet_{k}" for k in range(1, 6)])
    ('Z1, Z1_right', 'set.planet_1 … set.planet_5')
    """
    return ", ".join(names) if len(names) < 4 else ranges(names)


def plain_table(
    head: Sequence[str],
    body: Sequence[str],
    *,
    numbers: bool = True,
    words: int = 2,
    texts: Sequence[int] = (),
) -> str:
    """HTML table from complete rows; numbers are right-aligned after the first columns with words.

    `texts` are further columns with words.
    """
    right = [numbers and k >= words and k not in texts for k in range(len(head))]
    cells = "".join(
        f'<th scope="col"{" class=num" if is_number else ""}>{escape(text)}</th>'
        for text, is_number in zip(head, right, strict=True)
    )
    rows = "".join(body)
    return f'<div class="scroll"><table><thead><tr>{cells}</tr></thead><tbody>{rows}</tbody></table></div>'


def symbol_html(symbol: str) -> str:
    """Symbol with its subscript.

    Examples
    --------
    >>> symbol_html("d_Nf1"), symbol_html("mₙ"), symbol_html("c′")
    ('d<sub>Nf1</sub>', 'm<sub>n</sub>', 'c′')
    """
    text, index = "", ""
    for letter in symbol.replace("_", "\0"):
        lowered = letter.translate(_LOWERED)
        if letter == "\0" or lowered != letter or (index and letter != " "):
            index += "" if letter == "\0" else lowered
            index = index or "\0"
            continue
        if index:
            text, index = text + f"<sub>{escape(index.strip(chr(0)))}</sub>", ""
        text += escape(letter)
    return text + (f"<sub>{escape(index.strip(chr(0)))}</sub>" if index else "")


def key_html(key: str) -> str:
    """Key of a model file in words, or as a symbol.

    Examples
    --------
    >>> key_html("damping.d_out"), key_html("tip_diameter"), key_html("friction.mu")
    ('damping d<sub>out</sub>', 'tip diameter', 'friction µ')
    """
    return " ".join(_word_html(word) for word in key.split("."))


def value_html(value: str) -> str:
    """Value of a key with printed units; symbols and words as in `key_html`.

    Examples
    --------
    >>> value_html("20 deg"), value_html("generalized_alpha"), value_html("d_in"), value_html("din3990")
    ('20°', 'generalized alpha', 'd<sub>in</sub>', 'DIN 3990')
    """
    return " ".join(_word_html(word) for word in printed(value).split(" "))


def text_html(text: str) -> str:
    """Sentence with symbols of the nomenclature and units as printed.

    Examples
    --------
    >>> text_html("limit about 0.1 m_n, stage_1 >= 2 mm^2"), text_html("K_γ of set")
    ('limit about 0.1 m<sub>n</sub>, stage_1 ≥ 2 mm²', 'K<sub>γ</sub> of set')
    """
    return re.sub(r"\b[A-Za-z]{1,5}_[A-Za-z0-9α-ω]{1,5}\b", _symbol, escape(printed(text)))


def _symbol(found: re.Match[str]) -> str:
    row = table().get(found[0])
    if row is not None and row.symbol:
        return symbol_html(row.symbol)
    # a symbol itself; those of Latin letters could be names of the model
    return found[0] if found[0].isascii() else symbol_html(found[0])


def _word_html(word: str) -> str:
    """Word of a model file: a symbol such as `v_eps` with its subscript, else plain words."""
    if word in _GREEK:
        return _GREEK[word]
    if word in _STANDARDS:
        return _STANDARDS[word]
    if re.fullmatch(r"[A-Za-z]_[A-Za-z0-9]+", word):
        letter, _, index = word.partition("_")
        return symbol_html(f"{letter}_{_GREEK.get(index, index)}")
    return escape(word.replace("_", " "))


_STANDARDS = {"din3990": "DIN 3990"}
_GREEK = {"mu": "µ", "eps": "ε", "alpha": "α", "beta": "β", "zeta": "ζ", "nu": "ν"}


def _group(key: str) -> tuple[str, str]:
    """Key of rows with a common unit: letter and dimension of a quantity."""
    return key.partition("_")[0], _entry(key).dimension or "dimensionless"


def _entry(key: str) -> Entry:
    """Symbol, description and unit of an identifier."""
    for identifier, symbol, dimension, unit, words in MEASURES:
        if identifier == key:
            return Entry(identifier, symbol, "", "", dimension, unit, words, "ISO 21771")
    return lookup(key)


def _cell(value: Any, kind: str, unit: str) -> str:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return "–" if value is None else escape(str(value))
    if isinstance(value, int):
        return number(value)
    if kind == "dimensionless" and abs(value) < NO_COEFFICIENT:
        return "0"
    shown = float(value) if kind == "dimensionless" else in_unit(float(value), kind, unit)
    if kind not in ("length", "angle", "dimensionless") or not 1e-3 <= abs(shown) < 1e5:
        return number(shown, 4)
    # as on drawings: a thousandth of a millimetre or degree; coefficients have one decimal more
    text = f"{shown:.{4 if kind == 'dimensionless' else 3}f}".rstrip("0").rstrip(".")
    return text.replace("-", "−")
