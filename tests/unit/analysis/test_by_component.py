# SPDX-License-Identifier: Apache-2.0
"""Channels by bearing, mesh, body and component: equal to the flat ones, in memory and from files."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import pitchpoint as pp
from pitchpoint.core.errors import PitchpointError
from pitchpoint.elements import ring
from pitchpoint.io.contact_numbers import RATTLE
from pitchpoint.io.results import Channel, Header, ResultWriter, open_result

CHANNELS = {
    "speed[input]": "rad/s",
    "speed[output.2]": "rad/s",
    "mesh_force[set.planet_1]": "N",
    "mesh_force[set.planet_2]": "N",
    "pair_force[stage.0]": "N",
    "pair_force[stage.1]": "N",
    "bearing_force[left.fx]": "N",
    "bearing_force[left.my]": "N m",
    "bearing_force[right.end.my]": "N m",
    "bearing_force[left.direction]": "rad",
    "displacement[input.x]": "m",
    "beam_force[shaft.1.i.fx]": "N",
    "own_law[thing.x]": "m",
}
TIMES = np.linspace(0.0, 1.0, 7)


def rows():
    return np.random.default_rng(3).normal(size=(TIMES.size, len(CHANNELS)))


def in_memory():
    data = {
        name: ("time", column, {"units": unit})
        for (name, unit), column in zip(CHANNELS.items(), rows().T, strict=True)
    }
    return xr.Dataset({**data, "power_balance": ("time", TIMES)}, coords={"time": TIMES})


@pytest.fixture(scope="module")
def stored(tmp_path_factory):
    path = tmp_path_factory.mktemp("by") / "run.h5"
    listed = [Channel(name, unit, name) for name, unit in CHANNELS.items()]
    with ResultWriter(path, Header(kind="time", title="run"), listed) as writer:
        writer.append(TIMES, rows())
        writer.finish("finished")
    return path


def test_flat_channels_by_dimension(stored):
    with open_result(stored) as file:
        for run in (in_memory(), file):
            found = pp.by_component(run)
            force = found.bearing_force
            assert force.dims == ("time", "bearing", "component")
            assert [sorted(force[name].values) for name in ("bearing", "component")] == [
                ["left", "right.end"],
                ["direction", "fx", "my"],
            ]
            one = force.sel(bearing="left", component="my")
            assert np.array_equal(one, run["bearing_force[left.my]"])
            assert str(one.unit.values) == "N m"
            assert np.isnan(force.sel(bearing="right.end", component="fx")).all()
            assert np.array_equal(
                found.mesh_force.sel(mesh="set.planet_2", time=slice(0.2, 0.8)),
                run["mesh_force[set.planet_2]"].sel(time=slice(0.2, 0.8)),
            )
            assert found.mesh_force.attrs["units"] == "N"
            assert list(found.speed["body"].values) == ["input", "output.2"]
            assert found.pair_force.dims == ("time", "mesh", "tooth_pair")
            assert found.displacement.sel(body="input", component="x").sizes == {"time": TIMES.size}
            assert found.beam_force["beam_end"].values.tolist() == ["shaft.1.i"]
            assert found.own_law.dims == ("time", "element")
            assert found.own_law["element"].values.tolist() == ["thing.x"]
            assert force.isel(time=2, bearing=[1, 0]).shape == (2, 3)
            assert force.isel(time=[0, 4]).sel(component="my").values == pytest.approx(
                np.column_stack([run[f"bearing_force[{b}.my]"][[0, 4]] for b in ("left", "right.end")])
            )
            assert force.mean("time").shape == (2, 3)


def test_nothing_is_read_or_copied_before_use(stored, monkeypatch):
    """A selection of one component reads one channel."""
    with open_result(stored) as file:
        force = pp.by_component(file).bearing_force
        read = []
        own = xr.Variable.values.fget
        monkeypatch.setattr(xr.Variable, "values", property(lambda v: read.append(v.shape) or own(v)))
        picked = force.sel(bearing="left", component="fx")
        before = len([shape for shape in read if shape == TIMES.shape])
        assert picked.shape == TIMES.shape
        assert picked.values.shape == TIMES.shape
        # the variable itself and the channel
        assert len([shape for shape in read if shape == TIMES.shape]) - before == 2


def test_names_that_do_not_exist():
    found = pp.by_component(in_memory())
    with pytest.raises(AttributeError, match=r"no quantity is called 'bearing_forces'.*bearing_force"):
        _ = found.bearing_forces
    with pytest.raises(PitchpointError, match="no quantity is called 'torque'"):
        found["torque"]
    assert "bearing_force" in dir(found)
    assert "bearing_force (time: 7, bearing: 2, component: 3)" in repr(found)
    with pytest.raises(PitchpointError, match="no channel of an element"):
        pp.by_component(xr.Dataset({"power_balance": ("time", TIMES)}))


def test_components_of_real_bearings_and_contact_numbers_of_meshes():
    """Every output of a bearing is a component; every number of the contact has the dimension of the mesh."""
    names = [name.format("front_A") for name, _, _ in ring.OUTPUTS]
    names += [f"{name}[stage]" for name, _, _ in RATTLE]
    found = pp.by_component(xr.Dataset({name: ("case", [1.0, 2.0]) for name in names}))
    assert found.bearing_force["bearing"].values.tolist() == ["front_A"]
    assert found.bearing_force.sel(bearing="front_A", component="direction").values.tolist() == [1.0, 2.0]
    for name, _, _ in RATTLE:
        assert found[name].sel(mesh="stage").values.tolist() == [1.0, 2.0]
