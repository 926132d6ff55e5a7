# SPDX-License-Identifier: Apache-2.0
"""Files of windIO: both layouts give the same turbine; a sentence with file and line for what is wrong."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pitchpoint.core.errors import ModelError, PitchpointError
from pitchpoint.geometry.rotor.blending import blend_polars
from pitchpoint.model.windio.beam import read_windio_beam
from pitchpoint.model.windio.rotor import read_windio_rotor
from tests.support.windio import VERSION_1, VERSION_2


@pytest.fixture
def file(tmp_path):
    """Function that writes a text and returns its path."""

    def write(text, name="small.yaml"):
        """Write the file."""
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("text", [VERSION_1, VERSION_2])
def test_rotor_and_tower(file, text):
    found = read_windio_rotor(file(text))
    rotor, blade = found.rotor, found.rotor.blade
    assert (rotor.blades, rotor.hub_radius, rotor.hub_height) == (3, 1.5, 80.0)
    assert (rotor.precone, rotor.tilt) == pytest.approx((0.05, 0.08))
    assert rotor.overhang == pytest.approx(4.0 / np.cos(0.08))
    assert blade.chord.tolist() == [2.0, 2.8, 2.2, 1.6, 0.5]
    assert blade.span.tolist() == [0.0, 7.5, 15.0, 22.5, 30.0]
    assert blade.twist == pytest.approx([0.2, 0.15, 0.1, 0.05, 0.0])  # PCHIP of a line
    # aerodynamic centre at mid-chord of the round root, on the axis; 0.05 chords ahead of it at the tip
    assert blade.sweep[[0, -1]] == pytest.approx([0.0, (0.25 - 0.3) * 0.5])
    assert blade.prebend[[0, -1]] == pytest.approx([0.0, -1.0])
    assert blade.polars[blade.polar_index[0]].name == "round"
    assert blade.polars[blade.polar_index[-1]].at(0.2)[0] == pytest.approx(1.6)
    middle = blade.polars[blade.polar_index[3]].at(0.0)[0]
    assert 0.3 < middle < 0.4  # between thick and thin
    assert found.tower is not None and found.tower.radius_at(40.0) == pytest.approx(2.25)


@pytest.mark.parametrize("version", ["1.0", '"1.0.1"', "1"])
def test_the_first_version_may_have_its_number(file, version):
    """Its angles are in radians."""
    rotor = read_windio_rotor(file(f"windIO_version: {version}\n{VERSION_1}")).rotor
    assert (rotor.precone, rotor.tilt) == pytest.approx((0.05, 0.08))
    with pytest.raises(ModelError, match=r"windIO_version \(third.yaml, line 1\): '3.0' is not .* 1 or 2"):
        read_windio_rotor(file(f"windIO_version: 3.0\n{VERSION_1}", "third.yaml"))


def test_both_layouts_are_one_turbine(file):
    """Angles of the second have six digits."""
    one, two = (read_windio_rotor(file(t, f"{k}.yaml")).rotor for k, t in enumerate((VERSION_1, VERSION_2)))
    for name in ("chord", "twist", "prebend", "sweep", "span", "curve_angle"):
        np.testing.assert_allclose(getattr(one.blade, name), getattr(two.blade, name), atol=1e-12)
    for k in range(5):
        a, b = (blade.polars[blade.polar_index[k]] for blade in (one.blade, two.blade))
        for alpha in (-2.0, -0.1, 0.0, 0.1, 0.3, 2.5):
            np.testing.assert_allclose(a.at(alpha), b.at(alpha), atol=1e-5)
    for component in ("blade", "tower"):
        one, two = (
            read_windio_beam(file(t, f"{component}{k}.yaml"), component)
            for k, t in enumerate((VERSION_1, VERSION_2))
        )
        names = {"blade": ("stiffness", "inertia", "twist"), "tower": ("mass", "bending_1", "gyration")}
        for name in ("position", *names[component]):
            np.testing.assert_allclose(getattr(one, name), getattr(two, name), rtol=1e-9, atol=1e-12)


def test_blade_as_a_beam(file):
    """At the root the elastic centre and the centre of mass are 0.1 m behind the axis: K_34 = E A 0.1 m, and
    the mass 500 kg/m has the moments of inertia 300, 100 and 400 kg m about the axis."""
    table = read_windio_beam(file(VERSION_1), "blade")
    assert table.length == 30.0
    assert table.offset_1[-1] == -1.0
    assert table.twist[0] == pytest.approx(-0.2)
    assert table.stiffness[0, 2, 3] == table.stiffness[0, 3, 2] == 1e9
    assert np.diag(table.stiffness[0]).tolist() == [1e9, 1e9, 1e10, 1e10, 4e9, 1e9]
    assert np.diag(table.inertia[0]).tolist() == [500.0, 500.0, 500.0, 300.0, 100.0, 400.0]
    assert table.inertia[0, 0, 5] == table.inertia[0, 5, 0] == -50.0
    assert not table.damping.any()


def test_damping_of_the_second_version(file):
    more = "      elastic_properties:\n"
    factors = "[0.003, 0.002, 0.001, 0.002, 0.003, 0.001]"
    text = VERSION_2.replace(more, f"{more}        structural_damping: {{mu: {factors}}}\n", 1)
    assert read_windio_beam(file(text), "blade").damping.tolist() == [
        0.003,
        0.002,
        0.001,
        0.002,
        0.003,
        0.001,
    ]
    with pytest.raises(ModelError, match=r"structural_damping.mu .*: 0.003, -1 is out of range .*six values"):
        read_windio_beam(file(text.replace(factors, "[0.003, -1]"), "wrong.yaml"), "blade")


def test_tower_as_a_beam(file):
    """Tube of 6 m and 30 mm: area 0.5627 m^2, I = 2.5066 m^4."""
    table = read_windio_beam(file(VERSION_1), "tower")
    area, second = np.pi / 4 * (6.0**2 - 5.94**2), np.pi / 64 * (6.0**4 - 5.94**4)
    assert table.length == 76.0
    assert table.mass[0] == pytest.approx(1.1 * 7800.0 * area)
    assert table.axial[0] == pytest.approx(2e11 * area)
    assert (table.bending_1[0], table.bending_2[0]) == pytest.approx((2e11 * second, 2e11 * second))
    assert table.torsion[0] == pytest.approx(2 * 8e10 * second)
    middle = np.pi / 64 * (4.5**4 - 4.45**4)
    assert np.interp(0.5, table.position, table.bending_1) == pytest.approx(2e11 * middle, rel=1e-9)


def test_moments_are_about_the_aerodynamic_centre(file):
    """windIO: the centre used to define the polars. Its station moves with it, and the moments stay."""
    old = VERSION_1[VERSION_1.index("  - name: thin") :]
    moved = VERSION_1.replace(old, old.replace("aerodynamic_center: 0.25", "aerodynamic_center: 0.3", 1))
    one, two = (read_windio_rotor(file(t, f"{k}.yaml")).rotor.blade for k, t in enumerate((VERSION_1, moved)))
    assert two.sweep[-1] - one.sweep[-1] == pytest.approx(0.05 * 0.5)
    for blade in (one, two):
        assert blade.polars[blade.polar_index[-1]].at(0.0)[2] == -0.08


def test_airfoils_and_polars_that_are_not_used_are_noted(file):
    """An airfoil of the same thickness, and polars of a configuration that the blade does not name."""
    assert read_windio_rotor(file(VERSION_2)).notes == ()
    more = VERSION_2[VERSION_2.index("      - configuration") : VERSION_2.index("  - name: thick")]
    rough = more.replace("default", "rough").replace("[0.5, 0.5]", "[0.7, 0.7]")
    text = VERSION_2.replace(more, more + rough, 1).replace("rthick: 0.4", "rthick: 0.2")
    found = read_windio_rotor(file(text, "more.yaml"))
    assert found.notes == (
        "airfoil round: polars of the configuration default, not of rough",
        "airfoil thin: not used, as thick has the same relative thickness",
    )
    assert found.rotor.blade.polars[found.rotor.blade.polar_index[0]].at(0.0)[1] == 0.5
    text = text.replace(
        "name: round, spanwise_position: 0.0, configuration: [default]",
        "name: round, spanwise_position: 0.0, configuration: [rough]",
    )
    with pytest.raises(
        ModelError, match="'?default'? is another configuration of round than at a place before"
    ):
        read_windio_rotor(file(text, "two.yaml"))
    text = text.replace(
        "name: round, spanwise_position: 0.2, configuration: [default]",
        "name: round, spanwise_position: 0.2, configuration: [rough]",
    )
    blade = read_windio_rotor(file(text, "rough.yaml")).rotor.blade
    assert blade.polars[blade.polar_index[0]].at(0.0)[1] == 0.7
    text = VERSION_2.replace(
        "spanwise_position: 0.6, configuration: [default]", "spanwise_position: 0.6, configuration: [clean]"
    )
    with pytest.raises(ModelError, match=r"polars .*: has no polars of the configuration 'clean', .*default"):
        read_windio_rotor(file(text, "clean.yaml"))


def test_polars_of_several_reynolds_numbers(file):
    """The polar of each station is that of its Reynolds number at 2 rad/s, linear over the logarithm."""
    old = VERSION_1[VERSION_1.index("  - name: thin") : VERSION_1.index("materials:")]
    begin = old.index("      - configuration")
    more = old[begin:].replace("re: 1.0e6", "re: 1.0e7").replace("1.6, 0.1, 0.0]", "1.8, 0.1, 0.0]", 1)
    text = VERSION_1.replace(old, old + more)
    blade = read_windio_rotor(file(text)).rotor.blade
    number = 2.0 * 31.5 * 0.5 / 1.46e-5
    wanted = 1.6 + 0.2 * np.log10(number / 1e6)
    assert blade.polars[blade.polar_index[-1]].at(0.2)[0] == pytest.approx(wanted, rel=1e-9)
    with pytest.raises(
        ModelError, match=r"control.rated_rotor_speed .*: is missing; add it: it selects the polars"
    ):
        read_windio_rotor(file(text.replace("VS_maxspd", "VS_speed"), "without.yaml"))


def test_blending_keeps_the_given_polars(file):
    blade = read_windio_rotor(file(VERSION_1)).rotor.blade
    polars = [blade.polars[blade.polar_index[k]] for k in (-1, 0)]
    found = blend_polars(polars, [0.2, 1.0], [0.2, 1.0, 0.6])
    assert found[0] is polars[0] and found[1] is polars[1]
    assert found[2].at(0.0)[1] == pytest.approx(0.5 * (0.006 + 0.5))


WRONG = {
    "labels: [round, round": ("labels: [square, round", "has no airfoil 'square'"),
    "values: [2.0, 2.8, 2.2, 1.6, 0.5]": ("values: [2.0, 2.8, 2.2, 1.6]", "5 as of grid"),
    "grid: [0.0, 0.2, 0.6": ("grid: [0.0, 0.7, 0.6", "0.6 does not increase (limit > 0.7)"),
    "values: [0.0, 30.0]": ("values: [30.0, 0.0]", "do not increase from the root to the tip"),
    "diameter: 3.0": ("diameter: -3.0", "-3 is out of range (limit > 0)"),
    "cone_angle: 0.05": (
        "cone_angle: 2.5",
        "cone_angle (small.yaml, line 28): 2.5 rad is out of range (limit -0.5 to 0.5 rad)",
    ),
    "cone_angle: 0.05}": (
        "cone_angle: wide}",
        "components.hub.cone_angle (small.yaml, line 28): 'wide' is not",
    ),
    "twist: {grid: [0.0, 0.5, 1.0], values: [0.2, 0.1": (
        "twist: {grid: [0.0, 0.5, 1.0], values: [0.2, .nan",
        "twist.values[1] (small.yaml, line 8): 'nan' is not a finite number",
    ),
    "      chord: {": ("      cord: {", "chord (small.yaml, line 5): is missing; did you mean cord?"),
    "grid: [-3.1416, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.0, -0.1, 0.3": (
        "grid: [-3.0, -1.6, 0.0, 0.2, 1.6, 3.1416], values: [0.0, -0.1, 0.3",
        "-180 to 180",
    ),
    "relative_thickness: 0.2": ("relative_thickness: 0.2x", "airfoils[2].relative_thickness"),
    "hub_height: 80.0": ("hub_height: 8" + 350 * "0", "assembly.hub_height (small.yaml, line 2)"),
    "values: [2.0, 2.8": ("values: [2" + 350 * "0" + ", 2.8", "chord.values[0] (small.yaml, line 7): '2000"),
    "number_of_blades: 3": ("number_of_blades: 2.5", "is not a whole number"),
    "components:": ("parts:", "components"),
    "hub_height: 80.0, ": ("hub_height: [80.0, ", "YAML syntax"),
    "re: 1.0e6": ("re: 1.0e6, re: 2", "YAML syntax"),
}


@pytest.mark.parametrize("word", WRONG)
def test_wrong_rotors_are_told(file, word):
    new, words = WRONG[word]
    assert word in VERSION_1
    with pytest.raises(ModelError) as error:
        read_windio_rotor(file(VERSION_1.replace(word, new, 1)))
    told = [str(p) for p in error.value.problems]
    assert any(words in each for each in told), told
    assert "small.yaml" in str(error.value)


UNITS = {
    "values: [2.0, 2.8, 2.2, 1.6, 0.5]": (
        "values: [2000, 2800, 2200, 1600, 500]",
        "2000 m is out of range (limit 0 to 30 m)",
    ),
    "twist: {grid: [0.0, 0.5, 1.0], values: [0.2, 0.1": (
        "twist: {grid: [0.0, 0.5, 1.0], values: [11.5, 5.7",
        "twist.values[0] (small.yaml, line 8): 11.5 rad is out of range (limit -1.5708 to 1.5708 rad); "
        "windIO 1 has angles in radians: correct the values, or windIO_version",
    ),
    "values: [0.0, 30.0]": ("values: [0.0, 30000.0]", "30000 m is the length (limit <= 1000 m)"),
    "diameter: 3.0": ("diameter: 3000.0", "3000 m is out of range (limit <= 60 m, twice the blade)"),
    "relative_thickness: 0.2": ("relative_thickness: 20", "20 is out of range (limit 0 to 1); give a share"),
    "uptilt: 0.08": ("uptilt: 5.0", "5 rad is out of range (limit -0.5 to 0.5 rad)"),
}
"""Values in other units than those of windIO."""


@pytest.mark.parametrize("word", UNITS)
def test_values_in_other_units_are_told_once(file, word):
    new, words = UNITS[word]
    assert word in VERSION_1
    with pytest.raises(ModelError) as error:
        read_windio_rotor(file(VERSION_1.replace(word, new, 1)))
    [problem] = error.value.problems
    assert words in problem and problem.line


def test_a_version_that_contradicts_the_layout(file):
    for text, version, other in ((VERSION_1, "2.0", 1), (VERSION_2, "1.0", 2)):
        wrong = f"windIO_version: {version}\n" + "\n".join(
            line for line in text.splitlines() if not line.startswith("windIO_version")
        )
        with pytest.raises(ModelError) as error:
            read_windio_rotor(file(wrong, f"{other}.yaml"))
        [problem] = error.value.problems
        assert "contradicts the layout" in problem and f"write windIO_version: {other}" in problem


@pytest.mark.parametrize("part", ["components.blade", "airfoils", "components.hub"])
def test_what_is_missing_is_one_problem(file, part):
    """The part, not each value in it."""
    name = part.rpartition(".")[2]
    with pytest.raises(ModelError) as error:
        read_windio_rotor(file(VERSION_1.replace(f"{name}:", f"no_{name}:", 1)))
    [problem] = error.value.problems
    assert problem.where == part and "is missing" in problem


WRONG_BEAMS = {
    "blade": {
        "[1e9, 0, 0, 0, 0, 0, 1e9": (
            "[-1e9, 0, 0, 0, 0, 0, 1e9",
            "at station 1 of the grid the stiffness matrix is not positive definite",
        ),
        "[500, 0, 0, 0, 0, -50": (
            "[500, 0, 0, 0, 0, 50",
            "the mass matrix has two centres of mass: the entries 16",
        ),
        "4e9, 0, 1e9]": ("4e9, 0]", "20 is the number of values (limit 21)"),
        "stiff_matrix:": ("stif_matrix:", "did you mean stif_matrix?"),
    },
    "tower": {
        "material: steel": (
            "material: wood",
            "names the material 'wood', which does not exist; there are steel",
        ),
        "values: [0.03, 0.02]": ("values: [4.0, 0.02]", "is the wall at 0 of the length"),
        "outer_diameter: {": ("diameter: {", "outer_diameter"),
        "E: 2.0e11": ("E: much", "materials[0].E"),
    },
}


@pytest.mark.parametrize(
    ("component", "word"), [(c, word) for c, entries in WRONG_BEAMS.items() for word in entries]
)
def test_wrong_beams_are_told(file, component, word):
    new, words = WRONG_BEAMS[component][word]
    assert word in VERSION_1
    with pytest.raises(ModelError) as error:
        read_windio_beam(file(VERSION_1.replace(word, new, 1)), component)
    told = [str(p) for p in error.value.problems]
    assert any(words in each for each in told), told
    assert "small.yaml" in str(error.value)


def test_all_problems_at_once(file):
    text = VERSION_1.replace("diameter: 3.0", "diameter: 0").replace("uptilt: 0.08", "uptilt: steep")
    with pytest.raises(ModelError, match="2 problems"):
        read_windio_rotor(file(text))


def test_files_that_are_no_turbines(file, tmp_path):
    with pytest.raises(ModelError, match="cannot be read"):
        read_windio_rotor(tmp_path / "none.yaml")
    with pytest.raises(ModelError, match="give a turbine of the ontology windIO"):
        read_windio_rotor(file("bodies: {}"))
    bomb = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n" + "".join(
        f"{chr(98 + k)}: &{chr(98 + k)} [{', '.join(['*' + chr(97 + k)] * 10)}]\n" for k in range(6)
    )
    with pytest.raises(ModelError, match="without aliases"):
        read_windio_rotor(file(bomb))


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    text=st.sampled_from([VERSION_1, VERSION_2]),
    cut=st.floats(0.0, 1.0),
    changes=st.lists(st.tuples(st.floats(0.0, 1.0), st.binary(max_size=4), st.integers(0, 30)), max_size=3),
)
def test_damaged_files_give_a_sentence(file, text, cut, changes):
    """Bytes replaced, inserted or lost, and files cut: read, or refused with a sentence."""
    data = text.encode()
    for place, new, lost in changes:
        k = int(place * len(data))
        data = data[:k] + new + data[k + lost :]
    path = file("")
    path.write_bytes(data[: int(cut * len(data))] if cut < 0.5 else data)
    for read in (
        read_windio_rotor,
        lambda p: read_windio_beam(p, "blade"),
        lambda p: read_windio_beam(p, "tower"),
    ):
        try:
            read(path)
        except PitchpointError as error:
            assert len(str(error)) > 20
