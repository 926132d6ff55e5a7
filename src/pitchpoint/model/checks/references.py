# SPDX-License-Identifier: Apache-2.0
"""Checks of references: gears, bodies, markers and meshes exist and are named once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import Any

from pitchpoint.core.errors import UnitError
from pitchpoint.core.nearest import did_you_mean
from pitchpoint.core.units import in_unit, natural_quantity
from pitchpoint.model.checks.beam_ends import check_branches, is_beam, part_of
from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.keys import Place, keys_of
from pitchpoint.model.parts import Parts
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.sections import groups_of


def check_references(parts: Parts, report: Reader) -> None:
    """Check that keys with `names` refer to existing components, each once, and that two gears mesh once."""
    for group in groups_of(parts):
        for name, part in list(getattr(parts, group).items()):
            for key, description in keys_of(type(part)).items():
                if not description.names:
                    continue
                given = getattr(part, key)
                if given is None:
                    continue
                at: Place = (group, name, key)
                words = (given,) if isinstance(given, str) else tuple(given)
                for word in words:
                    known(parts, description.names, word, at, report)
                if len(set(words)) < len(words):
                    what = description.names.replace("_", " ")
                    report.problem(at, f"names {words[0]} twice", remedy=f"name two {what}")
    _same_pairs(parts, report)


def _same_pairs(parts: Parts, report: Reader) -> None:
    """Check that two gears mesh once: a second mesh would double the stiffness."""
    seen: dict[frozenset[str], str] = {}
    for name, mesh in parts.meshes.items():
        first = seen.setdefault(frozenset(mesh.gears), name)
        if first != name:
            report.problem(
                ("meshes", name, "gears"),
                f"are already the gears of {first}",
                value=" and ".join(mesh.gears),
                remedy="remove one of the two meshes",
            )


def known(parts: Parts, group: str, name: str, at: Place, report: Reader, other: str = "") -> bool:
    """Whether a name exists; if not, the problem is reported with the nearest spelling.

    Names of the section `other` are suggested too.
    """
    if parts.has(group, name):
        return True
    names = parts.known(group)
    guess = did_you_mean(name, names | parts.known(other) if other else names)
    body = name.partition(".")[0]
    if group == "bodies" and name == GROUND and at[0] == "couplings":
        guess = "a coupling connects two bodies; use torsion_springs or bushings against ground; "
    elif group == "bodies" and (owner := parts.body_of(name)):
        guess = f"{name} is a gear; name its body, {owner}; "
    elif group == "bodies" and body != name and body in names:
        guess = f"name {body} without the marker, or a body that is fixed there; "
    if group == "bodies":
        names = {n for n in names if n not in parts.bodies or not parts.bodies[n].of_housing}
    words = group.replace("_", " ")
    single = {"bodies": "body", "meshes": "mesh", "clutches": "clutch"}.get(group, words.removesuffix("s"))
    have = f"there are {', '.join(sorted(names))}" if names else f"the file has no {words}"
    report.problem(at, f"names the {single} {name[:40]!r}, which does not exist", remedy=guess + have)
    return False


def carriers_of_gears(parts: Parts, key: str, report: Reader) -> dict[str, str]:
    """Body of every gear under a key of the bodies; a gear on two bodies is a problem."""
    carriers: dict[str, str] = {}
    for name, body in parts.bodies.items():
        for gear in getattr(body, key):
            if gear in carriers:
                report.problem(
                    ("bodies", name, key),
                    f"carries {gear}, which is already on {carriers[gear]}",
                    remedy="keep it on one of the two bodies",
                )
            carriers.setdefault(gear, name)
    return carriers


def check_carriers(parts: Parts, report: Reader) -> None:
    """Check that every gear is on one body and that no mesh connects gears of the same body."""
    carriers = carriers_of_gears(parts, "gears", report)
    complete = set(parts.bodies) == parts.known("bodies") and ("bodies",) not in report.tainted
    for name, mesh in parts.meshes.items():
        bodies = [carriers.get(g) for g in mesh.gears]
        if bodies[0] is not None and bodies[0] == bodies[1] and mesh.gears[0] != mesh.gears[1]:
            report.problem(
                ("meshes", name, "gears"),
                f"connects two gears of the body {bodies[0]}",
                value=" and ".join(mesh.gears),
                remedy="put them on two bodies",
            )
        elif parts.bodies and complete:
            for gear in mesh.gears:
                if gear not in carriers and gear in parts.gears:
                    report.problem(
                        ("gears", gear),
                        f"is in the mesh {name}, but no body carries it",
                        remedy=f"add {gear} to gears of a body",
                    )


# --- points on bodies ---------------------------------------------------------------------------------------
def check_places(parts: Parts, report: Reader) -> None:
    """Check that the ends of elements refer to existing bodies and markers, or to stations of beams."""
    if GROUND in parts.known("bodies"):
        report.problem(("bodies", GROUND), "is a reserved name", remedy="rename the body")
    check_branches(parts, report)
    for group, name, key, given in ends_of(parts):
        many = not isinstance(given, str)
        for i, end in enumerate(given if many else (given,)):
            at: Place = (group, name, key, i) if many else (group, name, key)
            known_end(parts, end, at, report)
        if many and len(given) == 2 and len({part_of(parts, e) for e in given}) == 1:
            body = parts.bodies.get(split(given[0])[0])
            if group == "sensors" and body is not None and (body.shaft or body.elastic):
                continue  # measures its deformation
            report.problem(
                (group, name, key),
                f"are on the same body, {part_of(parts, given[0])}",
                value=" and ".join(given),
                remedy="name points on two bodies",
            )


def ends_of(machine: Any) -> Iterator[tuple[str, str, str, Any]]:
    """All ends of components: section, name, key and value."""
    for group in groups_of(machine):
        components: Mapping[str, Any] = getattr(machine, group)
        for name, part in components.items():
            for key, description in keys_of(type(part)).items():
                given = getattr(part, key)
                if description.kind in ("end", "ends") and given is not None:
                    yield group, name, key, given


def known_end(parts: Parts, end: str, at: Place, report: Reader) -> None:
    """Check that the body and the marker of an end exist."""
    body, marker = split(end)
    if body == GROUND:
        if marker:
            report.problem(
                at,
                f"names a marker of ground, {end}",
                remedy="give position, or put the marker on a body with motion: fixed",
            )
        return
    if is_beam(parts, body):
        return  # `check_stations` lists stations with their positions
    if not known(parts, "bodies", body, at, report, "beams") or not marker or body not in parts.bodies:
        return
    markers = parts.bodies[body].markers
    if marker not in markers and ("bodies", body, "markers") not in report.tainted:
        have = f"there are {', '.join(markers)}" if markers else f"{body} has no markers"
        report.problem(
            at,
            f"names the marker {marker[:40]!r}, which {body} does not have",
            remedy=did_you_mean(marker, markers) + have,
        )


def speed_as_written(speed: float, at: Place, report: Reader) -> str:
    """A speed [rad/s] in the unit in which that at a path is written."""
    unit = "rad/s" if any(bare.place == at for bare in report.bare) else "rpm"
    if at in report.sources:
        with suppress(UnitError):  # a formula
            unit = natural_quantity(report.sources[at].data)[1] or "rad/s"
    return f"{in_unit(speed, 'angular_speed', unit):.6g} {unit}"
