# SPDX-License-Identifier: Apache-2.0
"""Output of `pitchpoint campbell`: critical speeds, what moves them, unstable modes, modes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import NOTHING, show, show_notes, shown, table

if TYPE_CHECKING:
    import xarray as xr

SHOWN = 20
"""Number of critical speeds in the table."""
MOVERS = 3
"""Number of stiffnesses and masses listed for each critical speed."""


def rows_of(data: xr.Dataset) -> list[dict[str, Any]]:
    """Critical speeds of `campbell --json`, in order of rank."""
    from dataclasses import asdict

    from pitchpoint.analysis.campbell_ranking import ranked_speeds

    rows = []
    for row in map(asdict, ranked_speeds(data)):
        row["sidebands"] = None if math.isnan(row["sidebands"][0]) else list(row["sidebands"])
        rows.append(row)
    return rows


def unstable_rows(data: xr.Dataset) -> list[dict[str, Any]]:
    """Unstable modes of `campbell --json`, lowest damping first."""
    from dataclasses import asdict

    from pitchpoint.analysis.campbell_ranking import unstable_ranges

    return [asdict(row) for row in unstable_ranges(data)]


def mode_rows(data: xr.Dataset) -> list[dict[str, Any]]:
    """Modes of `campbell --json`: values at the ends of the speeds, energies at the highest speed."""
    last = data.isel(speed=-1)
    return [
        {
            "mode": int(number),
            "name": str(data["name"].values[k]),
            "frequency": [float(data["frequency"].values[s, k]) for s in (0, -1)],
            "damping_ratio": [float(data["damping_ratio"].values[s, k]) for s in (0, -1)],
            "whirl_index": float(last["whirl_index"].values[k]),
            "strain_share": dict(
                zip(last["component"].values.tolist(), last["strain_share"].values[k].tolist(), strict=True)
            ),
            "kinetic_share": dict(
                zip(
                    last["part"].values.tolist(),
                    last["kinetic_share"].values[k].sum(axis=1).tolist(),
                    strict=True,
                )
            ),
        }
        for k, number in enumerate(data["mode"].values)
    ]


def print_summary(title: str, summary: dict[str, Any], *, quiet: bool) -> None:
    """Print critical speeds and modes."""
    from pitchpoint.analysis.campbell_ranking import NO_CRITICAL_SPEED

    apart = summary["operating_speed"] is not None
    cells = [
        [
            str(rank),
            _rpm(row["speed"]),
            shown(row["frequency"], "frequency", 5),
            f"{100.0 * row['damping_ratio']:.3g} %",
            row["order"],
            row["mode"],
            f"{row['source']} {100.0 * row['participation']:.3g} %",
            _amplification(row),
            f"{row['response']:.4g}",
            *([_separation(row["separation"])] if apart else []),
            NOTHING if row["sidebands"] is None else "–".join(f"{_number(s)}" for s in row["sidebands"]),
        ]
        for rank, row in enumerate(summary["critical_speeds"][:SHOWN], start=1)
    ]
    heads = ["rank", f"speed of {summary['body']}", "frequency", "damping", "order", "mode", "driven by"]
    heads += ["amplification", "response", *(["separation"] if apart else []), "sidebands [rpm]"]
    if cells:
        table(title, heads, cells)
    else:
        show(f"{title}: {NO_CRITICAL_SPEED} in this range of speeds and frequencies")
    _print_unstable(summary)
    if quiet:
        return
    _print_movers(summary)
    more = len(summary["critical_speeds"]) - len(cells)
    show(f"{summary['ranking']}" + (f"; {more} more with --table, --json or -o" if more > 0 else ""))
    low, high = (_rpm(speed) for speed in summary["speeds"])
    rows = [
        [
            str(row["mode"]),
            row["name"],
            *(shown(f, "frequency", 5) for f in row["frequency"]),
            f"{100.0 * row['damping_ratio'][1]:.3g} %",
            largest(row["strain_share"]),
            largest(row["kinetic_share"]),
        ]
        for row in summary["modes"]
        if max(row["frequency"]) > 0.0
    ]
    heads = ["no.", "mode", f"at {low}", f"at {high}", "damping", "strain energy", "kinetic energy"]
    table("Modes", heads, rows, keys=2)
    show(f"damping and energies at {high}")
    show_notes(summary["notes"])
    if summary["output"] is not None:
        show(f"written to {summary['output']}")


def _print_unstable(summary: dict[str, Any]) -> None:
    """Print unstable modes, if there are any."""
    rows = [
        [
            row["mode"],
            f"{_number(row['low'])}–{_rpm(row['high'])}",
            f"{100.0 * row['damping_ratio']:.3g} %",
            row["source"] or NOTHING,
        ]
        for row in summary["unstable_modes"]
    ]
    if rows:
        table("Unstable modes", ["mode", f"speed of {summary['body']}", "lowest damping", "driven by"], rows)


def _print_movers(summary: dict[str, Any]) -> None:
    """Print what moves the critical speeds; those of one mode with the same changes are one row."""
    from pitchpoint.analysis.campbell_ranking import STEP

    ranks: dict[str, list[str]] = {}
    for rank, row in enumerate(summary["critical_speeds"][:SHOWN], start=1):
        if row["moved_by"]:
            ranks.setdefault(movers(row["moved_by"], MOVERS), []).append(str(rank))
    if ranks:
        heads = ["rank", f"change of the critical speed for +{100.0 * STEP:g} % of stiffness or mass"]
        table("Sensitivities", heads, [[", ".join(which), words] for words, which in ranks.items()])


def movers(moved_by: Sequence[Sequence[Any]], count: int) -> str:
    """Largest changes of a critical speed in words, for `STEP` more of a stiffness or mass.

    Examples
    --------
    >>> movers([("mass of rotor", -0.45), ("stiffness of mesh stage", 0.2)], 3)
    'mass of rotor -4.5 %, stiffness of mesh stage +2.0 %'
    """
    from pitchpoint.analysis.campbell_ranking import STEP

    return ", ".join(f"{label} {100.0 * STEP * value:+.1f} %" for label, value in moved_by[:count])


def _amplification(row: dict[str, Any]) -> str:
    """Amplification of a critical speed in words."""
    if math.isfinite(row["amplification"]):
        return f"{row['amplification']:.4g}"
    return "unstable" if row["damping_ratio"] < 0.0 else "∞"


def damping_text(ratio: float, frequency: float) -> str:
    """Damping ratio in per cent; a dash for rigid-body modes.

    Examples
    --------
    >>> damping_text(0.05, 100.0), damping_text(-1e-12, 100.0), damping_text(0.0, 0.0)
    ('5.000 %', '0.000 %', '–')
    >>> damping_text(1.0, 100.0), damping_text(-1.0, 100.0)
    ('overdamped', 'unstable')
    """
    if frequency == 0.0:
        return NOTHING
    if abs(ratio) == 1.0:
        return "overdamped" if ratio > 0.0 else "unstable"
    return f"{round(100.0 * ratio, 3) + 0.0:.3f} %"


def largest(shares: dict[str, float], count: int = 2, least: float = 0.1) -> str:
    """Largest shares of an energy in words.

    Examples
    --------
    >>> largest({"mesh stage": 0.2, "shaft rotor": 0.75, "bearing a": 0.05})
    'shaft rotor 75 %, mesh stage 20 %'
    """
    order = sorted(shares.items(), key=lambda item: -item[1])[:count]
    words = [
        f"{name} {100.0 * share:.0f} %"
        for k, (name, share) in enumerate(order)
        if share >= least or (k == 0 and share > 0.0)
    ]
    return ", ".join(words) or NOTHING


def _number(speed: float) -> str:
    return f"{speed * 30.0 / math.pi:.5g}"


def _rpm(speed: float) -> str:
    return f"{_number(speed)} rpm"


def _separation(share: float) -> str:
    return "in range" if share == 0.0 else f"{round(100.0 * share, 1) + 0.0:+.1f} %"
