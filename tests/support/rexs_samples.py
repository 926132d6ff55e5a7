# SPDX-License-Identifier: Apache-2.0
"""Published REXS files, in `shared/data/rexs` next to the repository or above it."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def samples() -> Path | None:
    """Folder of the sample models; None if it is not there."""
    for folder in ROOT.parents:
        found = folder / "shared" / "data" / "rexs" / "models"
        if found.is_dir():
            return found
    return None


def sample(name: str) -> Path:
    """Path of a sample; the test is skipped without the folder."""
    folder = samples()
    if folder is None:
        pytest.skip("the REXS samples (shared/data/rexs) are not next to the repository")
    return folder / name


needs_samples = pytest.mark.skipif(
    samples() is None, reason="the REXS samples are not next to the repository"
)
