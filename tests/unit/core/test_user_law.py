# SPDX-License-Identifier: Apache-2.0
"""User laws: compiled or called back, never run unasked, never a crash."""

from __future__ import annotations

import math

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.kernel import call_law, kernel
from pitchpoint.core.user_law import load_user_law

SOURCE = """
import math

def torque(t, x, p):
    return p[0] * math.sin(p[1] * t) + x

STORE = {"gain": 2.0}

def with_dictionary(t, x, p):
    names = {str(k): v for k, v in STORE.items()}
    return names["gain"] * x

def broken(t, x, p):
    return {}["no such key"]

def raising(t, x, p):
    if x > 0.0:
        raise ValueError("too large")
    return x

def sums(t, x, p):
    total = 0.0
    for k in range(3):
        total += p[k]
    return total

def short(t):
    return t

number = 3
"""


pytestmark = [pytest.mark.nojit, pytest.mark.stock]


@kernel
def through(where, t, x, p):
    """Call a law from compiled code."""
    return call_law(where, t, x, p)


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "laws.py").write_text(SOURCE)
    (tmp_path / "bad.py").write_text("raise RuntimeError('on import')")
    (tmp_path / "leaves.py").write_text("import sys\nsys.exit(0)")
    return tmp_path


def load(folder, name, **options):
    return load_user_law(name, folder, allow_code=True, where="loads.input.torque", **options)


def test_a_simple_law_runs_in_compiled_code(folder):
    law = load(folder, "laws.py:torque", parameters=(3.0, 2.0))
    got = through(law.address(), 0.4, 1.0, law.parameters.ctypes.data)
    assert got == pytest.approx(3.0 * math.sin(0.8) + 1.0, rel=1e-14)
    assert law(0.4, 1.0) == pytest.approx(got)


@pytest.mark.parametrize(("name", "given"), [("torque", 0), ("torque", 1), ("sums", 2)])
def test_a_missing_parameter_is_refused(folder, name, given):
    """Compiled code does not check indices: it would read the memory behind the parameters."""
    with pytest.raises(ModelError, match=f"uses more than its {given} parameters; add the numbers"):
        load(folder, f"laws.py:{name}", parameters=(1.0,) * given)
    assert load(folder, "laws.py:sums", parameters=(1.0, 2.0, 4.0))(0.0, 0.0) == 7.0


def test_a_law_beyond_the_compiler_is_called_back(folder):
    law = load(folder, "laws.py:with_dictionary")
    assert through(law.address(), 0.0, 21.0, law.parameters.ctypes.data) == 42.0


def test_an_exception_becomes_nan_and_can_be_explained(folder):
    law = load(folder, "laws.py:broken")
    assert math.isnan(through(law.address(), 0.0, 1.0, law.parameters.ctypes.data))
    assert law.diagnose(0.0, 1.0) == "laws.py:broken raised KeyError: 'no such key'"
    assert load(folder, "laws.py:torque", parameters=(1.0, 1.0)).diagnose(0.0, 1.0) == ""


def test_an_exception_in_compiled_code_is_no_silent_zero(folder, capfd):
    law = load(folder, "laws.py:raising")
    assert through(law.address(), 0.0, -1.0, law.parameters.ctypes.data) == -1.0
    assert math.isnan(through(law.address(), 0.0, 1.0, law.parameters.ctypes.data))
    assert capfd.readouterr().err == ""


def test_code_never_runs_unasked(folder):
    with pytest.raises(ModelError, match=r"loads.input.torque: .*not run unasked; call with --allow-code"):
        load_user_law("bad.py:f", folder, allow_code=False, where="loads.input.torque")


@pytest.mark.parametrize(
    ("reference", "message"),
    [
        ("laws.py", "write file.py:function"),
        ("laws.txt:f", "write file.py:function"),
        ("none.py:f", "does not exist"),
        ("laws.py:missing", "functions there: torque, with_dictionary"),
        ("laws.py:number", "names no function"),
        ("laws.py:short", r"define it as f\(t, x, p\)"),
        ("bad.py:f", "RuntimeError: on import"),
        ("leaves.py:f", "SystemExit: 0"),
    ],
)
def test_bad_references(folder, reference, message):
    with pytest.raises(ModelError, match=message):
        load(folder, reference)
