# SPDX-License-Identifier: Apache-2.0
"""Contact in motion against closed forms: bouncing, rolling and slipping, cams, triangles that get finer."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from pitchpoint.contact.curve import circle
from pitchpoint.contact.impact import set_friction, set_impact, set_restitution
from pitchpoint.contact.triangles import TriangleSurface
from pitchpoint.core.status import OK
from pitchpoint.elements import drive
from pitchpoint.elements.contacts.record import new_records, set_marker
from pitchpoint.elements.force import RECORD as FORCE
from pitchpoint.elements.point_curve import set_cam
from pitchpoint.elements.point_surface import set_mesh, set_surface
from pitchpoint.elements.signal import Pool
from pitchpoint.elements.surface_surface import (
    set_cylinder_on_plane,
    set_cylinders_in_line,
    set_mesh_on_shape,
    set_meshes,
)
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.solid import gear_solid
from pitchpoint.model.components.contact import ContactLaw
from pitchpoint.multibody.bodies import TORSION, Body
from pitchpoint.multibody.joints import FLOATING, PRISMATIC
from pitchpoint.solvers.explicit import runge_kutta
from pitchpoint.solvers.implicit import generalized_alpha
from pitchpoint.system import evaluate
from pitchpoint.system.system import assemble
from tests.support.contacts import ball as ball_of
from tests.support.contacts import box, read
from tests.support.engine import frame

WEIGHT = 9.81
ball = cache(ball_of)


@pytest.fixture(scope="module", autouse=True)
def packed_once():
    """Surfaces are packed once for all contacts that use them, which copy them: half a second for each."""
    packed, done = TriangleSurface.packed, {}

    def kept(surface):
        if id(surface) not in done:
            done[id(surface)] = surface, packed(surface)
        return done[id(surface)][1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(TriangleSurface, "packed", kept)
        yield


def one_contact(kind, bodies, setup, more=None, constraints=None):
    """System of one contact, the first body against ground (or whatever `setup` says)."""
    pool, records = Pool(), new_records(1)
    records["i"] = 1
    setup(records[0], pool)
    return assemble(bodies, {kind: records, **(more or {})}, constraints, pools={kind: pool.array()})


def weights(*rows):
    """Weights from rows (body, force vector)."""
    records = np.zeros(len(rows), FORCE)
    for record, (i, force) in zip(records, rows, strict=True):
        record["i"], record["value"], record["F"][:3] = i, 1.0, force
    return {"force": records}


def dropped(law, speed, step=1e-6, n=3000):
    """Ratio of the speeds of a ball thrown at a plane, its events, and the state after it."""

    def setup(record, pool):
        set_surface(record, "plane", (), 0.02)
        law(record)

    body = Body(motion=PRISMATIC, position=(0.0, 0.0, 0.02), mass=0.3, polar_inertia=1e-4, name="ball")
    system = one_contact("point_surface", [body], setup)
    state = system.initial_state()
    state.q[0], state.v[0] = 1e-5, -speed
    run = runge_kutta.start_classical(system, state, step)
    chunk = run.advance(n, events=16)
    assert chunk.status == OK
    return run.state().v[0] / speed, chunk.events


@pytest.mark.parametrize("e", [0.1, 0.5, 0.9, 1.0])
def test_a_ball_bounces_in_the_engine(e):
    """RK4 at 1e-6 s through an impact of about 1 ms, whose ends are kinks: 1e-5."""
    found, events = dropped(lambda r: set_restitution(r, 1e8, e, 1.0), 1.0)
    assert found == pytest.approx(e, abs=1e-5)
    assert [int(row[2]) for row in events] == [-1, 1]  # the gap closes, then opens
    assert events[0][0] == pytest.approx(1e-5, rel=1e-6)


@pytest.mark.parametrize("speed", [0.3, 3.0])
def test_hysteresis_in_the_engine(speed):
    found, _ = dropped(lambda r: set_restitution(r, 1e8, 0.6, 1e-3, every_speed=True), speed)
    assert found == pytest.approx(0.6, abs=1e-3)


def solid_ball(radius, mass, position):
    return Body(
        motion=FLOATING,
        position=position,
        mass=mass,
        inertia=0.4 * mass * radius**2 * np.eye(3),
        name="ball",
    )


@pytest.mark.parametrize(("slope", "mu"), [(0.2, 0.1), (0.3, 0.09), (0.3, 0.05), (0.9, 0.5), (0.9, 0.3)])
def test_a_ball_rolls_down_an_incline_inside_the_friction_cone(slope, mu):
    """tan(slope) < 7/2 mu: rolls with 5/7 g sin; else it slips with g (sin - mu cos).

    Downhill is the x axis of the plane; sticking friction creeps at a constant speed, which does not show in
    the acceleration. 1e-3 for what is left of the start.
    """
    radius, mass, K = 0.05, 0.8, 1e6
    c, s = math.cos(slope), math.sin(slope)
    plane = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])  # z axis leans towards +x
    depth = mass * WEIGHT * c / K

    def setup(record, pool):
        set_surface(record, "plane", (), radius)
        set_marker(record, "j", (0, 0, 0), plane)
        set_impact(record, K, 1.0, 200.0, 1e-7)
        set_friction(record, mu, mu, 1e-4, 2e-4)

    body = solid_ball(radius, mass, (radius - depth) * plane[:, 2])
    system = one_contact("point_surface", [body], setup, weights((1, (0, 0, -mass * WEIGHT))))
    run = generalized_alpha.start(system, system.initial_state(), 1e-4, rho_inf=0.5)
    assert run.advance(2000).status == OK
    before = run.state()
    assert run.advance(2000).status == OK
    after = run.state()
    found = (after.v[:3] - before.v[:3]) @ plane[:, 0] / (after.t - before.t)
    rolls = math.tan(slope) < 3.5 * mu
    wanted = 5.0 / 7.0 * WEIGHT * s if rolls else WEIGHT * (s - mu * c)
    assert found == pytest.approx(wanted, rel=1e-3)
    evaluate.residual(system, after)
    turning = system.workspace.fr[1]["tw"][4] * radius
    slip = after.v[:3] @ plane[:, 0] - turning
    assert (slip < 1e-4) == rolls


@pytest.mark.parametrize("shape", ["bore", "groove"])
def test_a_ball_rolls_to_and_fro_in_a_hollow(shape):
    """Rolling without slip across a hollow of radius a: omega^2 = 5 g/(7 (a - r)), period + 1/16 swing^2."""
    radius, mass, a, swing, K = 0.01, 0.1, 0.06, 0.1, 1e6
    arm = a - radius

    def setup(record, pool):
        if shape == "bore":  # cylinder along y
            set_surface(record, "cylinder", a, radius, hollow=True)
            set_marker(record, "j", (0, 0, 0), [[0, 1, 0], [0, 0, 1], [1, 0, 0]])
        else:
            set_surface(record, "torus", (0.5, a), radius, hollow=True)
            set_marker(record, "j", (-0.5, 0, 0))
        set_impact(record, K, 1.0, 50.0, 1e-8)
        set_friction(record, 0.8, 0.8, 1e-4, 2e-4)

    depth = mass * WEIGHT / K
    position = np.array([math.sin(swing), 0.0, -math.cos(swing)]) * (arm + depth)
    system = one_contact(
        "point_surface", [solid_ball(radius, mass, position)], setup, weights((1, (0, 0, -mass * WEIGHT)))
    )
    omega = math.sqrt(5.0 * WEIGHT / (7.0 * arm))
    period = 2.0 * math.pi / omega * (1.0 + swing**2 / 16.0)
    run = generalized_alpha.start(system, system.initial_state(), period / 4000, rho_inf=0.8)
    places = []
    for _ in range(4000):
        assert run.advance(1).status == OK
        places.append(position[0] + run.state().q[0])
    x = np.array(places)
    down, up = np.flatnonzero(np.diff(np.sign(x)))
    # two quarters of a swing from one end to the other; creep of the friction loses less than 1e-3
    assert (up - down) / 4000 == pytest.approx(0.5, abs=1e-3)
    assert x[-1] == pytest.approx(position[0], rel=5e-3)


def test_follower_on_an_eccentric_cam_parts_where_it_weighs_nothing():
    """The contact force follows m (y'' + g)/cos b, and vanishes where the closed form changes its sign."""
    e, radius, roller, mass, omega = 0.01, 0.03, 0.008, 0.7, 40.0
    reach = radius + roller
    upward = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])  # third axis along y
    bodies = [
        Body(motion=PRISMATIC, position=(0, e + reach, 0), axes=upward, mass=mass, name="follower"),
        Body(motion=TORSION, polar_inertia=0.01, name="cam"),
    ]

    def setup(record, pool):
        record["j"] = 2
        set_cam(record, pool, circle(radius, (0.0, e)), roller)
        set_impact(record, 1e9, 1.0, 2e4, 1e-9)

    drives = np.zeros(1, drive.RECORD)
    drives["i"], drives["speed"], drives["angle"] = 2, omega, 1.2
    system = one_contact(
        "point_curve", bodies, setup, weights((1, (0, -mass * WEIGHT, 0))), {"drive": drives}
    )

    def force(a):
        root = math.sqrt(reach**2 - (e * math.sin(a)) ** 2)
        bend = -e * math.cos(a) - e**2 * math.cos(2 * a) / root - e**4 * math.sin(2 * a) ** 2 / (4 * root**3)
        return mass * (bend * omega**2 + WEIGHT) * reach / root

    assert force(0.0) < 0.0 < force(1.2)  # would have to pull near the top
    a = 1.2
    root = math.sqrt(reach**2 - (e * math.sin(a)) ** 2)
    state = system.initial_state()
    state.q[:] = e * math.cos(a) + root - e - reach - force(a) * reach / root / 1e9, a
    state.v[:] = (-e * math.sin(a) - e**2 * math.sin(2 * a) / (2 * root)) * omega, omega
    run = generalized_alpha.start(system, state, 1e-5, rho_inf=0.5)
    parted = None
    for _ in range(1100):
        assert run.advance(10).status == OK
        now = run.state()
        a = now.q[1] + 2 * math.pi * now.turns[2]
        found = read(system, now, "contact_force[point_curve0]")
        if found == 0.0:
            parted = a
            break
        assert found == pytest.approx(force(a), rel=2e-3, abs=0.02)
    assert parted is not None
    end = math.acos(math.cos(parted))
    assert force(end) == pytest.approx(0.0, abs=0.05)


def test_a_line_of_contact_has_the_moment_of_a_line():
    """A cylinder tilted along its length: N = K d and M = K tan(t) L^2/12, exactly, for a linear law."""
    K, length, radius, tilt = 1e7, 0.08, 0.05, 1e-3

    def setup(record, pool):
        set_cylinder_on_plane(record, radius, length, 2)
        set_marker(record, "i", (0, 0, 0), [[0, 0, 1], [1, 0, 0], [0, 1, 0]])  # along x
        set_impact(record, K, 1.0)

    depth = 1e-4
    c, s = math.cos(tilt), math.sin(tilt)
    axes = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    body = Body(
        motion=FLOATING, position=(0, 0, radius * c - depth), axes=axes, mass=1.0, inertia=np.eye(3), name="a"
    )
    system = one_contact("surface_surface", [body], setup)
    evaluate.residual(system, system.initial_state())
    F = system.workspace.fr[1]["F"]
    assert F[2] == pytest.approx(K * depth, rel=1e-12)
    # about the centre of the cylinder, whose lowest line lies radius sin(t) beside it
    assert F[4] == pytest.approx(-(K * s * c * length**2 / 12.0 - K * depth * radius * s), rel=1e-9)


def test_spheres_of_triangles_converge_to_the_sphere():
    """Gap of a ball over facets: the error falls by four with every cut."""
    error = []
    direction = np.array([0.3, 0.5, 0.81])
    direction /= np.linalg.norm(direction)
    for times in (2, 3, 4):

        def setup(record, pool, times=times):
            set_mesh(record, pool, ball(0.05, times), 0.02, depth=0.02)
            set_impact(record, 1e6, 1.5)

        gaps = []
        for angle in np.linspace(0.0, 2.0, 6):  # here and there over the facets
            c, s = math.cos(angle), math.sin(angle)
            turned = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ direction
            system = one_contact("point_surface", [solid_ball(0.02, 1.0, 0.069 * turned)], setup)
            gaps.append(read(system, system.initial_state(), "gap[point_surface0]") + 0.001)
        error.append(max(abs(g) for g in gaps))
    assert error[2] < 5e-5
    assert error[0] / error[1] == pytest.approx(4.0, abs=1.5)
    assert error[1] / error[2] == pytest.approx(4.0, abs=1.5)


@pytest.mark.study
def test_triangles_on_triangles_converge_to_a_layer_of_springs():
    """A ball of radius R pressed into a box by d: N = pi k R d^2 (1 - d/(3 R)) to first order in d/R.

    Pressing by the vertical overlap of the plane gives pi k (R d^2 - d^3/3); the radial overlap of the nodes
    of the box differs by terms of the order d/R = 0.04, half of which counts.
    """
    R, d, k = 0.05, 0.002, 1e11
    wanted = math.pi * k * R * d * d
    found = []
    # the ball touches 28 mm of the box
    for times, cuts in ((3, 10), (4, 20), (5, 40)):

        def setup(record, pool, times=times, cuts=cuts):
            set_meshes(record, pool, (ball(R, times), box((0.04, 0.04, 0.02), cuts)), 0.005)
            set_marker(record, "j", (0.0003, 0.0002, -0.01))
            set_impact(record, k, 1.0)

        system = one_contact("surface_surface", [solid_ball(R, 1.0, (0, 0, R - d))], setup)
        found.append(read(system, system.initial_state(), "contact_force[surface_surface0]") / wanted)
    assert abs(found[2] - found[1]) < abs(found[1] - found[0])
    assert found[2] == pytest.approx(1.0, abs=0.03)


def drum(radius, length, around, along):
    """Cylinder of triangles about its third axis, with flat ends."""
    angle = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)
    ring = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    z = np.linspace(-0.5 * length, 0.5 * length, along + 1)
    found = []
    for k in range(around):
        a, b = ring[k], ring[(k + 1) % around]
        found += [[(0, 0, z[-1]), (*a, z[-1]), (*b, z[-1])], [(0, 0, z[0]), (*b, z[0]), (*a, z[0])]]
        for low, high in zip(z[:-1], z[1:], strict=True):
            found += [[(*a, low), (*b, low), (*b, high)], [(*a, low), (*b, high), (*a, high)]]
    return TriangleSurface.from_triangles(np.array(found))


#: A layer of springs k under a body is a place or line of contact: shape and law per area -> its law.
#: A ball of radius R on a plane: pi k R u^2; in a cup of radius C the same with 1/R - 1/C, to first order in
#: u/(C - R); a drum on a plane: 4/3 k L sqrt(2 R) u^1.5.
LAYERS = ["ball on plane", "ball in cup", "ball on ball", "drum on plane", "drum in tube"]


@pytest.mark.parametrize("name", LAYERS)
def test_triangles_on_simple_shapes_converge_to_the_pair_of_shapes(name):
    """Error against the pair of exact shapes over three refinements: it falls with the square of the size.

    The mean over eight places and turns, of facets up or down. What is left at the end are the terms of the
    next order, u/(2 R) of the overlap and less than 1 %.
    """
    R, L, u, k = 0.05, 0.04, 2e-3, 1e11
    rng = np.random.default_rng(6)
    turns = [frame(rng) for _ in range(8)]
    if name.startswith("drum"):
        turns = []
        for a in np.linspace(0.0, 0.4, 8):
            c, s = np.cos(a), np.sin(a)
            turns.append(np.array([[0, 0, 1], [c, -s, 0], [s, c, 0]]))  # axis along x
    other = {"ball on plane": 0.0, "ball in cup": 0.2, "ball on ball": 0.1, "drum on plane": 0.0}.get(
        name, 0.2
    )

    def system_of(kind, setup, at, axes):
        body = Body(motion=FLOATING, position=at, mass=1.0, inertia=np.eye(3), name="a")
        return one_contact(kind, [body], lambda r, p: (setup(r, p), set_marker(r, "i", (0, 0, 0), axes)))

    hollow = name in ("ball in cup", "drum in tube")
    height = R - u if not other else (other - R + u if hollow else other + R - u)
    at = np.array([0.0, 0.0, -height if hollow else height])
    across = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]  # third axis along x

    def exact(record, pool):
        if name.startswith("ball"):
            form, size = ("sphere", (other,)) if other else ("plane", ())
            curvature = 1.0 / R + (0.0 if not other else (-1.0 if hollow else 1.0) / other)
            set_surface(record, form, size, R, hollow)
            set_impact(record, math.pi * k / curvature, 2.0)
            return
        curvature = 1.0 / R - (1.0 / other if other else 0.0)
        if other:
            set_cylinders_in_line(record, (R, other), (L, 2 * L), True)
            set_marker(record, "j", (0, 0, 0), across)
        else:
            set_cylinder_on_plane(record, R, L)
        set_impact(record, 4.0 / 3.0 * k * L * math.sqrt(2.0 / curvature), 1.5)

    kind = "point_surface" if name.startswith("ball") else "surface_surface"
    system = system_of(kind, exact, at, across)
    wanted = read(system, system.initial_state(), f"contact_force[{kind}0]")
    error = []
    for level in (3, 4, 5):
        surface = ball(R, level) if name.startswith("ball") else drum(R, L, 16 * 2**level, 4)

        def meshed(record, pool, surface=surface):
            form = "plane" if not other else ("sphere" if name.startswith("ball") else "cylinder")
            size = () if not other else ((other,) if name.startswith("ball") else (other, 2 * L))
            set_mesh_on_shape(record, pool, surface, form, size, hollow)
            if name == "drum in tube":
                set_marker(record, "j", (0, 0, 0), across)
            set_impact(record, k, 1.0)

        system = system_of("surface_surface", meshed, at, np.eye(3))
        found = []
        for axes in turns:
            system.records["surface_surface"]["Bi"] = axes
            found.append(read(system, system.initial_state(), "contact_force[surface_surface0]"))
        error.append(np.mean(found) / wanted - 1.0)
    # differences of refinements free of what is left at the end
    assert (error[0] - error[1]) / (error[1] - error[2]) == pytest.approx(4.0, abs=1.0)
    assert abs(error[2]) < 0.03


def line_force(gears, distance, at, x, k):
    """Normal force of all tooth pairs from one place of contact, `at` from T1 on the line of action."""
    r1, r2 = (0.5 * g.d_b for g in gears)
    line = math.sqrt(distance**2 - (r1 + r2) ** 2)
    start = line - math.sqrt((0.5 * gears[1].d_a) ** 2 - r2**2)
    end = math.sqrt((0.5 * gears[0].d_a) ** 2 - r1**2)
    pitch = 2.0 * math.pi * r1 / gears[0].z
    force = 0.0
    for pair in range(-3, 4):
        rho = at + pair * pitch
        if start < rho < end:
            half = math.sqrt(2.0 * x * rho * (line - rho) / line)
            # a tip in contact ends the strip
            low, high = max(-half, start - rho), min(half, end - rho)
            curved = (high**3 - low**3) / (3.0 * half**2)
            force += k * min(g.b for g in gears) * x * (high - low - curved)
    return force


@pytest.mark.study
def test_gears_of_triangles_press_along_the_line_of_action():
    """Against the analytic line of action: directions, torques, and the force of a pressed layer of springs.

    Flanks turned into each other by x along the base tangent overlap by x - s^2/(2 R) at the distance s from
    the line of contact: 4/3 k b x sqrt(2 R x) per pair. Of 60 points to a flank, 12 to 20 lie in that strip.
    """
    gears = [CylindricalGear(z=z, m_n=3e-3, b=b) for z, b in ((20, 0.008), (31, 0.012))]
    distance = 0.5 * (gears[0].d + gears[1].d)
    k, x = 1e14, 30e-6
    surfaces = [
        TriangleSurface.from_triangles(gear_solid(g, 60, n)) for g, n in zip(gears, (4, 6), strict=True)
    ]

    def setup(record, pool):
        record["j"] = 2
        set_meshes(record, pool, surfaces, 2e-4)
        set_impact(record, k, 1.0)

    bodies = [
        Body(polar_inertia=1.0, name="pinion"),
        Body(polar_inertia=1.0, position=(distance, 0, 0), name="wheel"),
    ]
    system = one_contact("surface_surface", bodies, setup)
    r1, r2 = (0.5 * g.d_b for g in gears)
    line = math.sqrt(distance**2 - (r1 + r2) ** 2)
    ratio, forces = [], []
    for phase in (0.05, 0.12, 0.2):
        state = system.initial_state()
        # tooth 0 of the pinion in the middle of a space (odd number of teeth), then turned by x/r1
        state.q[:] = phase + x / r1, -phase * r1 / r2
        evaluate.residual(system, state)
        torque = [system.workspace.fr[b]["F"][5] for b in (1, 2)]
        ratio.append(torque[1] / torque[0] * r1 / r2)
        normal = read(system, state, "contact_force[surface_surface0]")
        assert abs(torque[0]) / r1 == pytest.approx(normal, rel=5e-3)
        place = [read(system, state, f"contact_location[surface_surface0.{c}]") for c in "xy"]
        at = line - math.sqrt(place[0] ** 2 + place[1] ** 2 - r2**2)
        forces.append(normal / line_force(gears, distance, at, x, k))
    assert ratio == pytest.approx([1.0] * 3, abs=5e-3)
    assert forces == pytest.approx([1.0] * 3, abs=3e-2)


@pytest.mark.parametrize("speed", [0.3, 1.0])
def test_a_restitution_for_every_speed_needs_no_speed(speed):
    """As a user writes it in a file; the transition takes (v/speed)^2 of the energy, v = 1 mm/s."""
    law = ContactLaw(force=100.0, depth=1e-4, exponent=1.0, restitution=0.6, every_speed=True)
    v = law.reference_speed
    found, _ = dropped(lambda r: set_restitution(r, 1e8, 0.6, v, every_speed=True), speed)
    assert found == pytest.approx(0.6, abs=1e-3)
