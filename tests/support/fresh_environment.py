# SPDX-License-Identifier: Apache-2.0
"""A fresh environment with the wheel, without the checkout, and the first five minutes of README in it.

``python -m tests.support.fresh_environment FOLDER`` makes one from the package index with the newest Numba of
the day (``make newest-numba``); ``--numba 0.69.0`` takes another release.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
import venv
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
WINDOWS = sys.platform == "win32"


class Step(NamedTuple):
    """One command of the page."""

    command: str
    seconds: float
    output: str
    messages: str


def build_wheel(folder: Path) -> Path:
    """Build the wheel of this checkout."""
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    return wheel


def borrow(folder: Path, wheel: Path) -> Path:
    """Make an environment that borrows all packages but pitchpoint from the running one; its interpreter."""
    python = _environment(folder, pip=False)
    own = Path(_ask(python, "import sysconfig; print(sysconfig.get_path('purelib'))"))
    shutil.unpack_archive(wheel, own, "zip")
    others = [place for place in sys.path if Path(place).name in ("site-packages", "dist-packages")]
    (own / "borrowed.pth").write_text("\n".join(others) + "\n", encoding="utf-8")
    return python


def install(folder: Path, wheel: Path, numba: str) -> Path:
    """Make an environment by pip alone, with another release of Numba; its interpreter."""
    python = _environment(folder, pip=True)
    pip = [str(python), "-m", "pip", "--quiet", "--disable-pip-version-check", "install"]
    subprocess.run([*pip, str(wheel)], check=True)
    subprocess.run([*pip, "--upgrade", "--upgrade-strategy", "eager", numba], check=True)
    return python


def _environment(folder: Path, pip: bool) -> Path:
    venv.create(folder, with_pip=pip, clear=True)
    return folder / ("Scripts/python.exe" if WINDOWS else "bin/python")


def _ask(python: Path, code: str) -> str:
    done = subprocess.run([python, "-c", code], check=True, capture_output=True, text=True)
    return done.stdout.strip()


def first_five_minutes(python: Path, folder: Path, **settings: str) -> list[Step]:
    """Run the commands of the first page in an empty folder; raises `RuntimeError` at the first that fails.

    Parameters
    ----------
    python
        Interpreter of the environment.
    folder
        Folder to work in.
    settings
        Environment variables in addition to those of this process.
    """
    model = re.search(r"^```yaml\n(.*?)^```", README, re.DOTALL | re.MULTILINE)
    assert model
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "pair.yaml").write_text(model[1], encoding="utf-8")
    ours = {"PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV"}
    environment = {k: v for k, v in os.environ.items() if k not in ours} | {"PYTHONUTF8": "1"} | settings
    steps = []
    for line in re.findall(r"^pitchpoint (\w+ pair\.yaml.*?)\s*$", README, re.MULTILINE):
        command = [str(python), "-m", "pitchpoint", *shlex.split(line, comments=True)]
        begun = time.perf_counter()
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, encoding="utf-8"
        )
        step = Step(line, time.perf_counter() - begun, done.stdout, done.stderr)
        if done.returncode:
            raise RuntimeError(f"pitchpoint {line}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        steps.append(step)
    return steps


def main() -> None:
    """Try the first five minutes with the newest Numba and print what happened."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="folder of the environment; what is there is replaced")
    parser.add_argument("--numba", default="", help="release of Numba; default: the newest of the index")
    chosen = parser.parse_args()
    folder: Path = chosen.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    python = install(
        folder / "venv", build_wheel(folder), f"numba=={chosen.numba}" if chosen.numba else "numba"
    )
    for name in ("pitchpoint", "numba", "llvmlite", "numpy"):
        version = _ask(python, f"from importlib.metadata import version; print(version({name!r}))")
        print(f"{name} {version}")
    for stock in ("0", "1"):
        print(f"PITCHPOINT_STOCK_NUMBA={stock}")
        cache = str(folder / f"kernels-{stock}")
        settings = {"NUMBA_CACHE_DIR": cache, "PITCHPOINT_STOCK_NUMBA": stock}
        for step in first_five_minutes(python, folder / f"work-{stock}", **settings):
            print(f"{step.seconds:7.1f} s  pitchpoint {step.command}")
            for message in step.messages.splitlines():
                print(f"           {message.rstrip()}")


if __name__ == "__main__":
    main()
