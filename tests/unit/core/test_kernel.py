# SPDX-License-Identifier: Apache-2.0
"""The compiler door: import closure and its stamp, addresses, user laws, the run without a compiler."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap

import numpy as np
import pytest

from pitchpoint.core import kernel as door
from pitchpoint.core import notices
from pitchpoint.core.compiler import machine_code
from pitchpoint.core.compiler.import_closure import import_closure
from pitchpoint.core.kernel import COMPILING, call_law, kernel, law_address
from tests.support.cli_files import TORSION

BASE = """
    import numpy as np
    from pitchpoint.core.kernel import kernel, view
    from outsider.sub.helper import factor
    from pitchpoint.multibody.channels import frame_args
    RECORD = np.dtype([("value", "f8")], align=True)

    @kernel
    def entry(ctl, rec, n):
        view(rec, n, RECORD)[0]["value"] *= factor()
        return 1
"""
HELPER = """
    from pitchpoint.core.kernel import kernel

    @kernel
    def factor():
        return {value}
"""
RUN = """
    import numpy as np
    from outsider.kind import RECORD, entry
    import sys
    from pitchpoint.core.kernel import invoke
    rec = np.ones(1, RECORD)
    assert invoke(entry, 0, rec.ctypes.data, 1) == 1
    print(rec[0]["value"], "compiled" if "numba" in sys.modules else "loaded")
"""


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(textwrap.dedent(text))


def python(code, folder, **env):
    """Run code in a fresh interpreter with a private kernel cache; returns what it prints.

    Without new bytecode, which Python takes for that of a file edited within the same second.
    """
    full = {**os.environ, "NUMBA_CACHE_DIR": str(folder / "cache"), "PYTHONPATH": str(folder), **env}
    done = subprocess.run(
        [sys.executable, "-B", "-c", textwrap.dedent(code)],
        env=full,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split()


def test_closure_follows_absolute_and_relative_imports_and_stays_inside_the_packages(tmp_path):
    write(tmp_path / "outsider/__init__.py", "")
    write(tmp_path / "outsider/kind.py", "from .sub import helper\nimport numpy\n")
    write(tmp_path / "outsider/sub/__init__.py", "")
    write(tmp_path / "outsider/sub/helper.py", "from ..other import (\n    x,\n)\n")
    write(tmp_path / "outsider/other.py", "import pitchpoint.core.status\nx = 1\n")
    write(tmp_path / "outsider/unrelated.py", "")
    names = {p.name for p in import_closure(tmp_path / "outsider/kind.py")}
    assert {"kind.py", "helper.py", "other.py", "status.py"} <= names
    assert "unrelated.py" not in names
    assert not any("numpy" in str(p) for p in import_closure(tmp_path / "outsider/kind.py"))


def test_driver_reaches_the_core_but_no_kind():
    from pitchpoint.solvers.implicit import generalized_alpha

    names = {p.name for p in import_closure(generalized_alpha.__file__)}
    assert {"residual.py", "block_lu.py", "kinematics.py", "channels.py", "kernel.py"} <= names


@pytest.mark.stock
@pytest.mark.slow
def test_an_edited_helper_is_noticed_and_an_unchanged_kind_is_loaded(tmp_path):
    write(tmp_path / "outsider/__init__.py", "")
    write(tmp_path / "outsider/sub/__init__.py", "")
    write(tmp_path / "outsider/kind.py", BASE)
    write(tmp_path / "outsider/sub/helper.py", HELPER.format(value=2.0))
    assert python(RUN, tmp_path) == ["2.0", "compiled"]
    assert python(RUN, tmp_path) == ["2.0", "loaded"]
    write(tmp_path / "outsider/sub/helper.py", HELPER.format(value=3.0))
    assert python(RUN, tmp_path) == ["3.0", "compiled"]
    write(tmp_path / "outsider/unrelated.py", "x = 1\n")
    assert python(RUN, tmp_path) == ["3.0", "loaded"]
    assert python(RUN, tmp_path, NUMBA_OPT="1") == ["3.0", "compiled"]
    assert python(RUN, tmp_path) == ["3.0", "loaded"]


@pytest.mark.slow
def test_a_damaged_file_is_compiled_again(tmp_path):
    write(tmp_path / "outsider/__init__.py", "")
    write(tmp_path / "outsider/sub/__init__.py", "")
    write(tmp_path / "outsider/kind.py", BASE)
    write(tmp_path / "outsider/sub/helper.py", HELPER.format(value=2.0))
    assert python(RUN, tmp_path) == ["2.0", "compiled"]
    (file,) = (tmp_path / "cache").glob("entries/*/*.code")
    for damaged in (file.read_bytes()[:-100], b"", b"\n\n\n"):
        file.write_bytes(damaged)
        assert python(RUN, tmp_path) == ["2.0", "compiled"]
        assert python(RUN, tmp_path) == ["2.0", "loaded"]


@pytest.mark.slow
@pytest.mark.skipif(not COMPILING, reason="needs the compiler")
def test_without_a_cache_everything_is_compiled_and_nothing_is_left_beside_the_sources(tmp_path):
    write(tmp_path / "outsider/__init__.py", "")
    write(tmp_path / "outsider/sub/__init__.py", "")
    write(tmp_path / "outsider/kind.py", BASE)
    write(tmp_path / "cache", "a file where a folder should be")
    for value in (2.0, 3.0):
        write(tmp_path / "outsider/sub/helper.py", HELPER.format(value=value))
        assert python(RUN, tmp_path) == [str(value), "compiled"]
    assert not [*tmp_path.glob("outsider/**/*.nb?")]


def test_the_stamp_of_a_source_edited_while_the_process_runs_is_used_once(tmp_path):
    file = tmp_path / "kind.py"
    file.write_text("x = 1")

    def stamp():
        machine_code.source_stamp.cache_clear()
        return machine_code.source_stamp(str(file))

    assert stamp() != stamp()
    os.utime(file, (1.0, 1.0))
    assert stamp() == stamp()


UNFIT = """
    import numpy as np
    from pitchpoint.core.kernel import kernel

    @kernel
    def raising(a, b, n):
        if n > 1:
            raise ValueError("too many")
        return 1

    @kernel
    def allocating(a, b, n):
        return int(np.ones(n).sum())

    @kernel
    def fit(a, b, n):
        return a + b + n
"""
CALL = """
    from outsider.kind import allocating, fit, raising
    from pitchpoint.core import notices
    from pitchpoint.core.compiler import machine_code
    from pitchpoint.core.kernel import invoke
    print(*(invoke(f, 0, 0, n) for f, n in ((raising, 1), (raising, 2), (allocating, 7), (fit, 6))))
    print(*(machine_code.is_refused(f.py_func) for f in (raising, allocating, fit)))
"""


@pytest.mark.stock
@pytest.mark.slow
def test_entries_that_need_the_compiler_at_run_time_are_left_to_it(tmp_path):
    write(tmp_path / "outsider/__init__.py", "")
    write(tmp_path / "outsider/kind.py", UNFIT)
    for _ in range(2):
        assert python(CALL, tmp_path) == ["1", "0", "7", "6", "True", "True", "False"]


START = """
    import contextlib, io, sys
    from pitchpoint.cli.main import run_command
    with contextlib.redirect_stdout(io.StringIO()):
        status = run_command([*sys.argv[1:], "-q", "-o", "out.h5"])
    heavy = {"numba", "scipy", "xarray", "pandas", "plotly", "pint"}
    print(status, *sorted(heavy & {name.partition(".")[0] for name in sys.modules}))
"""


@pytest.mark.slow
@pytest.mark.skipif(not COMPILING, reason="a start is warm where the machine code is kept from before")
@pytest.mark.parametrize(
    "command",
    [["modes"], ["run", "-s", "steady"], ["sweep", "-s", "sweep"]],
)
def test_a_warm_start_imports_neither_the_compiler_nor_other_heavy_packages(tmp_path, command):
    (tmp_path / "model.yaml").write_text(
        TORSION.replace("0.5 s", "1 ms")
        .replace("points: 81", "points: 2")
        .replace("settle_periods: 200, measure_periods: 50", "settle_periods: 1, measure_periods: 1")
    )
    words = [sys.executable, "-c", textwrap.dedent(START), command[0], "model.yaml", *command[1:]]
    for _ in range(2):  # the first fills the cache, if it has to
        done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=False)
        if done.stdout.split() == ["0"]:
            break
    assert done.stdout.split() == ["0"], done.stdout + done.stderr


@pytest.fixture
def entry(tmp_path, monkeypatch):
    """A function whose machine code is in a cache of the test, under `cache/entries/settings`."""
    (tmp_path / "kind.py").write_text("def entry():\n    return 1\n")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(machine_code, "_settings", lambda: "settings")
    monkeypatch.setattr(notices, "_listeners", [])
    monkeypatch.setattr(notices, "_given", set())
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "kind", raising=False)
    import kind

    machine_code.is_trusted.cache_clear()
    machine_code.save(kind.entry, b"code", ["sin"])
    assert machine_code._read(kind.entry) == (["sin"], b"code")
    machine_code.is_trusted.cache_clear()
    yield kind.entry
    machine_code.is_trusted.cache_clear()


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
@pytest.mark.parametrize(
    ("place", "mode"), [("entries", 0o777), (".", 0o777), ("entries/settings", 0o777), (".", 0o770)]
)
def test_a_cache_that_others_can_write_is_not_used(entry, tmp_path, monkeypatch, caplog, place, mode):
    """Machine code from there is executed: another user could have put it there."""
    monkeypatch.setattr(machine_code, "_is_private", lambda _: False)
    folder = tmp_path / "cache" / place
    folder.chmod(mode)
    assert machine_code._read(entry) is None
    assert machine_code.load(entry) is None
    assert not machine_code.can_save()
    (line,) = caplog.messages
    assert line.startswith(str(folder.resolve()))
    assert "chmod go-w" in line


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_where_a_link_to_the_cache_leads_counts(entry, tmp_path, monkeypatch):
    shared = tmp_path / "shared"
    shared.mkdir()
    (tmp_path / "cache").rename(shared / "mine")
    (tmp_path / "cache").symlink_to(shared / "mine")
    assert machine_code._read(entry)
    machine_code.is_trusted.cache_clear()
    shared.chmod(0o777)
    assert machine_code._read(entry) is None


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_code_that_others_left_in_the_cache_is_not_used(entry):
    """Their permission for the folder may have been removed since."""
    file = machine_code.code_file(entry)
    assert file.stat().st_mode & 0o777 == 0o600
    file.chmod(0o666)
    assert machine_code._read(entry) is None
    file.chmod(0o600)
    assert machine_code._read(entry)


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
@pytest.mark.skipif(os.name == "posix" and os.getuid() != 0, reason="only root can give a file away")
def test_code_of_another_user_is_not_used(entry):
    os.chown(machine_code.code_file(entry), 12345, 0)
    assert machine_code._read(entry) is None


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_new_folders_of_the_cache_belong_to_the_user_alone(tmp_path, monkeypatch):
    before = os.umask(0)
    try:
        machine_code.make_folder(tmp_path / "a" / "b")
    finally:
        os.umask(before)
    assert [(tmp_path / name).stat().st_mode & 0o777 for name in ("a", "a/b")] == [0o700, 0o700]


def test_code_whose_symbols_are_missing_is_not_linked():
    assert machine_code.link("nothing", b"", ["sin", "no_such_function_anywhere"]) is None


def compiled_law(t, x, p):
    return p[0] * x + t


def plain_law(t, x, p):
    return float(str(x)) * p[0]


def failing_law(t, x, p):
    return {}[str(x)]


@kernel
def ask(where, t, x, p):
    return call_law(where, t, x, p)


@pytest.mark.stock
@pytest.mark.nojit
def test_user_laws_compiled_or_plain_give_the_same_call():
    p = np.array([3.0])
    assert ask(law_address(compiled_law), 1.0, 2.0, p.ctypes.data) == 7.0
    assert ask(law_address(plain_law), 1.0, 2.0, p.ctypes.data) == 6.0


@pytest.mark.stock
@pytest.mark.nojit
def test_an_exception_in_a_plain_law_becomes_nan():
    assert np.isnan(ask(law_address(failing_law), 0.0, 0.0, np.zeros(1).ctypes.data))


SMALL = """
    import sys
    sys.path.insert(0, {root!r})
    import numpy as np
    from pitchpoint.multibody.bodies import FREE, Body
    from pitchpoint.solvers.implicit import generalized_alpha
    from pitchpoint.system.system import assemble
    from tests.support.engine import bearings, couplings, torques
    K = np.diag([1e7, 2e7, 1e7, 1e4, 1e4, 0.0])
    body = [Body(motion=FREE, mass=1.0, polar_inertia=0.01, transverse_inertia=0.02, center=0.01, name=n)
            for n in "ab"]
    banks = {{"bearing": bearings([(1, 0, K, 1e-5 * K), (2, 0, K, 1e-5 * K)]),
             "coupling": couplings([(1, 2, 1e4, 1.0, 1e-3)]), "torque": torques([(1, 10.0), (2, -8.0)])}}
    s = assemble(body, banks)
    state = s.initial_state()
    state.v[:] = np.linspace(-0.01, 0.02, 12)
    run = generalized_alpha.start(s, state, 1e-5)
    assert run.advance(30).status == 1
    print(*(x.hex() for x in np.concatenate([run.state().q, run.state().v]).tolist()))
    print("numba" in sys.modules)
"""


def _run_of_small(jit: str, stock: str) -> tuple[np.ndarray, str]:
    """Results of a small machine in a process of its own, and whether it imported the compiler."""
    root = str(os.path.abspath(os.path.join(os.path.dirname(__file__), "../../..")))
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(SMALL.format(root=root))],
        env={**os.environ, "NUMBA_DISABLE_JIT": jit, "PITCHPOINT_STOCK_NUMBA": stock},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    *values, imported = done.stdout.split()
    return np.array([float.fromhex(x) for x in values]), imported


@pytest.mark.skipif(not COMPILING, reason="compares the ways of compiling")
def test_runs_with_and_without_the_compiler_agree():
    compiled, plain = (_run_of_small(jit, "0")[0] for jit in "01")
    np.testing.assert_allclose(compiled, plain, rtol=1e-12, atol=1e-12 * np.abs(plain).max())


# the stock compiler stores nothing before the first run, which takes half a minute
@pytest.mark.study
@pytest.mark.skipif(not COMPILING, reason="compares the ways of compiling")
def test_runs_with_the_stock_compiler_agree():
    """The second run with the stock compiler loads what the first has compiled, without importing it."""
    plain = _run_of_small("1", "0")[0]
    (first, _), (second, imported) = _run_of_small("0", "1"), _run_of_small("0", "1")
    assert imported == "False"
    np.testing.assert_array_equal(second, first)
    np.testing.assert_allclose(first, plain, rtol=1e-12, atol=1e-12 * np.abs(plain).max())


class _Named:
    """Stands for an entry."""

    __module__ = "some.module"

    def __init__(self, name):
        self.__name__ = name


def test_two_processes_share_what_has_to_be_compiled(monkeypatch):
    """What is expected is compiled here; whoever is done first takes from the end of the other's list."""
    mine, soon, mesh, bearing, torque = (_Named(n) for n in ("mine", "soon", "mesh", "bearing", "torque"))
    made, given, taken = [], [], []
    monkeypatch.setattr(door, "is_compiled", lambda entry: entry in made)
    monkeypatch.setattr(door, "address", made.append)
    monkeypatch.setattr(door, "announce", lambda count: None)
    monkeypatch.setattr(door, "delegate", given.extend)
    monkeypatch.setattr(door, "withdraw", taken.append)
    monkeypatch.setattr(machine_code, "can_save", lambda: True)
    door.expect(soon)
    door.prepare([mine], [mesh, bearing, torque])
    assert given == ["some.module:mesh", "some.module:bearing", "some.module:torque"]
    assert made == [mine, soon, torque, bearing]  # the other process is at the mesh
    assert taken == ["some.module:torque", "some.module:bearing"]
    door.prepare([mine, soon], [bearing, torque])
    assert made == [mine, soon, torque, bearing]


def test_nothing_is_given_to_a_second_process_that_could_not_hand_it_back(monkeypatch, tmp_path):
    (tmp_path / "file").write_text("no folder")
    mine, mesh, torque = (_Named(n) for n in ("mine", "mesh", "torque"))
    made, given = [], []
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    monkeypatch.setattr(door, "is_compiled", lambda entry: entry in made)
    monkeypatch.setattr(door, "address", made.append)
    monkeypatch.setattr(door, "announce", lambda count: None)
    monkeypatch.setattr(door, "delegate", given.extend)
    door.prepare([mine], [mesh, torque])
    assert (made, given) == ([mine, torque], [])


def test_functions_of_one_name_in_one_file_keep_their_code_beside_each_other(tmp_path, monkeypatch):
    write(tmp_path / "twins.py", "def entry():\n    return 1\n\none = entry\n\ndef entry():\n    return 2\n")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.syspath_prepend(tmp_path)
    import twins

    for function, code in ((twins.one, b"one"), (twins.entry, b"two")):
        machine_code.save(function, code, [])
    assert machine_code._read(twins.one) == ([], b"one")
    assert machine_code._read(twins.entry) == ([], b"two")
