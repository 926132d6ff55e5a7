# SPDX-License-Identifier: Apache-2.0
"""Scripts of the examples as modules."""

from __future__ import annotations

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType


def script(file: Path) -> ModuleType:
    """Module of a script; dataclasses in it look their module up by its name."""
    spec = spec_from_file_location(f"{file.parent.name}/{file.stem}", file)
    assert spec is not None and spec.loader is not None
    module = sys.modules[spec.name] = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
