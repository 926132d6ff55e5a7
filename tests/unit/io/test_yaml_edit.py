# SPDX-License-Identifier: Apache-2.0
"""Values changed in the text of a model file: comments stay, the model is that with the values."""

from __future__ import annotations

from pitchpoint.io.target import MODEL_MARK
from pitchpoint.io.yaml_edit import changed_text
from pitchpoint.io.yaml_model import loads_model
from tests.support.relief_models import TIP

TEXT = """\
title: "Pair"   # of spur gears
gears:
  pinion: {number_of_teeth: 25, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  # the larger one
  wheel: {number_of_teeth: 31, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}
meshes:
  stage: {gears: [pinion, wheel]}
"""
ALIASES = TEXT.replace("pinion: {", "pinion: &gear {").replace(
    "wheel: {number_of_teeth: 31, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0}",
    "wheel: *gear",
)
VALUES = {TIP.format("pinion", "amount"): "12.5 µm", TIP.format("pinion", "length"): "2 mm"}


def changed(text):
    """Model of a text with the values in it."""
    relief = {"tip_relief": {"amount": "12.5 um", "length": "2 mm"}}
    return loads_model(text).replace("gears.pinion.modifications", {"both": relief})


def test_comments_and_order_stay():
    model = changed(TEXT)
    text = changed_text(TEXT, model, VALUES, "m.yaml")
    assert text.startswith(MODEL_MARK)
    for words in ('title: "Pair"', "# of spur gears", "# the larger one", "amount: 12.5 µm"):
        assert words in text
    assert text.index("pinion:") < text.index("wheel:") < text.index("meshes:")
    assert loads_model(text) == model
    assert changed_text(text, model, VALUES, "m.yaml") == text


def test_existing_values_are_replaced():
    first = changed_text(TEXT, changed(TEXT), VALUES, "m.yaml")
    path = TIP.format("pinion", "amount")
    model = loads_model(first).replace(path, "9 um")
    text = changed_text(first, model, {path: "9 µm"}, "m.yaml")
    assert "amount: 9 µm, length: 2 mm" in text
    assert "12.5" not in text


def test_shared_parts_are_written_apart():
    """The wheel is an alias of the pinion, which alone is changed."""
    model = changed(ALIASES)
    assert model.gears["wheel"].modifications is None
    text = changed_text(ALIASES, model, VALUES, "m.yaml")
    assert loads_model(text) == model
