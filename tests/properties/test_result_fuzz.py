# SPDX-License-Identifier: Apache-2.0
"""Damaged result files give data or a sentence, and soon.

They are cut, marked as being written, or have bytes, objects or attributes changed; functions and commands
read them.
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
import textwrap
from pathlib import Path

import h5py
import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.io.results import Channel, Header, ResultWriter
from pitchpoint.io.superblock import lookup3
from tests.support.cli_files import TORSION, written

CASES = 80
SOON = 120.0
"""Seconds for all cases, many times what they need; HDF5 alone may need years for one."""

READ = """
    import sys
    from pathlib import Path
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.reading import list_channels, open_result, read_channel, read_header
    from pitchpoint.io.target import OutputError, check_target

    def asked(question, path):
        try:
            question(path)
            return True
        except PitchpointError as error:
            assert str(path) in str(error) and "\\n" not in str(error), error
            return False

    def load(path):
        with open_result(path) as data:
            data.load()

    questions = (load, read_header, list_channels, lambda p: read_channel(p, "speed[g1]"),
                 lambda p: check_target(p, "result"))
    for path in sorted(Path(sys.argv[1]).glob("*.h5")):
        print(path.name, *(asked(question, path) for question in questions), flush=True)
"""


def damage(data: bytes, chance: random.Random) -> bytes:
    """Cut or change a file; some are marked as open for writing, with the check sum that belongs to it."""
    raw = bytearray(data)
    kind = chance.choice(("cut", "change", "head", "mark"))
    if kind == "cut":
        return bytes(raw[: chance.randrange(len(raw))])
    if kind == "mark":
        raw[11] = chance.choice((1, 4, 5, 255))
        raw[44:48] = lookup3(bytes(raw[:44])).to_bytes(4, "little")
    for _ in range(chance.randrange(0 if kind == "mark" else 1, 4)):
        raw[chance.randrange(48, 4096 if kind == "head" else len(raw))] = chance.randrange(256)
    return bytes(raw)


@pytest.mark.parametrize("status", ["finished", "running"])
def test_damaged_result_files(tmp_path: Path, status: str) -> None:
    good, folder, chance = tmp_path / "good.h5", tmp_path / "damaged", random.Random(7)
    folder.mkdir()
    writer = ResultWriter(
        good,
        Header("run", "pair", model_text="gears: {}"),
        [Channel("mesh_force[stage]", "N"), Channel("speed[g1]", "rad/s")],
        events=["contact[stage]"],
        block=64,
    )
    t = np.arange(300) / 1000.0
    writer.append(t, np.column_stack((np.sin(t), np.cos(t))))
    writer.append_events(np.array([[0.1, 0, 1], [0.2, 0, -1]]))
    writer.flush()
    data = good.read_bytes()
    writer.finish()
    data = good.read_bytes() if status == "finished" else data
    (folder / "000.h5").write_bytes(data)
    for k in range(1, CASES):
        case = folder / f"{k:03d}.h5"
        case.write_bytes(damage(data, chance))
        os.utime(case, (0.0, 0.0))  # one that has just been changed is looked at again for a moment
    command = [sys.executable, "-c", textwrap.dedent(READ), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=SOON, check=False)
    lines = done.stdout.splitlines()
    assert done.returncode == 0, (lines[-1:], done.stderr[-2000:])
    assert lines[0] == "000.h5 True True True True True"
    assert len(lines) == CASES
    # a good part of each kind, or the damage is none
    assert 0.2 * CASES < sum("True" in line.split()[1] for line in lines) < 0.8 * CASES


ASK = """
    import contextlib, io, sys
    from pathlib import Path
    from pitchpoint.cli.main import run_command
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.io.reading import open_result

    page = str(Path(sys.argv[1], "page.html"))
    for path in sorted(Path(sys.argv[1]).glob("*.h5")):
        print(path.name, end=" ", flush=True)
        try:
            with open_result(path) as data:
                data.load()
        except PitchpointError as error:
            assert str(path) in str(error), error
        for words in (["report", "-o", page], ["view", "-o", page], ["analyse"]):
            said = io.StringIO()
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
                code = run_command([*words, str(path), "--debug"])
            assert code in (0, 2, 3), (path.name, words, said.getvalue())
        print("fine", flush=True)
"""


def change_objects(path: Path, chance: random.Random) -> None:
    """Remove, retype or reshape an object of a file, or change an attribute, as HDF5 itself allows it."""
    with h5py.File(path, "r+") as file:
        names: list[str] = []
        file.visit(names.append)
        name = chance.choice(names)
        item, kind = file[name], chance.choice(("delete", "retype", "reshape", "group", "attribute", "strip"))
        shape = item.shape if isinstance(item, h5py.Dataset) else (3,)
        if kind in ("attribute", "strip"):
            at = chance.choice((file, item))
            key = chance.choice(list(at.attrs) or ["units"])
            at.attrs.pop(key, None)
            if kind == "attribute":
                new = (b"\xff\xfe", 3.5, np.zeros(4), "", h5py.Empty("f"), "{", -1)
                at.attrs[key] = chance.choice(new)
            return
        del file[name]
        if kind == "group":
            file.create_group(name)
        elif kind == "retype":
            new = (np.full(shape, b"x"), np.zeros(shape, "i4"), np.zeros(shape, "c16"), np.float64(1.0))
            file[name] = chance.choice(new)
        elif kind == "reshape":
            file[name] = np.zeros(chance.choice(((0,), (1,), (2, 3), (7,), ())))


def change_bytes(path: Path, chance: random.Random) -> None:
    """Flip one bit, or put zeros over a sector."""
    data = bytearray(path.read_bytes())
    if chance.random() < 0.5:
        data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    else:
        at = chance.randrange(len(data) - 512)
        data[at : at + 512] = bytes(512)
    path.write_bytes(data)


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """A run, a sweep, cases and modes of a pair."""
    folder = tmp_path_factory.mktemp("results")
    text = TORSION.replace("duration: 0.5 s", "duration: 5 ms").replace("points: 81", "points: 3")
    file, vary = written(folder, text), "loads.input.torque=100 N m,150 N m"
    commands = {
        "run": ["run", file, "-s", "steady"],
        "sweep": ["sweep", file],
        "cases": ["run", file, "-s", "steady", "--vary", vary],
        "modes": ["modes", file],
    }
    for name, words in commands.items():
        assert run_command([*words, "-o", str(folder / f"{name}.h5"), "-q"]) == 0
    return sorted(folder.glob("*.h5"))


@pytest.mark.parametrize("count", [5, pytest.param(1000, marks=pytest.mark.study)])
def test_changed_objects_through_the_commands(count: int, results: list[Path], tmp_path: Path) -> None:
    chance = random.Random(count)
    for k in range(count):
        path = tmp_path / f"{k:04d}.h5"
        path.write_bytes(results[k % len(results)].read_bytes())
        chance.choice((change_objects, change_objects, change_bytes))(path, chance)
        os.utime(path, (0.0, 0.0))
    command = [sys.executable, "-c", textwrap.dedent(ASK), str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120.0 + 20.0 * count, check=False)
    assert done.returncode == 0, (done.stdout.splitlines()[-1:], done.stderr[-3000:])
    assert len(done.stdout.splitlines()) == count
