# SPDX-License-Identifier: Apache-2.0
"""The two ways through Numba: which one is taken, and what is reported about it."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from pitchpoint.core import notices
from pitchpoint.core.compiler import machine_code
from pitchpoint.core.kernel import COMPILING

if COMPILING:
    from pitchpoint.core.compiler import private_numba, public_numba

pytestmark = pytest.mark.skipif(not COMPILING, reason="needs the compiler")
ROOT = Path(__file__).parents[3]


@pytest.fixture
def heard(monkeypatch):
    """What is reported while the way is chosen anew."""
    reports: list[str] = []
    monkeypatch.delenv("PITCHPOINT_STOCK_NUMBA", raising=False)
    monkeypatch.setattr(public_numba, "_ways", [])
    monkeypatch.setattr(notices, "_listeners", [reports.append])
    monkeypatch.setattr(notices, "_given", set())
    return reports


def test_the_private_way_is_taken_for_tested_versions(heard):
    assert public_numba.private() is private_numba
    assert heard == []


@pytest.mark.parametrize("version", ["0.69.0", "0.69.0rc1", "1.0.0", "0.60.0", "0.70.0dev0+3.gabc"])
def test_other_versions_are_reported_once_and_get_the_public_interface(heard, monkeypatch, version):
    monkeypatch.setattr(public_numba.numba, "__version__", version)
    assert public_numba.private() is None
    assert public_numba.private() is None
    (line,) = heard
    assert line.startswith(f"Numba {version} is outside the tested range 0.61 to 0.68: ")
    assert "\n" not in line


@pytest.mark.parametrize("fault", [lambda: False, lambda: {}["absent"]])
def test_a_probe_that_does_not_fit_is_reported_once(heard, monkeypatch, fault):
    monkeypatch.setattr(private_numba, "probe", fault)
    assert public_numba.private() is None
    (line,) = heard
    assert "does not pass the probe" in line


def test_who_asks_for_stock_numba_gets_it_in_silence_and_in_a_folder_of_its_own(heard, monkeypatch):
    machine_code._settings.cache_clear()
    before = machine_code._settings()
    monkeypatch.setenv("PITCHPOINT_STOCK_NUMBA", "1")
    machine_code._settings.cache_clear()
    assert public_numba.private() is None
    assert heard == []
    assert machine_code._settings() != before
    machine_code._settings.cache_clear()


def test_without_a_listener_the_report_goes_to_the_log(monkeypatch, caplog):
    monkeypatch.setattr(notices, "_listeners", [])
    notices.notice("a sentence")
    notices.notice("a sentence")
    assert caplog.messages == ["a sentence"]


def test_the_tested_range_is_the_same_everywhere():
    low, high = ("{}.{}".format(*version) for version in public_numba.TESTED)
    wanted = f"numba>={low},<{high}"
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert [d for d in project["dependencies"] if re.match(r"numba\b", d)] == [wanted]
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if re.match(r"numba\b", line)] == [wanted]


CHANGED = """
import numba.core.codegen as codegen
{change}
import sys
import numpy as np
import loose
from pitchpoint.core.compiler import public_numba
from pitchpoint.core.kernel import invoke
record = np.array([(3.0,), (4.0,)], loose.RECORD)
print(invoke(loose.entry, 0, record.ctypes.data, 2), public_numba.private())
"""
ENTRY = """
import numpy as np
from pitchpoint.core.kernel import kernel, view
RECORD = np.dtype([("value", "f8")], align=True)

@kernel
def square(x):
    return x * x

@kernel
def entry(ctl, rec, n):
    total = 0.0
    for k in range(n):
        total += square(view(rec, n, RECORD)[k]["value"])
    return int(total)
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "error"),
    [
        ("del codegen.JITCodeLibrary", "ImportError"),
        ("del codegen.CPUCodeLibrary.serialize_using_object_code", "AttributeError"),
    ],
)
def test_kernels_compile_where_numba_renamed_its_parts(tmp_path, change, error):
    (tmp_path / "loose.py").write_text(ENTRY)
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache"), "PYTHONPATH": str(tmp_path)}
    environment.pop("PITCHPOINT_STOCK_NUMBA", None)
    code = [sys.executable, "-c", CHANGED.format(change=change)]
    done = subprocess.run(code, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["25", "None"]
    (line,) = done.stderr.splitlines()
    assert f"does not pass the probe ({error})" in line
