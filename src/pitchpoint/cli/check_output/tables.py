# SPDX-License-Identifier: Apache-2.0
"""Tables of `pitchpoint check`: power flow, bodies, joints, meshes, bearings, signals, defaults."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.cli.output import show, show_tables, shown, table
from pitchpoint.model.sections import GROUPS
from pitchpoint.model.signals import SECTIONS as SIGNALS

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

DETAILED = (
    *("gears", "bevel_gears", "bodies", "shafts", "elastic_bodies", "joints", "rods", "ratios", "meshes"),
    *("bevel_meshes", "planetary_stages", "scissor_gears", "bearings", "couplings", "loads", "load_cases"),
    *("scenarios", *SIGNALS),
)
"""Sections that are not shown by the names of their components alone."""
FORCES = tuple(section for section in GROUPS if section not in DETAILED)


def _modes(found: Mapping[str, Any]) -> str:
    """Elastic bodies, whose number of modes is known only after compilation."""
    return f" without the modes of {', '.join(found['elastic_bodies'])}" if found["elastic_bodies"] else ""


def _show_joints(found: Mapping[str, Any]) -> None:
    """Print tree, loops and number of degrees of freedom."""
    rows = [
        [
            name,
            joint["type"],
            " - ".join(joint["bodies"]),
            f"carries {joint['carries']} on {joint['on']}" + (" (reversed)" if joint["turned_round"] else "")
            if joint["carries"]
            else f"closes a loop: {joint['constraints']} constraints",
            ", ".join(c.rsplit(".", 1)[1] for c in joint["coordinates"]),
        ]
        for name, joint in found["joints"].items()
    ]
    if rows:
        table("Joints", ["joint", "type", "bodies", "in the tree", "coordinates"], rows)
    for group in ("rods", "ratios"):
        if found[group]:
            show(f"{group}: {', '.join(found[group])}")
    count = found["mobility"]
    if count["constraints"]:
        show(
            f"{count['coordinates']} coordinates{_modes(found)} - {count['constraints']} constraints = "
            f"{count['by_count']} degrees of freedom by count; more with redundant constraints, which "
            "are detected at assembly"
        )


def _direction(axis: list[float]) -> str:
    """Direction in words: an axis of the world, or its components.

    Examples
    --------
    >>> _direction([0.0, 0.0, 1.0]), _direction([-1.0, 0.0, 0.0]), _direction([0.99619, 0.0, 0.08716])
    ('z', '-x', '0.99619, 0, 0.08716')
    """
    k = max(range(3), key=lambda i: abs(axis[i]))
    if abs(axis[k]) > 1.0 - 1e-12:
        return ("-" if axis[k] < 0.0 else "") + "xyz"[k]
    return ", ".join(f"{round(c, 6) + 0.0:.6g}" for c in axis)


def show_check(model: Model, file: str, found: Mapping[str, Any], warnings: int, drawing: str | None) -> None:
    """Print the data as tables, after the number of warnings.

    Parameters
    ----------
    model, file
        The model and its file.
    found
        Data of the command, as for `--json`.
    warnings
        Number of warnings.
    drawing
        File of the drawing, if there is one.
    """
    from pitchpoint.cli.check_output.balance import show_balance
    from pitchpoint.cli.check_output.gearbox import show_gearbox
    from pitchpoint.cli.check_output.power_flow import show_power_flows
    from pitchpoint.cli.mass import show_masses, show_shaft_masses
    from pitchpoint.report.machine_tables import bearing_table, rim_table, scissor_table, stage_tables
    from pitchpoint.report.parameters import HEAD, parameter_lines

    passed = f"no errors, {warnings} warning{'s' * (warnings > 1)}" if warnings else "no problems"
    show(f"{file}: {passed}" + (f" – {model.title}" if model.title else ""))
    if found["included"]:
        show(f"included files: {', '.join(found['included'])}")
    show_power_flows(found["power_flow"])
    if drawing is not None:
        show(f"drawing of the gearbox in section: {drawing}")
    elif any(body["gears"] for body in found["bodies"].values()):
        show(f"gearbox in section: pitchpoint check {file} --drawing gearbox.svg")
    if model.parameters:
        table("Parameters", HEAD, parameter_lines(model))
    _show_bodies(found)
    show_shaft_masses(found["shaft_masses"])
    if found["masses"]:
        show_masses("Masses from several sources", found["masses"])
    for name, frequencies in found["elastic_frequencies"].items():
        listed = ", ".join(f"{f:.4g}" for f in frequencies)
        show(f"{name}, unsupported: {len(frequencies)} natural frequencies, {listed} Hz")
    show_tables(rim_table(found["flexible_rims"]))
    rows = [
        [name, f"{round(1e3 * station['place'], 9):.6g}", ", ".join(station["there"])]
        for stations in found["shafts"].values()
        for name, station in stations.items()
    ]
    if rows:
        table("Stations of shafts", ["station", "position [mm]", "attached"], rows)
    rows = [
        [
            name,
            f"{round(1e3 * station['place'], 9):.6g}",
            ", ".join(f"{round(1e3 * x, 9) + 0.0:.6g}" for x in station["world"] or ()),
            ", ".join(station["there"]),
        ]
        for stations in found["beam_stations"].values()
        for name, station in stations.items()
    ]
    if rows:
        table("Stations of beams", ["station", "from first end [mm]", "in the world [mm]", "attached"], rows)
    _show_joints(found)
    _show_meshes(found)
    show_tables(*stage_tables(found["planetary_stages"]), scissor_table(found["scissor_gears"]))
    show_gearbox(found)
    for group in ("bearings", "couplings", *FORCES, *model.others, "loads"):
        if found[group] and group != "rolling_bearings":
            show(f"{group}: {', '.join(found[group])}")
    if found["balance"]:
        show_balance(found["balance"])
    bearings = bearing_table(model)
    show_tables(replace(bearings, notes=()))
    for note in bearings.notes:
        show(note)
    if found["signals"]:
        table("Signals", list(found["signals"][0]), [list(line.values()) for line in found["signals"]])
    if found["scenarios"]:
        show("scenarios: " + ", ".join(f"{name} ({kind})" for name, kind in found["scenarios"].items()))
    _show_defaults(found["defaults"])


def _show_defaults(defaults: Sequence[Mapping[str, str]]) -> None:
    """Print the defaults in effect, one row per component."""
    rows: dict[str, list[str]] = {}
    for entry in defaults:
        parts = entry["key"].split(".", 2)
        owner, key = (".".join(parts[:2]), parts[2]) if len(parts) > 2 else (parts[0], ".".join(parts[1:]))
        rows.setdefault(owner, []).append(f"{key}: {entry['value']}")
    if rows:
        lines = [[owner, "; ".join(words)] for owner, words in rows.items()]
        table("Defaults in effect", ["component", "keys that the file omits"], lines)


def _show_bodies(found: Mapping[str, Any]) -> None:
    upright = all(body["axis"] == [0.0, 0.0, 1.0] for body in found["bodies"].values())
    rows = [
        [
            name,
            ", ".join(body["gears"]),
            *([] if upright else [_direction(body["axis"])]),
            ", ".join(body["degrees_of_freedom"]) or "fixed",
            ", ".join(f"{round(1e3 * c, 9) + 0.0:.6g}" for c in body["origin"]) if body["origin"] else "",
            shown(body["mass"], "mass", 5),
            shown(body["polar_inertia"], "inertia", 5) if name not in found["elastic_bodies"] else "",
        ]
        for name, body in found["bodies"].items()
    ]
    if rows:
        n = found["degrees_of_freedom"]
        table(
            f"Bodies: {n} degrees of freedom",
            [
                "body",
                "gears",
                *([] if upright else ["axis"]),
                "moves in",
                "origin [mm]",
                "mass",
                "polar inertia",
            ],
            rows,
        )


def _show_meshes(found: Mapping[str, Any]) -> None:
    rows = [
        [
            name,
            " / ".join(mesh["gears"]),
            shown(mesh["center_distance"], "length"),
            shown(mesh["direction"], "angle"),
            shown(mesh["face_width"], "length"),
            mesh["stiffness"],
        ]
        for name, mesh in found["meshes"].items()
    ]
    if rows:
        table("Meshes", ["mesh", "gears", "centre distance", "direction", "common width", "stiffness"], rows)
    lengths = ("cone_distance", "face_width", "backlash")
    rows = [
        [
            name,
            " / ".join(mesh["gears"]),
            shown(mesh["shaft_angle"], "angle"),
            *(shown(mesh[key], "length") for key in lengths),
            mesh["stiffness"],
        ]
        for name, mesh in found["bevel_meshes"].items()
    ]
    if rows:
        heads = [
            "mesh",
            "gears",
            "shaft angle",
            "mean cone distance",
            "common width",
            "backlash",
            "stiffness",
        ]
        table("Bevel meshes", heads, rows)
