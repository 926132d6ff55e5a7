# SPDX-License-Identifier: Apache-2.0
"""Changes of single values in the text of a model file; comments and order of the others are kept."""

from __future__ import annotations

from collections.abc import Mapping
from io import StringIO
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import ModelError
from pitchpoint.core.provenance import content_hash
from pitchpoint.io.target import MODEL_MARK
from pitchpoint.io.yaml_model import dump_model, loads_model

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def changed_text(text: str, model: Model, values: Mapping[str, Any], file: str) -> str:
    """Text of a model file with values changed or added.

    Parameters
    ----------
    text
        Text of the model file.
    model
        The model with the new values, to which the result is compared.
    values
        New values by path, as in a model file.
    file
        Name of the file to be written: relative names of other files refer to its folder.

    Returns
    -------
    str
        The text with the values; if that does not read back to the model, as with aliases, the whole model
        without the comments of the file.
    """
    edited = MODEL_MARK + _edited(text.removeprefix(MODEL_MARK), values)
    try:
        read = loads_model(edited, allow_code=model.allow_code, file=file)
        if content_hash(read) == content_hash(model):
            return edited
    except ModelError:
        pass
    return MODEL_MARK + dump_model(model)


def _edited(text: str, values: Mapping[str, Any]) -> str:
    """Text with values set in its mappings."""
    from ruamel.yaml import YAML

    yaml = YAML(typ="rt", pure=True)
    yaml.preserve_quotes = True
    yaml.width = 4096
    data = yaml.load(text)
    for path, value in values.items():
        part, names = data, path.split(".")
        for name in names[:-1]:
            if part.get(name) is None:
                part[name] = {}
            part = part[name]
        part[names[-1]] = value
    stream = StringIO()
    yaml.dump(data, stream)
    return stream.getvalue()
