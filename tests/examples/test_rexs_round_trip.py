# SPDX-License-Identifier: Apache-2.0
"""Every example is written as a REXS file and read back; what differs is in the list of the writer."""

from __future__ import annotations

from pathlib import Path

import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.exporting.exporting import export_rexs
from pitchpoint.io.rexs.importing import import_rexs
from pitchpoint.io.rexs.writing.text import rexs_bytes
from pitchpoint.io.yaml_model import load_model
from tests.support.rexs_round_trip import differences, listed

FOLDER = Path(__file__).parents[2] / "examples"
NOT_READ = {
    "cam-follower/model.yaml": "is zero, but the body moves",
    "flexible-slider-crank/rigid.yaml": "is zero, but the body moves",
    "planetary-set/elastic_carrier.yaml": "is zero, but the body moves",
}
"""Examples that are not read back, with the reason of the import; nor are gears without bodies.

The file has no elastic bodies: the mass of an elastic carrier, and what is fixed to its nodes, is missing."""


def models():
    """Models of all examples by their files; plans are no models."""
    for path in sorted(FOLDER.rglob("*.yaml")):
        try:
            yield path.relative_to(FOLDER).as_posix(), load_model(path, allow_code=True)
        except ModelError:
            continue


def test_every_difference_of_every_example_is_listed(tmp_path):
    """All values have ids of the schema; geometry, masses, stiffness, loads and speeds return."""
    read, unlisted = 0, {}
    for name, model in models():
        found = export_rexs(model)
        for component in found.rexs.components.values():
            for key, value in component.attributes.items():
                known = tables.definition(tables.NEWEST, key, component.type)
                assert value.number is None or (known and component.type in known.components), (name, key)
        path = tmp_path / "written.rexs"
        path.write_bytes(rexs_bytes(found.rexs, "xml"))
        reason = NOT_READ.get(name) if model.bodies else "has no shafts"
        if reason is not None:
            with pytest.raises(ModelError, match=reason):
                import_rexs(path)
            continue
        again = import_rexs(path).model
        unlisted[name] = [d for d in differences(model, again) if not listed(d[0], model, found.omissions)]
        read += 1
    assert {name: rows for name, rows in unlisted.items() if rows} == {}
    assert read > 45
