# SPDX-License-Identifier: Apache-2.0
"""What the test of an installed package reads, computed in a process of its own; prints one JSON object."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.schema import json_schema
from pitchpoint.model.write import model_text
from pitchpoint.report.power_flow import power_flow
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.initial_state.start import prepare_start
from pitchpoint.solvers.modal import find_modes
from pitchpoint.solvers.reduction.reduce import reduce_system
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.system.source import source


def refused(text: str) -> str:
    """Message about a text that is not a model."""
    try:
        loads_model(text)
    except ModelError as error:
        return str(error)
    return ""


def answers(file: Path) -> dict[str, object]:
    """Everything that the test looks at."""
    text = file.read_text(encoding="utf-8")
    model = load_model(file)
    again = loads_model(model_text(model))
    softer = model.replace("magnet_couplings.first.stiffness", 50.0)
    alone = model.replace("magnet_couplings", {"brake": {"bodies": ["e", "f"], "stiffness": 1.0}})
    system = compile_model(model, "slip")
    result = solve_time(system)
    flow = power_flow(model, result, 0.5)
    chain = compile_model(model, "rest")
    short = reduce_system(chain, limit=60.0, keep=["a", "d"])
    return {
        "schema": json_schema()["properties"]["magnet_couplings"],
        "same": again == model and content_hash(again) == content_hash(model),
        "changed": [softer.magnet_couplings["first"].stiffness, content_hash(softer) != content_hash(model)],
        "alone": list(alone.magnet_couplings),
        "empty": content_hash(loads_model(text.split("magnet_couplings:")[0])),
        "unknown_body": refused(text.replace("[a, b]", "[a, x]")),
        "unknown_key": refused(text.replace("stiffness: 200 N m/rad", "stifness: 200 N m/rad")),
        "unknown_section": refused(text.replace("magnet_couplings:", "magnet_coupling:")),
        "place": source(system, "magnet_coupling", "first"),
        "started": list(prepare_start(chain, model.scenarios["rest"]).state.v),
        "modes": [float(f) for f in np.asarray(find_modes(chain).frequency)],
        "kept": [list(short.kept), sorted(short.system.records), short.system.sizes["nd"]],
        "reduced": [float(f) for f in np.asarray(find_modes(short.system, start=short.state).frequency)],
        "scene": [solid.name for solid in scene_of(model).solids],
        "links": [[k.name, k.kind, k.given, k.taken, dict(k.losses)] for k in flow.links],
        "unfollowed": list(flow.unfollowed),
    }


if __name__ == "__main__":
    print(json.dumps(answers(Path(sys.argv[1]))))
