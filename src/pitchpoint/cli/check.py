# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint check`: report all problems of a file, or its components and defaults."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.check_output.flexible_rims import rims_of_model, ring_modes
from pitchpoint.cli.check_output.stations import beam_stations, shaft_stations
from pitchpoint.cli.check_output.tables import FORCES, show_check
from pitchpoint.cli.options import common, model_file, writes
from pitchpoint.cli.output import emit_json
from pitchpoint.cli.settings import set_option

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

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
@click.option("--scenario", "-s", metavar="NAME", help="Scenario of the power flow; default: all.")
@writes("--drawing", help="Draw the gearbox in section and along its axes (svg, html, png).")
@set_option
@common
def check(
    file: str,
    solve: bool,
    scenario: str | None,
    drawing: str | None,
    as_json: bool,
    allow_code: bool,
    quiet: bool,
) -> int:
    """Check FILE; show its power flow, bodies, meshes, bearings, loads, scenarios and defaults.

    The power flow is that of constant speed without losses, from ratios and balance; nothing is solved.

    If the file has problems, list all of them with line, value, limit and remedy; the exit code is then 2.
    """
    from pitchpoint.cli.check_output.balance import show_balance, solved
    from pitchpoint.cli.check_output.gearbox import without_nodes
    from pitchpoint.cli.failure import FAILED, OK, say
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
    target = None if drawing is None else _target(drawing, file)
    found = {"power_flow": _powers(model, scenario), **summary(model)}
    if target is not None:
        _draw(model, found["power_flow"], target)
    torques = solved(model, quiet=quiet) if solve else {}
    if torques:
        found["balance"]["scenarios"] = torques
    if as_json:
        emit_json({**found, "messages": [message.parts for message in messages]})
    elif not quiet:
        show_check(model, file, without_nodes(found), len(messages), drawing)
    elif torques:
        show_balance(found["balance"])
    return FAILED if any("failure" in each for each in torques.values()) else OK


def _target(drawing: str, file: str) -> Path:
    """File of the drawing, checked before the model is evaluated."""
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.target import OutputError
    from pitchpoint.report.drawing_file import check_drawing

    try:
        return check_drawing(drawing, [file])
    except OutputError:
        raise
    except PitchpointError as error:
        raise click.BadParameter(str(error), param_hint="--drawing") from None


def _draw(model: Model, flows: dict[str, Any], target: Path) -> None:
    """Write the drawing of the gearbox."""
    from pitchpoint.report.drawing_file import write_drawing
    from pitchpoint.report.section.build import gearbox_drawing

    drawn = gearbox_drawing(model, flows)
    if drawn is None:
        raise click.BadParameter("the file has no gears or shafts on bodies to draw", param_hint="--drawing")
    write_drawing(target, drawn)


def _powers(model: Model, scenario: str | None) -> dict[str, Any]:
    """Power flow of one scenario or of all."""
    from pitchpoint.cli.results import known_scenario
    from pitchpoint.report.static_power import static_powers

    return static_powers(model, None if scenario is None else known_scenario(model, scenario))


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
    from pitchpoint.report.scissor_gears import scissors_of_model
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
        )
        + ring_modes(model),
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
        "scissor_gears": scissors_of_model(model),
        "shafts": shaft_stations(model),
        "beam_stations": beam_stations(model),
        **gearbox_facts(model),
        "elastic_bodies": {name: list(part.nodes) for name, part in model.elastic_bodies.items()},
        "elastic_frequencies": {name: found[1].tolist() for name, found in facts.items()},
        "flexible_rims": rims_of_model(model),
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
    more = 6 * sum(len(places) - 1 for places in model.stations.values()) + ring_modes(model)
    return {"coordinates": count + more, "constraints": count - mobility, "by_count": mobility + more}
