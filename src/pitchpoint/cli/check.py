# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint check`: report all problems of a file, or its components and defaults."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import common, model_file
from pitchpoint.cli.output import emit_json, show, shown, table
from pitchpoint.cli.settings import set_option
from pitchpoint.cli.stations import beam_stations, shaft_stations
from pitchpoint.model.sections import GROUPS
from pitchpoint.model.signals import SECTIONS as SIGNALS

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

DETAILED = (
    *("gears", "bevel_gears", "bodies", "shafts", "elastic_bodies", "joints", "rods", "ratios", "meshes"),
    *("bevel_meshes", "planetary_stages", "bearings", "couplings", "loads"),
    *("load_cases", "scenarios", *SIGNALS),
)
"""Sections that are not shown by the names of their components alone."""
FORCES = tuple(section for section in GROUPS if section not in DETAILED)
FREEDOMS = {
    "torsion": ("spin",),
    "planar": ("x", "y", "spin"),
    "free": ("x", "y", "z", "rx", "ry", "spin"),
    "fixed": (),
}


@click.command()
@model_file
@click.option(
    "--balance",
    "solve",
    is_flag=True,
    help="Compute the torques of loads with torque: balance for every scenario.",
)
@set_option
@common
def check(file: str, solve: bool, as_json: bool, allow_code: bool, quiet: bool) -> int:
    """Check FILE and list bodies with degrees of freedom and positions, meshes, loads, scenarios, defaults.

    If the file has problems, list all of them with line, value, limit and remedy; the exit code is then 2.
    """
    from pitchpoint.cli.balance import show_balance, solved
    from pitchpoint.cli.failure import FAILED, OK, say
    from pitchpoint.cli.gearbox import without_nodes
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.settings import changes_of, settings_of_command
    from pitchpoint.model.changes import named
    from pitchpoint.model.remarks.collect import odd_shapes, remarks_of, remarks_of_file
    from pitchpoint.report.sampling import coarse_scenarios

    model = read_model(file, allow_code, quiet, remarks=False)
    remarks = (*remarks_of_file(model), *remarks_of(model), *odd_shapes(model), *coarse_scenarios(model))
    settings = dict.fromkeys(changes_of(settings_of_command(), file), "--set")
    messages = named(remarks, settings, model.lines) if settings else remarks
    for message in messages:
        say(f"warning: {message}")
    found = summary(model)
    torques = solved(model, quiet=quiet) if solve else {}
    if torques:
        found["balance"]["scenarios"] = torques
    if as_json:
        emit_json({**found, "messages": [message.parts for message in messages]})
    elif not quiet:
        _print(model, file, without_nodes(found), len(messages))
    elif torques:
        show_balance(found["balance"])
    return FAILED if any("failure" in each for each in torques.values()) else OK


def summary(model: Model) -> dict[str, Any]:
    """Data of the simulated model."""
    from pitchpoint.model.mechanism import seat_frame
    from pitchpoint.model.signals import HEAD, signal_lines
    from pitchpoint.report.balance import balanced_loads
    from pitchpoint.report.bearing_data import bearing_data
    from pitchpoint.report.defaults import defaults
    from pitchpoint.report.housing import gearbox_facts
    from pitchpoint.report.masses import masses, masses_of_shafts, several_sources
    from pitchpoint.report.planets import stages_of_model
    from pitchpoint.system.rules.elastic_body import elastic_facts

    facts = elastic_facts(model) if model.elastic_bodies else {}
    bodies = {}
    for name, body in model.bodies.items():
        inertia = model.body_inertia(name)
        bodies[name] = {
            "gears": [*body.gears, *body.bevel_gears],
            "motion": body.moves,
            "degrees_of_freedom": _freedoms(model, name),
            "origin": body.origin,
            "axis": [float(c) for c in seat_frame(model, model.mechanism.seats[name])[1][:, 2]],
            "mass": inertia.mass,
            "polar_inertia": inertia.polar,
            "transverse_inertia": inertia.transverse,
        }
        if body.elastic is not None:  # defined by its file
            bodies[name] |= dict.fromkeys(("polar_inertia", "transverse_inertia"))
            bodies[name]["mass"] = facts[name][0]
    return {
        "ok": True,
        "title": model.title,
        "parameters": _parameters(model),
        "included": list(model.origin.files),
        "degrees_of_freedom": sum(
            len(_freedoms(model, name)) * len(model.stations.get(name, (0.0,))) for name in model.bodies
        ),
        "gravity": list(model.gravity) if model.gravity is not None else None,
        "gears": list(model.gears),
        "bevel_gears": list(model.bevel_gears),
        "bodies": bodies,
        "masses": several_sources(masses(model)),
        "shaft_masses": masses_of_shafts(model),
        "meshes": {
            name: {
                "gears": list(mesh.gears),
                "center_distance": abs(mesh.a_w) if mesh.a_w is not None else None,
                "direction": mesh.theta,
                "face_width": mesh.b_w,
                "stiffness": mesh.law.law,
            }
            for name, mesh in model.meshes.items()
        },
        "bevel_meshes": {
            name: {
                "gears": list(mesh.gears),
                "shaft_angle": model.bevel_pairs[name].Sigma,
                "cone_distance": model.bevel_pairs[name].R_m,
                "face_width": model.bevel_pairs[name].b,
                "backlash": model.backlash(name),
                "stiffness": mesh.law.law,
            }
            for name, mesh in model.bevel_meshes.items()
        },
        "planetary_stages": stages_of_model(model),
        "shafts": shaft_stations(model),
        "beam_stations": beam_stations(model),
        **gearbox_facts(model),
        "elastic_bodies": {name: list(part.nodes) for name, part in model.elastic_bodies.items()},
        "elastic_frequencies": {name: found[1].tolist() for name, found in facts.items()},
        "joints": _joints(model),
        "rods": list(model.rods),
        "ratios": list(model.ratios),
        "mobility": _mobility(model),
        "bearings": list(model.bearings),
        "bearing_data": bearing_data(model),
        "couplings": list(model.couplings),
        **{group: list(getattr(model, group)) for group in (*FORCES, *model.others)},
        "loads": list(model.loads),
        "balance": balanced_loads(model),
        "signals": [dict(zip(HEAD, line, strict=True)) for line in signal_lines(model)],
        "scenarios": {name: scenario.kind for name, scenario in model.scenarios.items()},
        "defaults": [{"key": key, "value": value} for key, value in defaults(model)],
    }


def _parameters(model: Model) -> dict[str, dict[str, Any]]:
    """Parameters as written, with SI value and unit."""
    from pitchpoint.core.formula.dimension import readable

    return {
        name: {
            "written": part.value,
            "value": model.amounts[name].value,
            "unit": readable(model.amounts[name].unit),
            "text": part.text,
        }
        for name, part in model.parameters.items()
    }


def _freedoms(model: Model, body: str) -> list[str]:
    """Coordinates of a body, in the terms of its motion or joint."""
    seat = model.mechanism.seats[body]
    return list(FREEDOMS[model.bodies[body].moves] if seat.joint is None else seat.coordinates)


def _joints(model: Model) -> dict[str, Any]:
    """Function of every joint: carried and carrying body, or closure of a loop."""
    from pitchpoint.model.mechanism import rows_of

    found = {}
    for name, joint in model.joints.items():
        seat = model.mechanism.carrier(name)
        found[name] = {
            "type": joint.type,
            "bodies": list(joint.bodies),
            "carries": seat.body if seat is not None else None,
            "on": seat.end if seat is not None else None,
            "turned_round": seat is not None and seat.turned,
            "coordinates": [f"{name}.{c}" for c in seat.coordinates] if seat is not None else [],
            "constraints": 0 if seat is not None else rows_of(joint),
        }
    return found


def _mobility(model: Model) -> dict[str, int]:
    """Coordinates of the tree and degrees of freedom by Gruebler's count."""
    from pitchpoint.model.mechanism import freedoms

    contacts = (model.cam_contacts, model.curve_contacts, model.surface_contacts)
    held = sum(c.permanent for group in contacts for c in group.values())
    others = len(model.rods) + len(model.ratios) + held
    count, mobility = freedoms(model.mechanism, model, others)
    more = 6 * sum(len(places) - 1 for places in model.stations.values())
    return {"coordinates": count + more, "constraints": count - mobility, "by_count": mobility + more}


def _modes(found: dict[str, Any]) -> str:
    """Elastic bodies, whose number of modes is known only after compilation."""
    return f" without the modes of {', '.join(found['elastic_bodies'])}" if found["elastic_bodies"] else ""


def _show_joints(found: dict[str, Any]) -> None:
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
            f"{count['by_count']} degrees of freedom by count; redundant constraints, which assembly "
            "detects, leave more"
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


def _print(model: Model, file: str, found: dict[str, Any], warnings: int) -> None:
    """Print the data as tables, after the number of warnings."""
    from pitchpoint.cli.balance import show_balance
    from pitchpoint.cli.gearbox import show_gearbox
    from pitchpoint.cli.mass import show_masses, show_shaft_masses
    from pitchpoint.report.parameters import HEAD, parameter_lines

    passed = f"no errors, {warnings} warning{'s' * (warnings > 1)}" if warnings else "no problems"
    show(f"{file}: {passed}" + (f" – {model.title}" if model.title else ""))
    if found["included"]:
        show(f"included files: {', '.join(found['included'])}")
    if model.parameters:
        table("Parameters", HEAD, parameter_lines(model))
    _show_bodies(found)
    show_shaft_masses(found["shaft_masses"])
    if found["masses"]:
        show_masses("Masses from several sources", found["masses"])
    for name, frequencies in found["elastic_frequencies"].items():
        listed = ", ".join(f"{f:.4g}" for f in frequencies)
        show(f"{name}, unsupported: {len(frequencies)} natural frequencies, {listed} Hz")
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
    if found["planetary_stages"]:
        from pitchpoint.cli.planets import show_stages

        show_stages(found["planetary_stages"])
    show_gearbox(found)
    for group in ("bearings", "couplings", *FORCES, *model.others, "loads"):
        if found[group] and group != "rolling_bearings":
            show(f"{group}: {', '.join(found[group])}")
    if found["balance"]:
        show_balance(found["balance"])
    if model.rolling_bearings:
        _show_bearings(model)
    if found["signals"]:
        table("Signals", list(found["signals"][0]), [list(line.values()) for line in found["signals"]])
    if found["scenarios"]:
        show("scenarios: " + ", ".join(f"{name} ({kind})" for name, kind in found["scenarios"].items()))
    if found["defaults"]:
        rows = [[entry["key"], entry["value"]] for entry in found["defaults"]]
        table("Defaults in effect", ["key", "value"], rows)


def _show_bearings(model: Model) -> None:
    """Print the data of rolling bearings, given or estimated."""
    from pitchpoint.report.bearing_data import HEAD, bearing_lines

    rows, notes = bearing_lines(model)
    table("Rolling bearings", list(HEAD), rows)
    for note in notes:
        show(note)


def _show_bodies(found: dict[str, Any]) -> None:
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
        table(
            f"Bodies: {found['degrees_of_freedom']} degrees of freedom",
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


def _show_meshes(found: dict[str, Any]) -> None:
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
