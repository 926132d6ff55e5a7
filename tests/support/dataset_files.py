# SPDX-License-Identifier: Apache-2.0
"""A small plan over the torsional pair, and how it is written beside its model."""

from __future__ import annotations

from pathlib import Path

from tests.support.model_files import TORSIONAL_PAIR

MODEL = TORSIONAL_PAIR.replace("sample_rate: 100 kHz}", "method: rk4, step: 2.5 us}")
PLAN = """\
title: pair, some torques
model: pair.yaml
factors:
  torque: {loads.input.torque: [100 N m, 150 N m]}
  damping:
    usual: {}
    weak: {meshes.stage.damper.ratio: [0.02, 0.03]}
seeds: 2
jitter: {loads.input.torque: 1 %}
sample_rate: 20 kHz
length: 5 ms
settle_time: 2 ms
channels:
  force: {type: observation, channel: "mesh_force[stage]", noise: {snr: 20}}
  motion: {type: observation, channel: "speed[driven]", noise: {rms: 0.01}}
  clean: {type: observation, channel: "mesh_force[stage]"}
  tacho: {type: tacho, body: driver, pulses: 60}
"""
CASES = 2 * 3 * 2


def written(folder: Path, plan: str = PLAN, model: str = MODEL) -> str:
    """Write plan and model; returns the path of the plan."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "pair.yaml").write_text(model, encoding="utf-8")
    (folder / "plan.yaml").write_text(plan, encoding="utf-8")
    return str(folder / "plan.yaml")
