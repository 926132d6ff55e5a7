# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies: representation as bodies with markers at the nodes, and checks."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.checks.references import ends_of
from pitchpoint.model.components.body import Body
from pitchpoint.model.frames import bodies_of, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.shafts import SEATED

if TYPE_CHECKING:
    from pitchpoint.model.components.elastic_body import ElasticBody
    from pitchpoint.model.parts import Parts

AXIAL = (
    *SEATED,
    "loads",
    "unbalances",
    "couplings",
    "torsion_springs",
    "torsion_maxwells",
    "clutches",
)
"""Sections whose elements require the axis of a body."""

MATRICES = ("stiffness_file", "mass_file", "place_file")
"""Files of an elastic body with one matrix each."""
ALL_FILES = ("file", *MATRICES, "spin_stiffness_file")


def stand_in(part: ElasticBody) -> Body:
    """Body that represents an elastic body: free, with markers at its nodes."""
    return Body(motion="free", position=part.position, axes=part.axes, markers=part.nodes, elastic=part)


def add_elastic_bodies(parts: Parts, report: Reader) -> None:
    """Check the elastic bodies and add a body for each of them."""
    group = "elastic_bodies"
    for path in [p for p in report.tainted if p[0] == group]:
        report.tainted.add(("bodies", *path[1:]))
    parts.names["bodies"] = parts.known("bodies") | parts.known(group)
    for name, part in parts.elastic_bodies.items():
        if name in parts.bodies:
            report.problem((group, name), "has the name of a body", remedy="choose a unique name")
            report.tainted.add(("bodies",))
            continue
        if part.static_shapes and part.below is not None:
            report.problem(
                (group, name, "static_shapes"),
                "cannot be combined with below: static shapes require a number of modes",
                remedy="give for example modes: 12 instead of below",
            )
        _files(name, part, report)
        if not part.nodes and (group, name, "nodes") not in report.tainted:
            report.problem(
                (group, name, "nodes"),
                "is empty: the body cannot be supported",
                remedy="name the nodes of joints and forces, such as {eye: {position: [0, 0, 0]}}",
            )
        report.aliases["bodies", name] = (group, name)
        parts.bodies[name] = stand_in(part)


def _files(name: str, part: ElasticBody, report: Reader) -> None:
    """Check that either one archive or the three Matrix Market files are given."""
    at: Place = ("elastic_bodies", name)
    if at in report.tainted or any((*at, k) in report.tainted for k in ("file", *MATRICES)):
        return
    given = [k for k in ALL_FILES[1:] if getattr(part, k) is not None]
    if part.file is not None and given:
        report.problem(
            (*at, given[0]),
            "cannot be combined with file",
            remedy=f"give file alone, or {', '.join(MATRICES)}",
        )
    elif part.file is None and not given:
        report.problem(
            at,
            "has no matrices",
            remedy=f"give file: BODY.npz (or BODY.pch), or {', '.join(MATRICES)}",
        )
    elif given and (missing := [k for k in MATRICES if k not in given]):
        report.problem(
            at,
            f"requires {' and '.join(missing)} in addition to {' and '.join(given)}",
            remedy="give all three",
        )


def check_elastic_bodies(parts: Parts, report: Reader) -> None:
    """Check that elements act on elastic bodies at nodes only."""
    elastic = set(parts.elastic_bodies)
    part_of = parts.elastic_bodies
    if not elastic:
        return
    for group, name, key, given in ends_of(parts):
        for end in (given,) if isinstance(given, str) else given:
            body, node = split(end)
            if body in elastic and not node:
                _refuse(parts, body, (group, name, key), "without a node", "write {}", report)
    for group in AXIAL:
        for name, part in getattr(parts, group).items():
            one = hasattr(part, "body")
            for body in {part.body or ""} if one else {*bodies_of(part.bodies)}:
                if body not in elastic or (group == "loads" and part.marker is not None):
                    continue
                at = (group, name, "body" if one else "bodies")
                remedy = "use a bushing at {}" if group != "loads" else "give marker: NODE and a force"
                what = "which has no axis"
                if part_of[body].rotor:
                    what = "without a node"
                    remedy = "name a body {{mass: 0 kg}} here that a joint of type fixed carries at {}"
                elif group in SEATED:
                    remedy = "name the body that runs in it, and give housing: {}"
                _refuse(parts, body, at, what, remedy, report)
    for name, load in parts.loads.items():
        if load.reaction in elastic:
            _refuse(
                parts,
                str(load.reaction),
                ("loads", name, "reaction"),
                "which has no axis",
                "use two loads",
                report,
            )


def _refuse(parts: Parts, body: str, at: Place, what: str, remedy: str, report: Reader) -> None:
    nodes = " or ".join(f"{body}.{n}" for n in parts.bodies[body].markers) if body in parts.bodies else ""
    report.problem(at, f"names the elastic body {body}, {what}", remedy=remedy.format(nodes))
