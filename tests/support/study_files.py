# SPDX-License-Identifier: Apache-2.0
"""Small models with closed forms for studies, and their plans."""

from __future__ import annotations

from pathlib import Path

INERTIAS = """\
title: two inertias on a shaft
bodies:
  one: {motion: torsion, position: [0, 0, 0], inertia: 0.02 kg m^2}
  two: {motion: torsion, position: [0, 0, 0.1 m], inertia: 0.05 kg m^2}
torsion_springs:
  shaft: {bodies: [one, two], stiffness: 5000 N m/rad, damping: 0.1 N m s/rad}
"""
FREQUENCY = """\
title: natural frequency
model: model.yaml
evaluate: modes
sampling: sobol
samples: 32
factors:
  stiffness: {type: lognormal, path: torsion_springs.shaft.stiffness, deviation: 0.1}
  first inertia:
    {type: tolerance, path: bodies.one.inertia, limits: [-0.003 kg m^2, 0.003 kg m^2], capability: 1}
  second inertia: {type: uniform, path: bodies.two.inertia, plus_minus: 0.002 kg m^2}
results:
  frequency: {channel: "undamped_frequency[2]", low: 90 Hz, high: 100 Hz}
  damping: {channel: "damping_ratio[2]"}
"""
SERIES = """\
title: shafts in series
bodies:
  one: {motion: torsion, position: [0, 0, 0], inertia: 0.02 kg m^2}
  two: {motion: torsion, position: [0, 0, 0.1 m], inertia: 0.05 kg m^2}
torsion_springs:
  first: {bodies: [one], stiffness: 5000 N m/rad}
  second: {bodies: [one, two], stiffness: 2000 N m/rad}
loads:
  inner: {body: one, torque: 30 N m}
  outer: {body: two, torque: 20 N m}
"""


def written(folder: Path, plan: str = FREQUENCY, model: str = INERTIAS) -> str:
    """Write plan and model; returns the path of the plan."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "model.yaml").write_text(model, encoding="utf-8")
    (folder / "plan.yaml").write_text(plan, encoding="utf-8")
    return str(folder / "plan.yaml")
