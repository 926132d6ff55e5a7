# SPDX-License-Identifier: Apache-2.0
"""Table and sentences of the meshes of a speed sweep; equal meshes, as of planets, are combined."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence

from pitchpoint.analysis.mesh_sweep import MeshSweep
from pitchpoint.viz.quantities import amount, number

MAX_MESHES = 10
"""Meshes or groups of equal meshes with own rows."""
MAX_NAMED = 4
"""Meshes or groups of equal meshes with an own sentence, and names in one text."""
RANGE = 4
"""Consecutive numbers from which names are a range."""


def mesh_rows(
    found: Sequence[MeshSweep], cells: Callable[[MeshSweep], Sequence[str]]
) -> tuple[list[list[str]], str]:
    """Rows of name of the meshes and cells, one per direction; note on meshes without rows.

    Meshes with equal cells have common rows. Above `MAX_MESHES`, those with the largest contact loss, then
    with the largest forces have rows, and the swept mesh, which is always the first.

    Parameters
    ----------
    found
        As of `mesh_sweeps`.
    cells
        Cells of one mesh in one direction.
    """
    by_mesh = _by_mesh(found)
    groups: dict[tuple[tuple[str, ...], ...], list[str]] = {}
    for mesh, own in by_mesh.items():
        groups.setdefault(tuple(tuple(cells(one)) for one in own), []).append(mesh)
    first, *others = groups  # the swept mesh first
    ranked = [first, *sorted(others, key=lambda own: _severity(by_mesh[groups[own][0]]))]
    kept = set(ranked[:MAX_MESHES])
    rows = [[mesh_names(meshes), *row] for own, meshes in groups.items() if own in kept for row in own]
    rest = [mesh for own in ranked[MAX_MESHES:] for mesh in groups[own]]
    if not rest:
        return rows, ""
    losses = [one.loss for mesh in rest for one in by_mesh[mesh] if math.isfinite(one.loss)]
    forces = [one.force for mesh in rest for one in by_mesh[mesh] if math.isfinite(one.force)]
    words = [f"contact loss up to {percent(max(losses))}"] if losses else []
    words += [f"forces up to {amount(max(map(abs, forces)), 'N')}"] if forces else []
    return rows, f"{len(rest)} more meshes have {' and '.join(words)}; the result file has all of them."


def contact_sentences(
    found: Sequence[MeshSweep], place: Callable[[float], str] = lambda f: amount(f, "Hz")
) -> list[str]:
    """Sentences on contact loss of the meshes over all points of a sweep; none without contact numbers.

    Parameters
    ----------
    found
        As of `mesh_sweeps`.
    place
        Text of a mesh frequency [Hz] of the swept mesh, or of the speed there.

    Examples
    --------
    >>> from dataclasses import replace
    >>> nan = math.nan
    >>> near = MeshSweep("st1", "up", 40, 0, 1e-6, 50.0, 9.0, 50.0, 0.0, 50.0, 0.0, 0.0, ())
    >>> far = replace(near, mesh="st2", apart=12, loss=0.82, loss_at=4600.0, closing=0.25)
    >>> for sentence in contact_sentences([near, far]):
    ...     print(sentence)
    The flanks of st2 separate at 12 of 40 points, for up to 82 % of the time at 4600 Hz upwards.
    The flanks of st1 stay in contact at every point.
    >>> contact_sentences([near])
    ['The flanks of st1 stay in contact at every point of this sweep.']
    >>> contact_sentences([near, replace(far, apart=0, loss=nan)])[1]
    'This result of an earlier version has no contact numbers of st2; repeat the sweep.'
    """
    by_mesh = _by_mesh(found)
    unknown = [m for m, own in by_mesh.items() if all(math.isnan(one.loss) for one in own)]
    if len(unknown) == len(by_mesh):
        return []
    kept = [m for m, own in by_mesh.items() if m not in unknown and not any(one.apart for one in own)]
    apart = sorted((m for m in by_mesh if m not in (*unknown, *kept)), key=lambda m: _severity(by_mesh[m]))
    texts: dict[str, list[str]] = {}
    for mesh in apart:
        texts.setdefault(_separation(by_mesh[mesh], place), []).append(mesh)
    sentences = [f"The flanks{_of(meshes)} {text}." for text, meshes in list(texts.items())[:MAX_NAMED]]
    more = [mesh for meshes in list(texts.values())[MAX_NAMED:] for mesh in meshes]
    if more:
        who = "one more mesh" if len(more) == 1 else f"{len(more)} more meshes"
        sentences.append(f"Those of {who} separate for shorter times.")
    if kept:
        whole = "" if apart else " of this sweep"
        sentences.append(f"The flanks{_of(kept)} stay in contact at every point{whole}.")
    if unknown:
        sentences.append(
            f"This result of an earlier version has no contact numbers{_of(unknown)}; repeat the sweep."
        )
    return sentences


def mesh_names(meshes: Sequence[str]) -> str:
    """Names of several meshes in one text; consecutive numbers, as of planets, as a range.

    Examples
    --------
    >>> mesh_names([f"sun-planet_{k}" for k in range(1, 6)] + ["planet_1-ring", "planet_2-ring"])
    'sun-planet_1 … sun-planet_5, planet_1-ring, planet_2-ring'
    >>> mesh_names(["st1", "st2", "st4", "st5"]), mesh_names(["input", "idler", "cam", "pump", "oil", "fan"])
    ('st1, st2, st4, st5', 'input, idler, cam, pump and 2 more')
    """
    runs: list[list[str]] = []
    for mesh in meshes:
        run = next((run for run in runs if _follows(run[-1], mesh)), None)
        if run is None:
            runs.append([mesh])
        else:
            run.append(mesh)
    pieces = [piece for run in runs for piece in (run if len(run) < RANGE else [f"{run[0]} … {run[-1]}"])]
    if len(pieces) <= MAX_NAMED + 1 or len(pieces) < len(meshes):
        return ", ".join(pieces)
    return f"{', '.join(pieces[:MAX_NAMED])} and {len(meshes) - MAX_NAMED} more"


def _follows(before: str, mesh: str) -> bool:
    """Whether a name is another one with the next number.

    Examples
    --------
    >>> _follows("planet_1-ring", "planet_2-ring"), _follows("st2", "st4"), _follows("a", "b")
    (True, False, False)
    """
    numbers = [re.findall(r"\d+", name) for name in (before, mesh)]
    alike = re.sub(r"\d+", "#", before) == re.sub(r"\d+", "#", mesh) and len(numbers[0]) == 1
    return alike and int(numbers[1][0]) == int(numbers[0][0]) + 1


def percent(share: float) -> str:
    """Share of the time in per cent; a dash if it is not known.

    Examples
    --------
    >>> percent(0.8213), percent(1e-4), percent(math.nan)
    ('82.1 %', '0.01 %', '–')
    """
    return f"{number(100.0 * share, 3)} %" if math.isfinite(share) else "–"


def closing_words(speed: float) -> str:
    """Closing speed in mm/s, as in the tables of runs; a dash if it is not known.

    Examples
    --------
    >>> closing_words(0.4467), closing_words(math.nan)
    ('446.7 mm/s', '–')
    """
    return f"{number(1e3 * speed, 4)} mm/s" if math.isfinite(speed) else "–"


def jump_words(found: Sequence[MeshSweep]) -> str:
    """Mesh frequencies of the jumps of meshes in one direction; with their names if there are several.

    Examples
    --------
    >>> from dataclasses import replace
    >>> one = MeshSweep("st1", "up", 40, 0, 1e-6, 50.0, 9.0, 50.0, 0.0, 50.0, 0.0, 0.0, (5500.0,))
    >>> jump_words([one]), jump_words([one, replace(one, mesh="st2", jumps=())])
    ('5500 Hz', '5500 Hz (st1)')
    """
    texts: dict[str, list[str]] = {}
    for one in found:
        if one.jumps:
            texts.setdefault(", ".join(amount(f, "Hz") for f in one.jumps), []).append(one.mesh)
    named = len(found) > 1
    words = [f"{text} ({mesh_names(meshes)})" if named else text for text, meshes in texts.items()]
    return ", ".join(words) or "none"


def _separation(own: Sequence[MeshSweep], place: Callable[[float], str]) -> str:
    """Points with contact loss, and the largest one with its place."""
    most = max((one for one in own if math.isfinite(one.loss)), key=lambda one: one.loss)
    count, total = sum(one.apart for one in own), sum(one.points for one in own)
    at = f"{place(most.loss_at)} {most.direction}wards"
    return f"separate at {count} of {total} points, for up to {percent(most.loss)} of the time at {at}"


def _severity(own: Sequence[MeshSweep]) -> tuple[float, float]:
    """Key that sorts the mesh with the largest contact loss, then with the largest force first."""
    losses = [one.loss for one in own if math.isfinite(one.loss)]
    forces = [abs(one.force) for one in own if math.isfinite(one.force)]
    return -max(losses, default=0.0), -max(forces, default=0.0)


def _by_mesh(found: Sequence[MeshSweep]) -> dict[str, list[MeshSweep]]:
    """Both directions of each mesh."""
    by_mesh: dict[str, list[MeshSweep]] = {}
    for one in found:
        by_mesh.setdefault(one.mesh, []).append(one)
    return by_mesh


def _of(meshes: Sequence[str]) -> str:
    """Meshes after "flanks"; results of earlier versions have the swept mesh without its name."""
    if len(meshes) == 2:
        return f" of {meshes[0]} and {meshes[1]}"
    return f" of {mesh_names(meshes) or 'the swept mesh'}"
