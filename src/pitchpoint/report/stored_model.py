# SPDX-License-Identifier: Apache-2.0
"""Model stored in a result file."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def stored_model(path: str, allow_code: bool = False) -> Model:
    """Load the model stored in a result file.

    Raises
    ------
    ModelError
        If the file contains no model, or it cannot be read.
    """
    from pitchpoint.io.reading import read_header
    from pitchpoint.io.yaml_model import loads_model

    text = read_header(path).get("model_text")
    if not text:
        remedy = "for a report, give the model file, too; else rerun the model"
        problem = Message("model", "is not stored in this result file", remedy=remedy)
        raise ModelError([problem], path)
    return loads_model(text, allow_code=allow_code, file=path)
