# SPDX-License-Identifier: Apache-2.0
"""Checks of the pins of planetary stages on nodes of an elastic carrier, or on markers of another body."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.planetary_stage import PinError
from pitchpoint.model.frames import body_frame, place_of
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stage_members import SECTION

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pitchpoint.model.components.marker import Marker
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.parts import Parts

ASIDE = 0.1
"""Distance of a node from the axis of its pin, in normal modules, above which it is the node of another pin
or its position is wrong; a smaller distance is a rigid arm."""


def check_pin_names(parts: Parts, report: Reader) -> None:
    """Check the nodes that `pins` names, and that the planets of an elastic carrier have some."""
    for name, stage in parts.planetary_stages.items():
        elastic = parts.elastic_bodies.get(stage.carrier)
        at: Place = (SECTION, name, "pins")
        if elastic is None and stage.pins is None:
            continue
        if elastic is not None and not elastic.rotor:
            report.problem(
                (SECTION, name, "carrier"),
                f"names the elastic body {stage.carrier}, which does not count revolutions",
                limit="rotor: true",
                remedy=f"write rotor: true at {stage.carrier}, whose z axis is then the axis of the stage",
            )
        nodes = _nodes(parts, stage.carrier)
        if nodes is None:
            continue  # an unknown carrier, or one that could not be read
        have = f"{stage.carrier} has {', '.join(nodes) or 'none'}"
        if stage.pins is None:
            around = [n for n, node in nodes.items() if np.hypot(*node.position[:2]) > 0.0]
            few = f"[{', '.join(around[: len(stage.names)]) or 'pin_1, pin_2'}]"
            report.problem(
                at,
                f"is missing: planets act on an elastic carrier at its nodes; {have}",
                remedy=f"name the node of each pin, such as pins: {few}",
            )
            continue
        _names(at, stage, stage.pins, nodes, have, report)


def _nodes(parts: Parts, body: str) -> Mapping[str, Marker] | None:
    """Nodes of an elastic body, or markers of a body or shaft; None if it is unknown."""
    if body in parts.elastic_bodies:
        return parts.elastic_bodies[body].nodes
    for section in (parts.bodies, parts.shafts):
        if body in section:
            return section[body].markers
    return None


def _names(
    at: Place,
    stage: PlanetaryStage,
    pins: tuple[str, ...],
    nodes: Mapping[str, Marker],
    have: str,
    report: Reader,
) -> None:
    """Check number and names of the pins."""
    if stage.names and len(pins) != len(stage.names):
        report.problem(
            at,
            f"for {len(stage.names)} planets",
            value=f"{len(pins)} {'node' if len(pins) == 1 else 'nodes'}",
            limit="one for each planet",
            remedy=f"name the nodes of {', '.join(stage.names)} in this order",
        )
        return
    for k, pin in enumerate(pins):
        if pin in pins[:k]:
            report.problem(
                (*at, k),
                f"names {pin} again: two planets cannot be on one pin",
                remedy=f"name the node of {stage.names[k]}; {have}",
            )
        elif pin not in nodes:
            report.problem(
                (*at, k),
                f"names {pin[:40]!r}, which {stage.carrier} does not have",
                remedy=did_you_mean(pin, nodes) + have,
            )


def check_pins(parts: Parts, report: Reader) -> None:
    """Check that every node is on the axis of its pin, within a face width of the planet."""
    for name, stage in parts.planetary_stages.items():
        at: Place = (SECTION, name, "pins")
        if stage.pins is None or (SECTION, name) in report.tainted:
            continue
        aside, along = ASIDE * stage.planet.normal_module, stage.planet.face_width
        for k, (planet, seat) in enumerate(zip(stage.names, stage.seats, strict=True)):
            origin, axes = body_frame(parts, planet)
            node = place_of(parts, seat)
            if origin is None or node is None:
                continue
            arm = axes.T @ (node - origin)
            error = stage.pin_errors.get(planet, PinError())
            size = max(0.0, float(np.hypot(arm[0], arm[1])) - float(np.hypot(error.radial, error.tangential)))
            if size <= aside and abs(arm[2]) <= along:
                continue
            right = body_frame(parts, stage.carrier)
            wanted = right[1].T @ (origin - right[0]) if right[0] is not None else origin
            shown = ", ".join(f"{1e3 * x:.6g}" for x in wanted)
            off = size > aside
            report.problem(
                (*at, k),
                f"is the distance of {seat} from the {'axis' if off else 'middle'} of {planet}",
                value=format_quantity(size if off else abs(float(arm[2])), "length", 4),
                limit=f"{format_quantity(aside, 'length', 3)}, a tenth of a module"
                if off
                else f"{format_quantity(along, 'length', 4)}, the face width",
                remedy=f"name the node of {planet}, or correct its position: [{shown}] mm in the axes of "
                f"{stage.carrier}, without the error of the pin",
                taint=False,
            )
