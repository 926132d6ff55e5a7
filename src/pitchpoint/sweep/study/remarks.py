# SPDX-License-Identifier: Apache-2.0
"""Remarks on the plan of a study that is valid, but probably not what was intended."""

from __future__ import annotations

import math

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.model import Model
from pitchpoint.model.study_plan import INDICES, LATIN, SOBOL
from pitchpoint.sweep.study.check import Study
from pitchpoint.sweep.study.factors import Number, Pitch

ENOUGH = 64
"""Number of points from which Sobol' indices have usable intervals."""
FAR = 4.0
"""Standard deviations from the mean beyond which the number of the model is not one of a distribution."""
HIGH = 0.84
"""Probability of the value with which a factor is tried, one standard deviation of a normal one."""


def remarks(study: Study) -> list[Message]:
    """Remarks on sampling and factors."""
    return [*_on_sampling(study), *_on_factors(study)]


def _remark(
    study: Study, where: tuple[str, ...], text: str, remedy: str, value: str | None = None
) -> Message:
    """Remark with the line of the plan."""
    line = study.plan.lines.get(where)
    return Message(".".join(where), text, value, None, remedy, line, "remark")


def _on_sampling(study: Study) -> list[Message]:
    """Numbers of samples that do not suit the sampling."""
    plan, n, found = study.plan, study.plan.samples, []
    at = ("samples",)
    if plan.sampling == SOBOL and n & (n - 1):
        upper = 1 << n.bit_length()
        text = "is not a power of two: the points of the Sobol' sequence are not balanced"
        found.append(_remark(study, at, text, f"write {upper // 2} or {upper}", str(n)))
    if plan.sensitivity == INDICES and n < ENOUGH:
        text = "gives wide intervals of Sobol' indices"
        found.append(_remark(study, at, text, f"write {ENOUGH} or more", str(n)))
    count = len(study.factors)
    least = count + 3
    if plan.sensitivity != INDICES and plan.sampling in (LATIN, SOBOL) and n < 2 * least:
        text = f"is a small number for a regression over {count} factor{'s' * (count > 1)}"
        found.append(_remark(study, at, text, f"write {2 * least} or more", str(n)))
    return found


def _on_factors(study: Study) -> list[Message]:
    """Factors far from the model, and centre distances that the backlash does not follow, or that change a
    profile shift."""
    found = []
    for factor in study.factors:
        if isinstance(factor, Pitch):
            continue
        at = ("factors", factor.name)
        if isinstance(factor, Number):
            found += _far(study, factor, at)
        value = float(factor.values(np.array([HIGH]))[0])
        try:
            changed = study.model.replace_all(factor.changes(HIGH, value))
        except ModelError:  # cases with such values fail
            continue
        for mesh, reason, remedy in _fixed_gaps(study.model, changed):
            text = f"changes the centre distance of {mesh}, but not its backlash: {reason}"
            found.append(_remark(study, at, text, remedy))
        for gear, words, remedy in _moved_shifts(study.model, changed):
            text = f"also changes the profile shift of {gear}, which follows the centre distance{words}"
            found.append(_remark(study, at, text, remedy))
    return found


def _far(study: Study, factor: Number, at: tuple[str, str]) -> list[Message]:
    """Remark on a distribution to which the number of the model does not belong."""
    mean, deviation = float(factor.distribution.mean()), float(factor.distribution.std())
    far = abs(mean - factor.nominal)
    if not far > FAR * deviation:
        return []
    text = f"has its mean {far / deviation:.3g} standard deviations away from the number of the model"
    return [_remark(study, at, text, "compare with the number of the model, and with `apply`")]


def _moved_shifts(model: Model, changed: Model) -> list[tuple[str, str, str]]:
    """Gears whose profile shift is not given and changes with a centre distance: gear, range, remedy."""
    found = []
    for name, gear in model.gears.items():
        before, after = gear.x, changed.gears[name].x
        if gear.profile_shift_coefficient is not None or before is None or after is None or before == after:
            continue
        remedy = f"to vary the distance of given gears, give the gear its present value, {before:.6g}"
        found.append((name, f", to {after:.4g} from {before:.4g} in the model", remedy))
    return found


def _fixed_gaps(model: Model, changed: Model) -> list[tuple[str, str, str]]:
    """Meshes whose centre distance changes while their backlash does not: mesh, reason, remedy."""
    found = []
    for name, mesh in model.meshes.items():
        before, after = model.pairs[name].a_w, changed.pairs[name].a_w
        if before == after:
            continue
        follows = 2.0 * (after - before) * math.sin(model.pairs[name].alpha_wt)
        if abs(changed.backlash(name) - model.backlash(name)) > 0.1 * abs(follows):
            continue
        if mesh.backlash is not None:
            remedy = "remove backlash, and give tooth_thickness_allowance of the gears"
            found.append((name, "it is given", remedy))
    return found
