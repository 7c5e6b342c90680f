# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The reference itself: its algebra against matrices, its frames and signs against publications."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
from reference_rhythm import (
    HUMEROTHORACIC_SEQUENCE,
    JOINT_SEQUENCES,
    ST_SEQUENCE,
    Array,
    Interpolation,
    Position,
    ReferenceRhythm,
    align_signs,
    axis_rotation,
    bracket,
    elevation_and_plane_deg,
    euler_from_quaternion,
    exp,
    inner_quaternion,
    interpolate,
    inverse,
    log,
    matrix,
    multiply,
    normalized,
    quaternion_from_euler,
    rotation_angle_deg,
    slerp,
    squad,
)

SEED = 20090201
SAMPLES = 200

# A few dozen roundings of numbers of size one, with room.
ROUNDING = 1e-13
# The same in degrees of an angle.
ROUNDING_DEG = 1e-11
# Figures printed to so many digits: half of the last one, and rounding.
WHOLE = 0.5 + 1e-9
TENTH = 0.05 + 1e-9
HUNDREDTH = 0.005 + 1e-9
# Printed to whole degrees by way of tenths: 39.46 stands there as 40.
WHOLE_ROUNDED_TWICE = WHOLE + TENTH


def random_rotation(random: np.random.Generator) -> Array:
    return normalized(random.normal(size=4))


def random_series(random: np.random.Generator, knots: int) -> list[Array]:
    """Knots up to about 60 deg apart, signs aligned."""
    series = [random_rotation(random)]
    while len(series) < knots:
        series.append(multiply(series[-1], exp(random.uniform(-0.3, 0.3, size=3))))
    return series


def elementary_matrix(axis: str, angle_deg: float) -> Array:
    c, s = math.cos(math.radians(angle_deg)), math.sin(math.radians(angle_deg))
    return np.array(
        {
            "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
            "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
            "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
        }[axis]
    )


# --- Quaternions ---------------------------------------------------------------------------------


@pytest.mark.parametrize("axis", "xyz")
def test_a_turn_about_an_axis_is_its_elementary_matrix(axis: str) -> None:
    for angle_deg in np.random.default_rng(SEED).uniform(-180.0, 180.0, SAMPLES):
        difference = matrix(axis_rotation(axis, angle_deg)) - elementary_matrix(axis, angle_deg)
        assert np.abs(difference).max() < ROUNDING, angle_deg


def test_the_product_is_the_product_of_the_matrices() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        a, b = random_rotation(random), random_rotation(random)
        difference = matrix(multiply(a, b)) - matrix(a) @ matrix(b)
        assert np.abs(difference).max() < ROUNDING, (a, b)


def test_the_inverse_is_the_transposed_matrix() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        q = random_rotation(random)
        assert np.abs(matrix(inverse(q)) - matrix(q).T).max() < ROUNDING, q


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-8, 1e-3, 1.0, 3.0])
def test_log_is_the_inverse_of_exp(size: float) -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        direction = random.normal(size=3)
        vector = size * direction / np.linalg.norm(direction)
        assert np.abs(log(exp(vector)) - vector).max() < ROUNDING, vector


def test_exp_is_the_inverse_of_log() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        q = random_rotation(random)
        assert np.abs(exp(log(q)) - q).max() < ROUNDING, q


def test_log_is_half_the_rotation_vector() -> None:
    expected = [0.0, math.radians(35.0), 0.0]
    assert log(axis_rotation("y", 70.0)) == pytest.approx(expected, abs=ROUNDING)


def test_the_angle_between_rotations_does_not_see_their_signs() -> None:
    a = axis_rotation("x", 10.0)
    b = multiply(a, axis_rotation("z", 30.0))
    for sign_a, sign_b in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        assert rotation_angle_deg(sign_a * a, sign_b * b) == pytest.approx(30.0, abs=ROUNDING_DEG)


# --- Euler angles --------------------------------------------------------------------------------


@pytest.mark.parametrize("sequence", ["yxz", "xzy", "yxy"])
def test_an_euler_sequence_is_the_product_of_its_matrices_from_left_to_right(sequence: str) -> None:
    for angles_deg in np.random.default_rng(SEED).uniform(-180.0, 180.0, (SAMPLES, 3)):
        first, second, third = map(elementary_matrix, sequence, angles_deg)
        difference = matrix(quaternion_from_euler(sequence, angles_deg)) - first @ second @ third
        assert np.abs(difference).max() < ROUNDING, angles_deg


@pytest.mark.parametrize(
    ("sequence", "second_deg"),
    [("yxz", (-85.0, 85.0)), ("xzy", (-85.0, 85.0)), ("yxy", (-175.0, -5.0))],
)
def test_euler_angles_survive_the_way_there_and_back(sequence: str, second_deg: tuple[float, float]) -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        angles_deg = (
            random.uniform(-179.0, 179.0),
            random.uniform(*second_deg),
            random.uniform(-179.0, 179.0),
        )
        q = quaternion_from_euler(sequence, angles_deg)
        back_deg = euler_from_quaternion(sequence, q)
        # Five degrees from the pole the outer angles are a dozen times less certain.
        assert back_deg == pytest.approx(angles_deg, abs=20.0 * ROUNDING_DEG), angles_deg


@pytest.mark.parametrize(
    ("elevation_deg", "plane_deg", "towards"),
    [
        (0.0, 0.0, (0.0, -1.0, 0.0)),
        (90.0, 0.0, (0.0, 0.0, 1.0)),
        (90.0, 90.0, (1.0, 0.0, 0.0)),
        (180.0, 0.0, (0.0, 1.0, 0.0)),
    ],
)
def test_the_arm_hangs_down_abducts_to_the_right_and_flexes_forward(
    elevation_deg: float, plane_deg: float, towards: tuple[float, float, float]
) -> None:
    q_TH = quaternion_from_euler(HUMEROTHORACIC_SEQUENCE, (plane_deg, -elevation_deg, 25.0))
    from_shoulder_to_elbow = -matrix(q_TH)[:, 1]
    assert from_shoulder_to_elbow == pytest.approx(towards, abs=ROUNDING)


# --- Interpolation -------------------------------------------------------------------------------


def test_slerp_turns_at_a_constant_rate() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        a, b = random_series(random, 2)
        t = random.uniform()
        expected = multiply(a, exp(t * log(multiply(inverse(a), b))))
        assert np.abs(slerp(a, b, t) - expected).max() < ROUNDING, (a, b, t)


@pytest.mark.parametrize("angle_deg", [0.0, 1e-9, 1e-6])
def test_slerp_of_close_rotations_stays_a_rotation(angle_deg: float) -> None:
    a = axis_rotation("x", 40.0)
    b = multiply(a, axis_rotation("y", angle_deg))
    assert np.linalg.norm(slerp(a, b, 0.3)) == pytest.approx(1.0, abs=ROUNDING)


def test_the_inner_quaternion_of_an_even_turn_is_the_knot() -> None:
    knots = [axis_rotation("z", angle_deg) for angle_deg in (10.0, 30.0, 50.0)]
    assert np.abs(inner_quaternion(knots, 1) - knots[1]).max() < ROUNDING


def test_the_inner_quaternions_of_the_ends_are_the_ends() -> None:
    knots = random_series(np.random.default_rng(SEED), 4)
    assert np.array_equal(inner_quaternion(knots, 0), knots[0])
    assert np.array_equal(inner_quaternion(knots, 3), knots[3])
    assert not np.array_equal(inner_quaternion(knots, 1), knots[1])


def test_squad_about_one_axis_is_equations_4_and_5_on_the_angle() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        a = np.cumsum(random.uniform(-60.0, 60.0, size=4))
        t = random.uniform()
        s1 = a[1] - ((a[2] - a[1]) + (a[0] - a[1])) / 4.0
        s2 = a[2] - ((a[3] - a[2]) + (a[1] - a[2])) / 4.0
        outer, inner = (1.0 - t) * a[1] + t * a[2], (1.0 - t) * s1 + t * s2
        h = 2.0 * t * (1.0 - t)
        q = interpolate([axis_rotation("y", angle_deg) for angle_deg in a], 1, t, "squad")
        expected = axis_rotation("y", (1.0 - h) * outer + h * inner)
        assert rotation_angle_deg(q, expected) < ROUNDING_DEG, (a, t)


def test_squad_of_two_knots_is_slerp() -> None:
    knots = random_series(np.random.default_rng(SEED), 2)
    for t in np.linspace(0.0, 1.0, 11):
        difference = interpolate(knots, 0, t, "squad") - interpolate(knots, 0, t, "slerp")
        assert np.abs(difference).max() < ROUNDING, t


def test_squad_passes_through_its_knots() -> None:
    q, q1, s, s1 = random_series(np.random.default_rng(SEED), 4)
    assert np.abs(squad(q, q1, s, s1, 0.0) - q).max() < ROUNDING
    assert np.abs(squad(q, q1, s, s1, 1.0) - q1).max() < ROUNDING


def test_turning_all_knots_turns_the_curve() -> None:
    random = np.random.default_rng(SEED)
    for _ in range(SAMPLES):
        knots, turn, t = random_series(random, 4), random_rotation(random), random.uniform()
        turned = interpolate([multiply(turn, q) for q in knots], 1, t, "squad")
        expected = multiply(turn, interpolate(knots, 1, t, "squad"))
        assert np.abs(turned - expected).max() < ROUNDING, (knots, turn, t)


def test_signs_align_along_both_directions_of_the_grid(reference: ReferenceRhythm) -> None:
    random = np.random.default_rng(SEED)
    for joint, grid in reference.grids.items():
        flipped = [[q * random.choice((-1.0, 1.0)) for q in plane] for plane in grid]
        aligned = np.array(align_signs(flipped))
        assert np.array_equal(aligned * np.sign(aligned[0, 0] @ grid[0][0]), np.array(grid)), joint
        assert (np.sum(aligned[:, 1:] * aligned[:, :-1], axis=-1) > 0.0).all(), joint
        assert (np.sum(aligned[1:] * aligned[:-1], axis=-1) > 0.0).all(), joint


# --- The database --------------------------------------------------------------------------------


def test_the_database_is_22_elevations_in_3_planes(database: list[Position]) -> None:
    places = {(p.plane_deg, p.elevation_deg) for p in database}
    grid = {(plane, elevation) for plane in (0, 40, 90) for elevation in range(15, 121, 5)}
    assert len(database) == 66
    assert places == grid


def test_sc_times_ac_differs_from_the_published_st_by_2_degrees(database: list[Position]) -> None:
    differences_deg = np.array(
        [
            rotation_angle_deg(
                multiply(p.rotation("sc"), p.rotation("ac")),
                quaternion_from_euler(ST_SEQUENCE, p.st_angles_deg),
            )
            for p in database
        ]
    )
    rms_deg = math.sqrt(np.mean(differences_deg**2))
    assert rms_deg == pytest.approx(2.03, abs=HUNDREDTH)
    assert differences_deg.min() == pytest.approx(1.7, abs=TENTH)
    assert differences_deg.max() == pytest.approx(2.5, abs=TENTH)


def test_sc_ac_gh_has_its_nominal_elevation(database: list[Position]) -> None:
    errors_deg = [
        elevation_and_plane_deg(multiply(multiply(p.rotation("sc"), p.rotation("ac")), p.rotation("gh")))[0]
        - p.elevation_deg
        for p in database
    ]
    assert min(errors_deg) == pytest.approx(-1.7, abs=TENTH)
    assert max(errors_deg) == pytest.approx(1.3, abs=TENTH)


# Planes (deg) that the table's arm is in at elevations 30, 60, 90 and 120.
DRIFT_ELEVATIONS_DEG = (30.0, 60.0, 90.0, 120.0)
DRIFT_OF_SC_AC_GH = [
    (0.0, (-7, 4, 10, 19)),
    (40.0, (27, 38, 41, 41)),
    (90.0, (68, 74, 75, 67)),
]
DRIFT_OF_ST_GH = [
    (0.0, (-6, 5, 12, 22)),
    (40.0, (29, 40, 43, 43)),
    (90.0, (70, 76, 77, 70)),
]


def planes_reached_deg(
    database: list[Position], plane_deg: float, q_TS: Callable[[Position], Array]
) -> list[float]:
    rows = {p.elevation_deg: p for p in database if p.plane_deg == plane_deg}
    return [
        elevation_and_plane_deg(multiply(q_TS(rows[theta]), rows[theta].rotation("gh")))[1]
        for theta in DRIFT_ELEVATIONS_DEG
    ]


@pytest.mark.parametrize(("plane_deg", "published"), DRIFT_OF_SC_AC_GH)
def test_sc_ac_gh_drifts_from_its_plane_as_published(
    database: list[Position], plane_deg: float, published: tuple[int, ...]
) -> None:
    reached = planes_reached_deg(database, plane_deg, lambda p: multiply(p.rotation("sc"), p.rotation("ac")))
    assert reached == pytest.approx(published, abs=WHOLE)


@pytest.mark.parametrize(("plane_deg", "published"), DRIFT_OF_ST_GH)
def test_st_gh_drifts_from_its_plane_as_published(
    database: list[Position], plane_deg: float, published: tuple[int, ...]
) -> None:
    reached = planes_reached_deg(
        database, plane_deg, lambda p: quaternion_from_euler(ST_SEQUENCE, p.st_angles_deg)
    )
    assert reached == pytest.approx(published, abs=WHOLE_ROUNDED_TWICE)


# --- Inverse kinematics --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "index", "weight"),
    [(15.0, 0, 0.0), (17.0, 0, 0.4), (20.0, 0, 1.0), (21.0, 1, 0.2), (30.0, 2, 1.0)],
)
def test_a_cell_holds_its_upper_edge_and_the_first_cell_its_lower_one_too(
    value: float, index: int, weight: float
) -> None:
    found = bracket([15.0, 20.0, 25.0, 30.0], value)
    assert found.index == index
    assert found.weight == pytest.approx(weight, abs=ROUNDING)


def test_the_papers_example_lies_in_its_cell(reference: ReferenceRhythm) -> None:
    pose = reference.solve(23.0, 50.0)
    assert reference.elevations_deg[pose.elevation.index] == 20.0
    assert reference.planes_deg[pose.plane.index] == 40.0
    assert pose.elevation.weight == pytest.approx(3 / 5, abs=ROUNDING)
    assert pose.plane.weight == pytest.approx(10 / 50, abs=ROUNDING)


@pytest.mark.parametrize("interpolation", ["squad", "slerp"])
def test_the_table_is_reproduced(
    reference: ReferenceRhythm, database: list[Position], interpolation: Interpolation
) -> None:
    for p in database:
        pose = reference.solve(p.elevation_deg, p.plane_deg, interpolation)
        assert not pose.clamped
        assert pose.angles_deg == pytest.approx(p.angles_deg(), abs=10.0 * ROUNDING_DEG), p


@pytest.mark.parametrize(
    ("outside", "nearest"),
    [
        ((14.9, 50.0), (15.0, 50.0)),
        ((120.1, 50.0), (120.0, 50.0)),
        ((60.0, -0.1), (60.0, 0.0)),
        ((60.0, 90.1), (60.0, 90.0)),
        ((200.0, -80.0), (120.0, 0.0)),
    ],
)
def test_outside_the_domain_the_nearest_point_answers_and_says_so(
    reference: ReferenceRhythm, outside: tuple[float, float], nearest: tuple[float, float]
) -> None:
    pose, nearest_pose = reference.solve(*outside), reference.solve(*nearest)
    assert pose.angles_deg == nearest_pose.angles_deg
    assert pose.clamped
    assert not nearest_pose.clamped


@pytest.mark.parametrize("joint", JOINT_SEQUENCES)
def test_squad_and_slerp_differ_between_the_knots(reference: ReferenceRhythm, joint: str) -> None:
    """Otherwise the program could take one for the other and still agree."""
    apart_deg = rotation_angle_deg(
        reference.solve(22.5, 20.0, "squad").rotations[joint],
        reference.solve(22.5, 20.0, "slerp").rotations[joint],
    )
    assert apart_deg > 0.01


# Jumps of angular velocity, measured once with another prototype, in deg per deg.


def velocity_jump(curve: Callable[[float], Array], x: float) -> float:
    """One-sided differences of second order, whose error is far below the figures compared."""
    h = 1e-4

    def velocity(step: float) -> Array:
        near, far = (2.0 * np.degrees(log(multiply(inverse(curve(x)), curve(x + k * step)))) for k in (1, 2))
        return (4.0 * near - far) / (2.0 * step)

    return float(np.linalg.norm(velocity(h) - velocity(-h)))


def largest_jump_over_theta(reference: ReferenceRhythm, joint: str, interpolation: Interpolation) -> float:
    def jump(knot: float, psi: float) -> float:
        return velocity_jump(lambda theta: reference.solve(theta, psi, interpolation).rotations[joint], knot)

    planes_deg = (0.0, 20.0, 40.0, 65.0, 90.0)
    return max(jump(knot, psi) for knot in reference.elevations_deg[1:-1] for psi in planes_deg)


@pytest.mark.parametrize("joint", JOINT_SEQUENCES)
def test_squad_is_smooth_over_elevation(reference: ReferenceRhythm, joint: str) -> None:
    assert largest_jump_over_theta(reference, joint, "squad") < 1e-4


def test_slerp_jumps_over_elevation(reference: ReferenceRhythm) -> None:
    jump = largest_jump_over_theta(reference, "sc", "slerp")
    assert jump == pytest.approx(0.36, abs=HUNDREDTH)


@pytest.mark.parametrize(("joint", "jump"), [("sc", 0.04), ("gh", 0.13)])
def test_squad_as_published_jumps_over_the_scapular_plane(
    reference: ReferenceRhythm, joint: str, jump: float
) -> None:
    def jump_at(theta: float) -> float:
        return velocity_jump(lambda psi: reference.solve(theta, psi).rotations[joint], 40.0)

    largest = max(map(jump_at, reference.elevations_deg))
    assert largest == pytest.approx(jump, abs=HUNDREDTH)
