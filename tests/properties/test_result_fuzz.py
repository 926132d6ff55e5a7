# SPDX-License-Identifier: Apache-2.0
"""Result files cut, with bytes changed, or marked as being written give data or a sentence, and soon."""

from __future__ import annotations

import os
import random
import subprocess
import sys
import textwrap
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.results import Channel, Header, ResultWriter
from pitchpoint.io.superblock import lookup3

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
