# SPDX-License-Identifier: Apache-2.0
"""Whatever stands in a file, the loader answers with a model or with a `PitchpointError`."""

from __future__ import annotations

import contextlib
import copy
import io
from pathlib import Path
from typing import Any

from hypothesis import given
from hypothesis import strategies as st
from ruamel.yaml import YAML

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.build import build_model
from pitchpoint.model.keys import walk
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader
from pitchpoint.system.compile import compile_model
from tests.support.model_files import CONTROLLED_PAIR, ISO_EXAMPLE, TORSIONAL_PAIR
from tests.support.mutation import at, places

EXAMPLES = Path(__file__).parents[2] / "examples"
SHIPPED = {
    name: (EXAMPLES / name / "model.yaml").read_text(encoding="utf-8")
    for name in ("flyball-governor", "phm-2009-rig", "speed-control", "squeezing-mechanism")
}
SIGNALS = ("sensors", "blocks", "controllers", "actuators")
KEYS = sorted({name for _, _, name, _ in walk(Model)} | {"law"})
UNITS = ["", " mm", " deg", " kg", " N m", " rpm", " Hz", " N/m", " s", " N/(mm um)", " furlong", " °", "²"]
NUMBERS = st.one_of(
    st.floats(),
    st.integers(-(10**9), 10**9),
    st.integers(),
    st.sampled_from([0, 1, -1, 17, 1e-9, 1e300, 20.0]),
)
QUANTITIES = st.builds(lambda n, u: f"{n}{u}", st.floats(-1e6, 1e6), st.sampled_from(UNITS))
WORDS = st.sampled_from(
    [
        "g1",
        "g2",
        "stage",
        "driver",
        "driven",
        "internal",
        "left",
        "fourier",
        "balance",
        "t",
        "sin(t)",
        "free",
        "up",
        "speed",
        "error",
        "driver.rim",
        "sum",
        "pid",
        "torque",
    ]
)
SCALARS = st.one_of(st.none(), st.booleans(), NUMBERS, QUANTITIES, WORDS, st.text(max_size=20))
NAMES = st.one_of(st.sampled_from(KEYS), WORDS, st.text(max_size=5))
TREES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(st.lists(inner, max_size=6), st.dictionaries(NAMES, inner, max_size=6)),
    max_leaves=25,
)


def load_or_refuse(data: Any) -> None:
    """Build a model; a refusal must name problems that can be shown."""
    try:
        model = build_model(data, Reader())
    except ModelError as error:
        assert error.problems
        assert all(str(p) for p in error.problems)
    else:
        assert build_model(data, Reader()) == model


def yaml_data(text: str) -> Any:
    return YAML(typ="safe", pure=True).load(text)


def put(data: Any, path: tuple[Any, ...], value: Any) -> None:
    for step in path[:-1]:
        data = data[step]
    data[path[-1]] = value


@given(TREES)
def test_arbitrary_structures(data: Any) -> None:
    load_or_refuse(data)


@given(
    st.dictionaries(
        st.sampled_from(sorted(["gears", "bodies", "meshes", "loads", "scenarios", "bearings", *SIGNALS])),
        TREES,
    )
)
def test_arbitrary_sections(data: Any) -> None:
    load_or_refuse(data)


@given(st.sampled_from([ISO_EXAMPLE, TORSIONAL_PAIR, CONTROLLED_PAIR]), st.data())
def test_valid_files_with_some_values_changed(text: str, data: st.DataObject) -> None:
    tree = yaml_data(text)
    for _ in range(data.draw(st.integers(1, 3))):
        path = data.draw(st.sampled_from(places(tree)))
        put(tree, path, data.draw(st.one_of(SCALARS, TREES)))
    load_or_refuse(tree)


@given(st.sampled_from(sorted(SHIPPED)), st.data())
def test_shipped_files_with_parts_moved(name: str, data: st.DataObject) -> None:
    """Parts deleted, doubled, copied or renamed: what names something that is gone is refused."""
    tree = yaml_data(SHIPPED[name])
    for _ in range(data.draw(st.integers(1, 3))):
        path, other = (data.draw(st.sampled_from(places(tree))) for _ in range(2))
        parent = at(tree, path[:-1])
        how = data.draw(st.sampled_from(["delete", "name", "copy", "double"]))
        if how == "delete":
            del parent[path[-1]]
        elif how == "name":
            parent[path[-1]] = data.draw(st.sampled_from(["nobody", "ground", "nobody.m", str(other[-1])]))
        elif how == "copy" and other != path[: len(other)]:
            parent[path[-1]] = copy.deepcopy(at(tree, other))
        elif how == "double" and isinstance(parent, dict):
            parent[f"{path[-1]}_2"] = copy.deepcopy(parent[path[-1]])
        if not places(tree):
            return
    load_or_refuse(tree)


@given(st.data())
def test_signals_with_some_values_changed(data: st.DataObject) -> None:
    """What is accepted can be compiled, written and read again."""
    tree = yaml_data(CONTROLLED_PAIR)
    for _ in range(data.draw(st.integers(1, 3))):
        section = data.draw(st.sampled_from(SIGNALS))
        path = data.draw(st.sampled_from([p for p in places(tree) if p[0] == section and len(p) > 2]))
        put(tree, path, data.draw(st.one_of(SCALARS, WORDS, TREES)))
    try:
        model = build_model(tree, Reader())
    except ModelError as error:
        assert all(str(p) for p in error.problems)
        return
    assert loads_model(dump_model(model)) == model
    with contextlib.suppress(PitchpointError):
        compile_model(model)


@given(st.sampled_from([ISO_EXAMPLE, TORSIONAL_PAIR]), st.data())
def test_random_numbers_in_random_keys(text: str, data: st.DataObject) -> None:
    """Numbers of a plausible size reach the geometry, where nothing but a refusal may come back."""
    tree = yaml_data(text)
    group = data.draw(st.sampled_from(["gears", "meshes"]))
    part = data.draw(st.sampled_from(sorted(tree[group])))
    for _ in range(data.draw(st.integers(1, 4))):
        key = data.draw(st.sampled_from([name for path, _, name, _ in walk(Model) if path.startswith(group)]))
        size = data.draw(st.sampled_from([1e-6, 1e-3, 0.1, 1.0, 100.0]))
        tree[group][part][key] = size * data.draw(st.floats(-10.0, 10.0))
    load_or_refuse(tree)


@given(
    z=st.tuples(st.integers(3, 150), st.integers(3, 150)),
    x=st.tuples(st.floats(-2, 2), st.one_of(st.none(), st.floats(-2, 2))),
    beta=st.floats(0, 50),
    ring=st.booleans(),
    distance=st.one_of(st.none(), st.floats(0.9, 1.1)),
    dedendum=st.floats(0.5, 2.0),
)
def test_random_pairs(
    z: tuple[int, int],
    x: tuple[float, float | None],
    beta: float,
    ring: bool,
    distance: float | None,
    dedendum: float,
) -> None:
    """A pair that is accepted has contact, room for its tips, and survives writing."""
    keys = {
        "normal_module": "2 mm",
        "face_width": "20 mm",
        "rack": {"dedendum": dedendum, "root_radius": 0.2},
    }
    helix = {"helix_angle": f"{beta} deg", "hand": "left"}
    one = {"number_of_teeth": z[0], "profile_shift_coefficient": x[0], **keys, **helix}
    two = {"number_of_teeth": z[1], "profile_shift_coefficient": x[1], **keys, **helix}
    two |= {"type": "internal"} if ring else {"hand": "right"}
    mesh: dict[str, Any] = {"gears": ["a", "b"]}
    if distance is not None:
        mesh["center_distance"] = max(distance * abs(z[0] + (-z[1] if ring else z[1])), 1.0) * 1e-3
    try:
        model = build_model({"gears": {"a": one, "b": two}, "meshes": {"m": mesh}}, Reader())
    except ModelError:
        return
    pair = model.pairs["m"]
    assert pair.eps_alpha > 0.0
    assert min(pair.c_1, pair.c_2) >= 0.0
    assert loads_model(dump_model(model)) == model


@given(st.text(max_size=200))
def test_arbitrary_text(text: str) -> None:
    with contextlib.suppress(PitchpointError):
        loads_model(text)


@given(st.sampled_from([ISO_EXAMPLE, TORSIONAL_PAIR, CONTROLLED_PAIR]), st.data())
def test_valid_text_with_characters_changed(text: str, data: st.DataObject) -> None:
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(text) - 1))
        new = data.draw(st.one_of(st.sampled_from(list("{}[]:,&*!|>'\"%@`#\t\n- 0.e")), st.text(max_size=2)))
        text = text[:at] + new + text[at + data.draw(st.integers(0, 3)) :]
    with contextlib.suppress(PitchpointError):
        loads_model(text)


@given(TREES)
def test_yaml_text_of_arbitrary_structures(data: Any) -> None:
    stream = io.StringIO()
    try:
        YAML(typ="safe", pure=True).dump(data, stream)
    except Exception:  # noqa: BLE001 - what cannot be written is no test case
        return
    with contextlib.suppress(PitchpointError):
        loads_model(stream.getvalue())
