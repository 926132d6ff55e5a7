# SPDX-License-Identifier: Apache-2.0
"""A package from outside, really installed: its kind and its section of the model file work like ours."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.yaml_model import loads_model

SUPPORT = Path(__file__).parents[2] / "support"
STIFFNESS, INERTIA, SPEED = 200.0, 0.01, 5.0
BODIES = "".join(
    f"  {name}: {{motion: torsion, inertia: {INERTIA} kg m^2, position: [0, 0, {0.1 * k} m]}}\n"
    for k, name in enumerate("abcdef")
)
SECTIONS = f"""\
bodies:
{BODIES}scenarios:
  rest: {{duration: 1 s, step: 1 ms, speed: {{a: {SPEED} rad/s}}}}
  slip: {{duration: 1 s, step: 1 ms, drive: {{e: {{speed: 10 rad/s}}, f: {{speed: 8 rad/s}}}}}}
"""
MODEL = f"""{SECTIONS}magnet_couplings:
  first: {{bodies: [a, b], stiffness: {STIFFNESS:g} N m/rad}}
  second: {{bodies: [b, c], stiffness: {STIFFNESS:g} N m/rad}}
  third: {{bodies: [c, d], stiffness: {STIFFNESS:g} N m/rad}}
  brake: {{bodies: [e, f], stiffness: 1e-9 N m/rad, damping: 2 N m s/rad}}
"""


def run(arguments, **more):
    """Standard output of a process that ends well."""
    done = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=False, **more)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Folder with the package, installed by pip from its project, and a model that uses it."""
    folder = tmp_path_factory.mktemp("outside")
    project = shutil.copytree(SUPPORT / "outside", folder / "project")
    pip = ["-m", "pip", "install", "--quiet", "--no-deps", "--no-index", "--no-build-isolation"]
    run([*pip, "--disable-pip-version-check", "--target", str(folder / "site"), str(project)])
    (folder / "magnets.yaml").write_text(MODEL, encoding="utf-8")
    return folder


def within(folder):
    """Environment in which the package is installed."""
    known = os.environ.get("PYTHONPATH")
    return {**os.environ, "PYTHONPATH": os.pathsep.join([str(folder / "site"), *([known] if known else [])])}


@pytest.fixture(scope="module")
def found(installed):
    script = str(SUPPORT / "outside_run.py")
    return json.loads(run([script, str(installed / "magnets.yaml")], env=within(installed)))


def test_without_the_package_its_section_is_an_unknown_key():
    with pytest.raises(ModelError, match=r"magnet_couplings \(line 11\): is an unknown key"):
        loads_model(MODEL)


def test_models_without_the_section_keep_their_hash(found):
    assert found["empty"] == content_hash(loads_model(SECTIONS))


def test_the_section_is_in_the_schema(found):
    assert found["schema"]["description"] == "magnetic couplings between two bodies"
    assert found["schema"]["additionalProperties"] == {"$ref": "#/$defs/MagnetCoupling"}


def test_it_is_written_read_and_replaced(found):
    assert found["same"]
    assert found["changed"] == [50.0, True]
    assert found["alone"] == ["brake"]


def test_mistakes_in_it_are_reported_like_ours(found):
    assert "magnet_couplings.first.bodies" in found["unknown_body"]
    assert "did you mean stiffness?" in found["unknown_key"]
    assert "did you mean magnet_couplings?" in found["unknown_section"]


def test_failures_name_its_place(found):
    assert found["place"] == "magnet_couplings.first (line 12)"


def test_speeds_at_the_start_go_through_it(found):
    assert found["started"] == pytest.approx([SPEED] * 4 + [0.0] * 2)


def test_modes_of_a_chain_of_equal_discs(found):
    # a free chain of N discs: omega_n = 2 sqrt(k/J) sin(n pi / 2 N)
    wanted = [math.sqrt(STIFFNESS / INERTIA) / math.pi * math.sin(n * math.pi / 8.0) for n in (1, 2, 3)]
    np.testing.assert_allclose(found["modes"][-3:], wanted, rtol=1e-9)


def test_it_is_condensed(found):
    kept, kinds, _ = found["kept"]
    assert {"a", "d"} <= set(kept)
    assert not {"b", "c"} & set(kept)
    assert "magnet_coupling" not in kinds
    np.testing.assert_allclose(found["reduced"][-3:], found["modes"][-3:], rtol=1e-9)


def test_it_is_drawn(found):
    assert {"clutch first, a", "clutch first, b"} <= set(found["scene"])


def test_it_is_balanced_in_the_power_flow(found):
    # 2 N m s/rad at a slip of 2 rad/s: 4 N m from a shaft at 10 rad/s to one at 8 rad/s
    [brake] = [link for link in found["links"] if link[0] == "brake"]
    assert brake[2:4] == pytest.approx([40.0, 32.0], rel=1e-6)
    assert brake[4] == {"damping": pytest.approx(8.0, rel=1e-6)}
    assert found["unfollowed"] == []


def test_commands_know_it(installed):
    model = str(installed / "magnets.yaml")
    text = run(["-m", "pitchpoint", "check", model], env=within(installed))
    assert "magnet_couplings: first, second, third, brake" in text
