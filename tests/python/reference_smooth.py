# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The smooth interpolant, exact closure and the whole range, written a second time.

Straight and slow, from the equations alone: the program is tested against this file, so nothing
here is taken from it. Where an equation has a derivative in it, this file takes differences.

Frames, sequences and signs are those of reference_rhythm. A name that ends in _deg is in degrees,
all else in radians. Everything is computed for many poses at once: a rotation is an array (4, N)
of quaternions w, x, y, z, a vector one of (3, N), and `multiply` of reference_rhythm takes them as
they are. A vector of `logs` and `exps` is the whole rotation vector, not half of it.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from reference_rhythm import (
    JOINT_COORDINATES,
    JOINT_SEQUENCES,
    Array,
    Position,
    multiply,
    quaternion_from_euler,
)

Closure = Literal["table", "exact"]
Extent = Literal["clamp", "whole"]
AxialFrom = Literal["rhythm", "isb", "swing"]
# Lower and upper end (deg) of coordinates.
JointRanges = dict[str, tuple[float, float]]

JOINT_RANGES = Path(__file__).resolve().parents[2] / "data" / "joint_ranges.csv"

# What was measured, and where the rule of the whole range ends.
LOWEST_MEASURED, HIGHEST_MEASURED = math.radians(15.0), math.radians(120.0)
FRONTAL, SAGITTAL = 0.0, math.radians(90.0)
HANGING, STRAIGHT_UP = 0.0, math.radians(180.0)

# What an arm can reach: planes from behind the body to across the chest; between the first plane
# and the one that is free at every elevation only what lies outside a circle, which touches the
# free plane and has its centre at an elevation.
BEHIND_DEG, FREE_DEG, ACROSS_DEG = -95.0, -30.0, 135.0
CIRCLE_ELEVATION_DEG, CIRCLE_RADIUS_DEG = 107.5, 45.0
# What is not reached: planes seen from the middle of the reach; between the first plane and the
# last one there is a wedge, this far to either side of the plane opposite to the middle.
MIDDLE_DEG = (BEHIND_DEG + ACROSS_DEG) / 2.0
HALF_WEDGE_DEG = 180.0 - (ACROSS_DEG - MIDDLE_DEG)

# Across the borders of plane: how far the edge's velocity carries on, and how far the bone turns
# about the parent's y with a raised arm in front of the sagittal plane (rad/rad).
PLANE_FADE = math.radians(5.0)
TURN_WITH_PLANE = {"sc": 0.34, "ac": 0.11}

# Above the table: the mean rate is that from here to the highest measured elevation, the edge's own
# velocity fades out within the second length, the rate holds up to the third.
MEAN_RATE_FROM = math.radians(90.0)
RISE_FADE = math.radians(15.0)
STEADY_RISE = math.radians(30.0)

# The joints' Euler angles (deg) with the arm hanging and with the arm straight up.
HANGING_DEG = {"sc": (-21.5, -9.5, -2.0), "ac": (55.0, -5.0, -6.0)}
STRAIGHT_UP_DEG = {"sc": (-54.0, -21.0, 37.0), "ac": (63.0, -23.0, 28.0)}

# gh_axial is given above this (deg) and up to a turn more; the other angles within half a turn.
LOWEST_AXIAL_DEG = -225.0

NOT_A_KNOT_KNOTS = 4
PARABOLA_KNOTS = 3


# --- Quaternions ---------------------------------------------------------------------------------


def inverses(q: Array) -> Array:
    return np.stack([q[0], -q[1], -q[2], -q[3]])


def logs(q: Array) -> Array:
    """The rotation vectors, at most half a turn long; the signs of the quaternions do not count."""
    q = np.where(q[0] < 0.0, -q, q)
    sine = np.linalg.norm(q[1:], axis=0)
    angle = 2.0 * np.arctan2(sine, q[0])
    # Where the sine is zero the angle is twice the sine.
    return q[1:] * np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 2.0)


def exps(vector: Array) -> Array:
    half = np.linalg.norm(vector, axis=0) / 2.0
    # sinc(x) is sin(pi x) / (pi x).
    return np.concatenate(([np.cos(half)], 0.5 * np.sinc(half / math.pi) * vector))


def turns(axis: str, angle: Array) -> Array:
    """The rotations by an angle about one of the axes."""
    q = np.zeros((4, *np.shape(angle)))
    q[0] = np.cos(angle / 2.0)
    q["xyz".index(axis) + 1] = np.sin(angle / 2.0)
    return q


def turned(q: Array, vector: Array) -> Array:
    """The vectors, given in the child's frame, in the parent's."""
    pure = np.concatenate((np.zeros((1, *vector.shape[1:])), vector))
    return multiply(multiply(q, pure), inverses(q))[1:]


def angles_between_deg(a: Array, b: Array) -> Array:
    return np.degrees(np.linalg.norm(logs(multiply(inverses(a), b)), axis=0))


def euler_quaternions(sequence: str, angles_deg: Array) -> Array:
    """The intrinsic rotations of angles (3, N)."""
    first, second, third = (
        turns(axis, np.radians(angle_deg)) for axis, angle_deg in zip(sequence, angles_deg, strict=True)
    )
    return multiply(multiply(first, second), third)


def euler_angles_deg(sequence: str, q: Array) -> Array:
    """Angles (3, N) of a sequence of three different axes, the second within -90..90.

    With i, j, k the axes and e = 1 where they are in cyclic order, else -1, R = Ri(a) Rj(b) Rk(c)
    has R_ik = e sin b, R_jk = -e sin a cos b, R_kk = cos a cos b, R_ij = -e cos b sin c and
    R_ii = cos b cos c.
    """
    i, j, k = ("xyz".index(axis) for axis in sequence)
    e = 1.0 if (j - i) % 3 == 1 else -1.0
    unit = np.eye(3)
    axes = [turned(q, np.repeat(unit[:, [n]], q.shape[1], axis=1)) for n in range(3)]
    return np.degrees(
        [
            np.arctan2(-e * axes[k][j], axes[k][k]),
            np.arctan2(e * axes[k][i], np.hypot(axes[i][i], axes[j][i])),
            np.arctan2(-e * axes[j][i], axes[i][i]),
        ]
    )


def in_axial_window_deg(angle_deg: Array) -> Array:
    """GH's last angle, within half a turn, in the window that it is given in."""
    return np.where(angle_deg > LOWEST_AXIAL_DEG + 360.0, angle_deg - 360.0, angle_deg)


def mean_rotation(q: Array) -> Array:
    """The Frechet mean: q <- exp(mean of log(q_i q^-1)) q until it stays."""
    mean = q[:, :1]
    while True:
        step = np.mean(logs(multiply(q, inverses(mean))), axis=1, keepdims=True)
        mean = multiply(exps(step), mean)
        mean = mean / np.linalg.norm(mean)
        if np.linalg.norm(step) < 1e-15:
            return mean


# --- The arm -------------------------------------------------------------------------------------


def arm_direction(theta: Array, psi: Array) -> Array:
    """From shoulder to elbow, unit vectors in the thorax."""
    return np.stack([np.sin(theta) * np.sin(psi), -np.cos(theta), np.sin(theta) * np.cos(psi)])


def swing(theta: Array, psi: Array) -> Array:
    """S, the smallest rotation that takes the hanging arm, -y, to the direction (theta, psi).

    It turns by theta about -y x direction, which is (-cos psi, 0, sin psi) sin theta.
    """
    axis = np.stack([-np.cos(psi), np.zeros_like(psi), np.sin(psi)])
    return exps(theta * axis)


def twist(q_TH: Array) -> Array:
    """tau of q_TH = S Ry(tau) with S a smallest rotation, which has no y, within half a turn."""
    return 2.0 * np.arctan2(q_TH[2], q_TH[0])


def isb_humerus(elevation_deg: Array, plane_deg: Array, axial_deg: Array) -> Array:
    """q_TH of ISB's humerothoracic angles, Y(plane) X(-elevation) Y(axial)."""
    return euler_quaternions("yxy", np.stack([plane_deg, -elevation_deg, axial_deg]))


def carried(q_TH: Array, elevation_deg: Array, plane_deg: Array) -> Array:
    """A humerus taken by the smallest rotation to where its arm points in a direction.

    About arm x direction by the angle between the two.
    """
    hanging = np.repeat([[0.0], [-1.0], [0.0]], q_TH.shape[1], axis=1)
    arm = turned(q_TH, hanging)
    goal = arm_direction(np.radians(elevation_deg), np.radians(plane_deg))
    axis = np.cross(arm, goal, axis=0)
    sine = np.linalg.norm(axis, axis=0)
    angle = np.arctan2(sine, np.sum(arm * goal, axis=0))
    return multiply(exps(axis * np.where(sine > 0.0, angle / np.where(sine > 0.0, sine, 1.0), 1.0)), q_TH)


def direction_deg(elevation_deg: Array | float, plane_deg: Array | float) -> Array:
    return arm_direction(np.radians(elevation_deg), np.radians(plane_deg))


def apart_deg(a: Array, b: Array) -> Array:
    """The angle between unit vectors (3, N), precise for small ones."""
    sine = np.linalg.norm(np.cross(a, b, axis=0), axis=0)
    return np.degrees(np.arctan2(sine, np.sum(a * b, axis=0)))


def as_seen_from(plane_deg: Array | float, middle_deg: float) -> Array:
    """The plane, whole turns away from the one given, that is within half a turn of another."""
    away_deg = np.asarray(plane_deg, dtype=float) - middle_deg
    turned_deg = middle_deg + np.remainder(away_deg + 180.0, 360.0) - 180.0
    return np.where(np.abs(away_deg) <= 180.0, plane_deg, turned_deg)


def normal_of(plane_deg: float) -> Array:
    """Of the plane through hanging and straight up, to higher planes."""
    return np.array([math.cos(math.radians(plane_deg)), 0.0, -math.sin(math.radians(plane_deg))])


# The centre is a radius away from the free plane: sin(radius) = sin(elevation) sin(beyond).
CENTRE_PLANE_DEG = FREE_DEG - math.degrees(
    math.asin(math.sin(math.radians(CIRCLE_RADIUS_DEG)) / math.sin(math.radians(CIRCLE_ELEVATION_DEG)))
)
CENTRE = direction_deg(CIRCLE_ELEVATION_DEG, CENTRE_PLANE_DEG)


def touch_deg() -> float:
    """The elevation at which the circle touches the free plane: below the centre's foot on it."""
    normal = normal_of(FREE_DEG)
    foot = CENTRE - (CENTRE @ normal) * normal
    return math.degrees(math.atan2(math.hypot(foot[0], foot[2]), -foot[1]))


TOUCH_DEG = touch_deg()
# Behind its centre the circle's lowest elevation is the limit, from the first plane on.
CORNER_DEG = CIRCLE_ELEVATION_DEG - CIRCLE_RADIUS_DEG


def lowest_plane_deg(elevation_deg: Array | float) -> Array:
    """The first plane up to the corner, the circle in front of its centre, the free plane above.

    On the circle the angle to the centre is the radius: the law of cosines of the triangle of the
    centre, the direction and hanging.
    """
    elevation_deg = np.asarray(elevation_deg, dtype=float)
    e = np.radians(np.clip(elevation_deg, CORNER_DEG, TOUCH_DEG))
    c, r = math.radians(CIRCLE_ELEVATION_DEG), math.radians(CIRCLE_RADIUS_DEG)
    cosine = (math.cos(r) - math.cos(c) * np.cos(e)) / (math.sin(c) * np.sin(e))
    on_circle_deg = CENTRE_PLANE_DEG + np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
    limit_deg = np.where(elevation_deg >= TOUCH_DEG, FREE_DEG, np.minimum(on_circle_deg, FREE_DEG))
    return np.where(elevation_deg <= CORNER_DEG, BEHIND_DEG, limit_deg)


def reached(elevation_deg: Array, plane_deg: Array) -> Array:
    """Planes as seen from the middle."""
    return (plane_deg >= lowest_plane_deg(elevation_deg)) & (plane_deg <= ACROSS_DEG)


def nearest_on_plane(
    v: Array, plane_deg: float, lowest_deg: float, highest_deg: float
) -> tuple[Array, Array]:
    """The elevation (deg) of the nearest direction of a piece of a plane, and its distance.

    The foot of the perpendicular where that is on the piece, else one of its ends.
    """
    normal = normal_of(plane_deg)[:, None]
    foot = v - np.sum(normal * v, axis=0) * normal
    level = direction_deg(90.0, plane_deg)[:, None]
    elevation_deg = np.degrees(np.arctan2(np.sum(level * foot, axis=0), -foot[1]))
    ends_deg = np.array([lowest_deg, highest_deg])
    to_ends_deg = np.stack(
        [apart_deg(v, np.repeat(direction_deg(e, plane_deg)[:, None], v.shape[1], axis=1)) for e in ends_deg]
    )
    is_on_piece = (elevation_deg >= lowest_deg) & (elevation_deg <= highest_deg)
    elevation_deg = np.where(is_on_piece, elevation_deg, ends_deg[np.argmin(to_ends_deg, axis=0)])
    there = direction_deg(elevation_deg, np.full_like(elevation_deg, plane_deg))
    return elevation_deg, apart_deg(v, there)


def nearest_on_circle(v: Array) -> tuple[Array, Array, Array]:
    """Elevation, plane (deg) and distance; infinite where the circle is not the limit."""
    centre = CENTRE[:, None]
    away = v - np.sum(centre * v, axis=0) * centre
    length = np.linalg.norm(away, axis=0)
    away = away / np.where(length > 0.0, length, 1.0)
    r = math.radians(CIRCLE_RADIUS_DEG)
    foot = math.cos(r) * centre + math.sin(r) * away
    elevation_deg = np.degrees(np.arctan2(np.hypot(foot[0], foot[2]), -foot[1]))
    plane_deg = as_seen_from(np.degrees(np.arctan2(foot[0], foot[2])), CENTRE_PLANE_DEG)
    is_limit = (plane_deg >= CENTRE_PLANE_DEG) & (elevation_deg <= TOUCH_DEG) & (length > 0.0)
    return elevation_deg, plane_deg, np.where(is_limit, apart_deg(v, foot), np.inf)


def bump(x: Array) -> Array:
    """From 1 at 0 to 0 at 1, level outside: 1 - 10 x^3 + 15 x^4 - 6 x^5."""
    x = np.clip(x, 0.0, 1.0)
    return np.asarray(1.0 - x**3 * (10.0 - 15.0 * x + 6.0 * x**2))


def nearest_reached_deg(elevation_deg: Array, plane_deg: Array) -> tuple[Array, Array, Array]:
    """Elevation, plane and distance of the limit's nearest direction to ones outside (deg)."""
    v = direction_deg(elevation_deg, plane_deg)
    across = nearest_on_plane(v, ACROSS_DEG, 0.0, 180.0)
    behind = nearest_on_plane(v, BEHIND_DEG, 0.0, CORNER_DEG)
    above = nearest_on_plane(v, FREE_DEG, TOUCH_DEG, 180.0)
    circle = nearest_on_circle(v)
    # Above the piece of one elevation the direction below is nearest; beside it one of its ends is,
    # which other pieces end in, too.
    below_plane_deg = np.clip(plane_deg, BEHIND_DEG, CENTRE_PLANE_DEG)
    below_elevation_deg = np.full_like(plane_deg, CORNER_DEG)
    below_distance_deg = apart_deg(v, direction_deg(below_elevation_deg, below_plane_deg))
    elevations_deg = np.stack([across[0], behind[0], above[0], circle[0], below_elevation_deg])
    planes_deg = np.stack(
        [np.full_like(plane_deg, p) for p in (ACROSS_DEG, BEHIND_DEG, FREE_DEG)]
        + [circle[1], below_plane_deg]
    )
    distances_deg = np.stack([across[1], behind[1], above[1], circle[2], below_distance_deg])
    best = np.argmin(distances_deg, axis=0)[None]
    found = [np.take_along_axis(a, best, axis=0)[0] for a in (elevations_deg, planes_deg)]
    # Straight up the plane passes over from one limit to the other within a quarter turn of both.
    from_deg, to_deg = ACROSS_DEG + 90.0, FREE_DEG + 270.0
    turned_deg = np.where(plane_deg < MIDDLE_DEG, plane_deg + 360.0, plane_deg)
    passing = bump((turned_deg - from_deg) / (to_deg - from_deg))
    straight_up_deg = FREE_DEG + (ACROSS_DEG - FREE_DEG) * passing
    found[1] = np.where(found[0] == math.degrees(STRAIGHT_UP), straight_up_deg, found[1])
    return found[0], found[1], np.take_along_axis(distances_deg, best, axis=0)[0]


def answer_deg(elevation_deg: Array, plane_deg: Array) -> tuple[Array, Array]:
    """The direction that answers one: itself where it is reached. Elevation within 0 to 180.

    answer = n + V (h - n), in elevation and plane, with n the nearest direction that is reached and
    h one in the middle of the reach:

    1 - V = (1 - bump(|s| / 0.25) bump((theta - 55) / 60)) bump((distance - 20) / 24)
    h     = (theta (1 - (1 - cos 65) bump((theta - 90) / 90)), 20)

    s is 0 opposite to the middle and 1 in size at the ends of the wedge.
    """
    plane_deg = as_seen_from(plane_deg, MIDDLE_DEG)
    nearest_elevation_deg, nearest_plane_deg, distance_deg = nearest_reached_deg(elevation_deg, plane_deg)
    from_opposite_deg = 180.0 - np.abs(plane_deg - MIDDLE_DEG)
    in_wedge = bump(from_opposite_deg / HALF_WEDGE_DEG / 0.25) * bump((elevation_deg - 55.0) / 60.0)
    v = 1.0 - (1.0 - in_wedge) * bump((distance_deg - 20.0) / 24.0)
    lowered = (1.0 - math.cos(math.radians(HALF_WEDGE_DEG))) * bump((elevation_deg - 90.0) / 90.0)
    middle_elevation_deg = elevation_deg * (1.0 - lowered)
    is_reached = reached(elevation_deg, plane_deg)
    return (
        np.where(
            is_reached,
            elevation_deg,
            nearest_elevation_deg + v * (middle_elevation_deg - nearest_elevation_deg),
        ),
        np.where(is_reached, plane_deg, nearest_plane_deg + v * (MIDDLE_DEG - nearest_plane_deg)),
    )


def distance_from_measured_deg(elevation_deg: Array | float, plane_deg: Array | float) -> Array:
    """The smallest angle from the arm to one of elevation 15..120 and plane 0..90.

    The cosine of the angle between the directions (theta, psi) and (t, p) is

        cos(theta) cos(t) + sin(theta) cos(psi - p) sin(t)

    so the best p is the one nearest to psi, whatever t is, and the sum is a cosine of t with its
    top at atan2(sin(theta) cos(psi - p), cos(theta)). Where that t is not measured, the best is at
    one of the ends. (-theta, psi) is the direction (theta, psi + 180).
    """
    signed = np.radians(np.asarray(elevation_deg, dtype=float))
    signed = np.arctan2(np.sin(signed), np.cos(signed))
    theta = np.abs(signed)
    psi = np.radians(np.asarray(plane_deg, dtype=float)) + np.where(signed < 0.0, np.pi, 0.0)
    arm = arm_direction(theta, psi)

    middle = (FRONTAL + SAGITTAL) / 2.0
    # psi as seen from the middle of the measured planes, within half a turn.
    around = np.arctan2(np.sin(psi - middle), np.cos(psi - middle))
    p = middle + np.clip(around, FRONTAL - middle, SAGITTAL - middle)
    top = np.arctan2(np.sin(theta) * np.cos(psi - p), np.cos(theta))
    distances = []
    for t in (
        np.full_like(theta, LOWEST_MEASURED),
        np.clip(top, LOWEST_MEASURED, HIGHEST_MEASURED),
        np.full_like(theta, HIGHEST_MEASURED),
    ):
        chord = np.linalg.norm(arm - arm_direction(t, p), axis=0)
        distances.append(2.0 * np.degrees(np.arcsin(np.minimum(chord / 2.0, 1.0))))
    return np.min(distances, axis=0)


# --- Splines -------------------------------------------------------------------------------------


class Spline:
    """The interpolating spline over knots, as weights of the values at the knots.

    From four knots on a cubic in every interval, with continuous first and second derivatives, and
    with a continuous third one at the first and at the last knot inside. With three, the parabola
    through all. Outside the knots the first and the last polynomial go on.
    """

    def __init__(self, knots: Sequence[float] | Array) -> None:
        self.knots = np.array(knots, dtype=float)
        self.widths = np.diff(self.knots)
        if len(self.knots) < PARABOLA_KNOTS:
            raise ValueError(f"{len(self.knots)} knots, expected at least {PARABOLA_KNOTS}")
        # coefficients[i, power] are those of s^power in the interval i, s = (x - x_i) / width, as
        # weights of the values.
        self.coefficients = self.parabola() if len(self.knots) == PARABOLA_KNOTS else self.not_a_knot()

    def not_a_knot(self) -> Array:
        count = len(self.knots)
        intervals = count - 1
        equations: list[tuple[Array, Array]] = []

        def equation(left: dict[tuple[int, int], float], knot: int | None = None) -> None:
            row = np.zeros((intervals, 4))
            for place, factor in left.items():
                row[place] = factor
            right = np.eye(count)[knot] if knot is not None else np.zeros(count)
            equations.append((row.ravel(), right))

        for i in range(intervals):
            equation({(i, 0): 1.0}, knot=i)
            equation({(i, power): 1.0 for power in range(4)}, knot=i + 1)
        for i in range(intervals - 1):
            a, b = self.widths[i], self.widths[i + 1]
            equation({(i, 1): 1.0 / a, (i, 2): 2.0 / a, (i, 3): 3.0 / a, (i + 1, 1): -1.0 / b})
            equation({(i, 2): 2.0 / a**2, (i, 3): 6.0 / a**2, (i + 1, 2): -2.0 / b**2})
        for i in (0, intervals - 2):
            a, b = self.widths[i], self.widths[i + 1]
            equation({(i, 3): 6.0 / a**3, (i + 1, 3): -6.0 / b**3})

        left, right = (np.array(side) for side in zip(*equations, strict=True))
        # Divided by its largest number, no equation drowns in another.
        size = np.abs(left).max(axis=1, keepdims=True)
        return np.linalg.solve(left / size, right / size).reshape(intervals, 4, count)

    def parabola(self) -> Array:
        powers = np.vander(self.knots, PARABOLA_KNOTS, increasing=True)
        # c[0] + c[1] x + c[2] x^2
        c = np.linalg.solve(powers, np.eye(PARABOLA_KNOTS))
        intervals = zip(self.knots[:-1], self.widths, strict=True)
        return np.array(
            [
                [powers[i] @ c, (c[1] + 2.0 * c[2] * x) * h, c[2] * h**2, np.zeros(PARABOLA_KNOTS)]
                for i, (x, h) in enumerate(intervals)
            ]
        )

    def weights(self, x: Array) -> Array:
        """What each of the values counts at x, (N, knots)."""
        interval = np.clip(np.searchsorted(self.knots, x) - 1, 0, len(self.widths) - 1)
        s = (x - self.knots[interval]) / self.widths[interval]
        powers = np.stack([np.ones_like(s), s, s**2, s**3], axis=1)
        return np.einsum("np,npk->nk", powers, self.coefficients[interval])


def rate(f: Callable[[float], Array]) -> Array:
    """The derivative of f(x) at x = 0, by the five-point formula, whose error is of order h^4.

    (8 (f(h) - f(-h)) - (f(2h) - f(-2h))) / (12 h)
    """
    h = 1e-3
    return (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h)


# --- The rhythm ----------------------------------------------------------------------------------


def read_joint_ranges(path: Path = JOINT_RANGES) -> JointRanges:
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {r["coordinate"]: (float(r["lower_deg"]), float(r["upper_deg"])) for r in rows}


@dataclass(frozen=True)
class SmoothPoses:
    """What became of N commands; every array ends in N."""

    elevation_deg: Array  # the command that was used
    plane_deg: Array
    axial_deg: Array
    shrug_deg: Array
    protraction_deg: Array
    clamped: Array  # bool: it is another one than the given
    gh_stops: Array  # bool: GH's ranges left no room for all of the offsets
    distance_deg: Array
    rotations: dict[str, Array]  # "sc" q_TC, "ac" q_CS, "gh" q_SH
    angles_deg: dict[str, Array]  # by coordinate


@dataclass(frozen=True)
class Command:
    """The commands (rad), elevation and plane where they can be answered."""

    theta: Array
    psi: Array
    axial: Array
    shrug: Array
    protraction: Array

    def moved(self, d_theta: float, d_psi: float) -> Command:
        return Command(self.theta + d_theta, self.psi + d_psi, self.axial, self.shrug, self.protraction)


class SmoothRhythm:
    """SC, AC, GH and the humerus's own turn, continuous to the second derivative in the table."""

    def __init__(self, positions: list[Position], ranges: JointRanges | None = None) -> None:
        self.ranges = ranges or {}
        self.elevations_deg = sorted({p.elevation_deg for p in positions})
        self.planes_deg = sorted({p.plane_deg for p in positions})
        if len(self.elevations_deg) < NOT_A_KNOT_KNOTS:
            raise ValueError(f"{len(self.elevations_deg)} elevations, expected at least {NOT_A_KNOT_KNOTS}")
        self.along_theta = Spline(np.radians(self.elevations_deg))
        self.along_psi = Spline(np.radians(self.planes_deg))

        by_place = {(p.elevation_deg, p.plane_deg): p for p in positions}
        shape = (len(self.elevations_deg), len(self.planes_deg))
        grid = [by_place[theta, psi] for theta in self.elevations_deg for psi in self.planes_deg]
        q = {j: np.array([p.rotation(j) for p in grid]).T for j in JOINT_SEQUENCES}
        self.means = {joint: mean_rotation(q[joint]) for joint in q}
        # u_i = log(q_i m^-1), values[joint][component, theta, psi]
        self.values = {
            joint: logs(multiply(q[joint], inverses(self.means[joint]))).reshape(3, *shape) for joint in q
        }
        tau = twist(multiply(multiply(q["sc"], q["ac"]), q["gh"])).reshape(shape)
        self.tau_values = np.unwrap(np.unwrap(tau, axis=0), axis=1)

        self.hanging, self.straight_up = (
            {j: quaternion_from_euler(JOINT_SEQUENCES[j], a)[:, None] for j, a in angles.items()}
            for angles in (HANGING_DEG, STRAIGHT_UP_DEG)
        )

    # --- Inside the table ---

    def spline(self, values: Array, theta: Array, psi: Array) -> Array:
        return np.einsum(
            "nt,...tp,np->...n",
            self.along_theta.weights(theta),
            values,
            self.along_psi.weights(psi),
            optimize=True,
        )

    def table_rotation(self, joint: str, theta: Array, psi: Array) -> Array:
        """q = exp(u) m"""
        return multiply(exps(self.spline(self.values[joint], theta, psi)), self.means[joint])

    def table_tau(self, theta: Array, psi: Array) -> Array:
        return self.spline(self.tau_values, theta, psi)

    # --- Any plane, elevations as measured ---

    @staticmethod
    def beyond_plane(psi: Array) -> tuple[Array, Array, Array]:
        """The nearest measured plane e, x = psi - e, and g = sign(x) L (1 - exp(-|x| / L))."""
        e = np.clip(psi, FRONTAL, SAGITTAL)
        x = psi - e
        return e, x, np.sign(x) * PLANE_FADE * (1.0 - np.exp(-np.abs(x) / PLANE_FADE))

    def plane_rotation(self, joint: str, theta: Array, psi: Array) -> Array:
        """q(theta, psi) = Ry(k sin(theta) (x - g)) q(theta, e) exp(w g), w = d q / d psi at e."""
        e, x, g = self.beyond_plane(psi)
        k = np.where(x > 0.0, TURN_WITH_PLANE[joint], 0.0)
        q = self.table_rotation(joint, theta, e)
        w = rate(lambda h: logs(multiply(inverses(q), self.table_rotation(joint, theta, e + h))))
        return multiply(multiply(turns("y", k * np.sin(theta) * (x - g)), q), exps(w * g))

    def plane_tau(self, theta: Array, psi: Array) -> Array:
        """tau(theta, e) + w g + sin(min(theta, 90)) (x - g)"""
        e, x, g = self.beyond_plane(psi)
        w = rate(lambda h: self.table_tau(theta, e + h))
        with_plane = np.sin(np.minimum(theta, math.radians(90.0))) * (x - g)
        return self.table_tau(theta, e) + w * g + with_plane

    # --- Any elevation ---

    def low_rotation(self, joint: str, theta: Array, psi: Array) -> Array:
        """q = q15 exp(V (3 s^2 - 2 s^3) - 15 w (s - 2 s^2 + s^3)), s = 1 - theta / 15."""
        q_15 = self.plane_rotation(joint, np.full_like(psi, LOWEST_MEASURED), psi)
        w = rate(
            lambda h: logs(
                multiply(
                    inverses(q_15),
                    self.plane_rotation(joint, np.full_like(psi, LOWEST_MEASURED + h), psi),
                )
            )
        )
        v_0 = logs(multiply(inverses(q_15), self.hanging[joint]))
        s = 1.0 - theta / LOWEST_MEASURED
        v = v_0 * (3.0 * s**2 - 2.0 * s**3) - LOWEST_MEASURED * w * (s - 2.0 * s**2 + s**3)
        return multiply(q_15, exps(v))

    def low_tau(self, theta: Array, psi: Array) -> Array:
        """tau15 + (tau0 - tau15) (3 s^2 - 2 s^3) - 15 w (s - 2 s^2 + s^3)"""
        tau_15 = self.plane_tau(np.full_like(psi, LOWEST_MEASURED), psi)
        w = rate(lambda h: self.plane_tau(np.full_like(psi, LOWEST_MEASURED + h), psi))
        tau_0 = self.hanging_tau()
        s = 1.0 - theta / LOWEST_MEASURED
        return (
            tau_15
            + (tau_0 - tau_15) * (3.0 * s**2 - 2.0 * s**3)
            - LOWEST_MEASURED * w * (s - 2.0 * s**2 + s**3)
        )

    def hanging_tau(self) -> float:
        """The mean over the table's planes at 15."""
        planes = np.radians(self.planes_deg)
        return float(np.mean(self.table_tau(np.full_like(planes, LOWEST_MEASURED), planes)))

    def high_rotation(self, joint: str, theta: Array, psi: Array) -> Array:
        """q = q120 exp(v), x = theta - 120:

        x <= 30:  v = w x + [x < 15] (we - w) x (1 - x / 15)^2
        x > 30:   v = 30 w (1 - 3 s^2 + 2 s^3) + V (3 s^2 - 2 s^3) + 30 w (s - 2 s^2 + s^3),
                  s = (x - 30) / 30

        w the mean rate from 90 to 120, we the velocity at 120, V the way to straight up.
        """
        q_120 = self.plane_rotation(joint, np.full_like(psi, HIGHEST_MEASURED), psi)
        q_90 = self.plane_rotation(joint, np.full_like(psi, MEAN_RATE_FROM), psi)
        w = logs(multiply(inverses(q_90), q_120)) / (HIGHEST_MEASURED - MEAN_RATE_FROM)
        we = rate(
            lambda h: logs(
                multiply(
                    inverses(q_120),
                    self.plane_rotation(joint, np.full_like(psi, HIGHEST_MEASURED + h), psi),
                )
            )
        )
        v_180 = logs(multiply(inverses(q_120), self.straight_up[joint]))
        x = theta - HIGHEST_MEASURED
        fading = np.where(x < RISE_FADE, x * (1.0 - x / RISE_FADE) ** 2, 0.0)
        steady = w * x + (we - w) * fading
        s = (x - STEADY_RISE) / (STRAIGHT_UP - HIGHEST_MEASURED - STEADY_RISE)
        w_30 = STEADY_RISE * w
        rising = (
            w_30 * (1.0 - 3.0 * s**2 + 2.0 * s**3)
            + v_180 * (3.0 * s**2 - 2.0 * s**3)
            + w_30 * (s - 2.0 * s**2 + s**3)
        )
        return multiply(q_120, exps(np.where(x <= STEADY_RISE, steady, rising)))

    def high_tau(self, theta: Array, psi: Array) -> Array:
        """tau(120, psi) + we x (1 - x / 15)^2 for x < 15, and constant after."""
        tau_120 = self.plane_tau(np.full_like(psi, HIGHEST_MEASURED), psi)
        we = rate(lambda h: self.plane_tau(np.full_like(psi, HIGHEST_MEASURED + h), psi))
        x = theta - HIGHEST_MEASURED
        return tau_120 + np.where(x < RISE_FADE, we * x * (1.0 - x / RISE_FADE) ** 2, 0.0)

    @staticmethod
    def by_elevation(
        theta: Array,
        psi: Array,
        low: Callable[[Array, Array], Array],
        measured: Callable[[Array, Array], Array],
        high: Callable[[Array, Array], Array],
    ) -> Array:
        """Each pose by the rule of its elevation."""
        where_low, where_high = theta < LOWEST_MEASURED, theta > HIGHEST_MEASURED
        between = ~(where_low | where_high)
        low_ones, measured_ones, high_ones = (
            rule(theta[where], psi[where])
            for where, rule in ((where_low, low), (between, measured), (where_high, high))
        )
        result = np.empty((*measured_ones.shape[:-1], len(theta)))
        result[..., where_low] = low_ones
        result[..., between] = measured_ones
        result[..., where_high] = high_ones
        return result

    def whole_rotation(self, joint: str, theta: Array, psi: Array) -> Array:
        return self.by_elevation(
            theta,
            psi,
            lambda t, p: self.low_rotation(joint, t, p),
            lambda t, p: self.plane_rotation(joint, t, p),
            lambda t, p: self.high_rotation(joint, t, p),
        )

    def whole_tau(self, theta: Array, psi: Array) -> Array:
        return self.by_elevation(theta, psi, self.low_tau, self.plane_tau, self.high_tau)

    # --- Poses ---

    def bounded(self, coordinate: str, angle: Array, added: Array) -> Array:
        """What may be added to an angle (rad): up to its range, from outside only back."""
        low, high = np.radians(self.ranges.get(coordinate, (-math.inf, math.inf)))
        return np.clip(added, np.minimum(low - angle, 0.0), np.maximum(high - angle, 0.0))

    def share_that_gh_allows(self, angles: Array, offset: Array, q_CS: Array, q_TH: Array) -> Array:
        """GH makes up for the girdle: how much of the clavicle's offset its ranges leave room for.

        As in `bounded`, an angle that is outside already may not go further out.
        """

        def gh_angles_deg(columns: Array, share: Array) -> Array:
            moved = euler_quaternions("yxz", np.degrees(angles[:, columns] + share * offset[:, columns]))
            q_SH = multiply(inverses(multiply(moved, q_CS[:, columns])), q_TH[:, columns])
            gh: Array = np.array(euler_angles_deg("xzy", q_SH))
            gh[2] = in_axial_window_deg(gh[2])
            return gh

        everywhere = np.arange(angles.shape[1])
        own = gh_angles_deg(everywhere, np.zeros(angles.shape[1]))
        limits = np.array([self.ranges.get(c, (-math.inf, math.inf)) for c in JOINT_COORDINATES["gh"]])
        low = np.minimum(limits[:, [0]], own) - 1e-10
        high = np.maximum(limits[:, [1]], own) + 1e-10

        def fits(columns: Array, share: Array) -> Array:
            gh = gh_angles_deg(columns, share)
            return ((gh >= low[:, columns]) & (gh <= high[:, columns])).all(axis=0)

        share = np.ones(angles.shape[1])
        stopped = everywhere[~fits(everywhere, share)]
        possible, impossible = np.zeros(stopped.size), np.ones(stopped.size)
        for _ in range(60):
            middle = (possible + impossible) / 2.0
            fit = fits(stopped, middle)
            possible, impossible = np.where(fit, middle, possible), np.where(fit, impossible, middle)
        share[stopped] = possible
        return share

    def joint_rotations(self, command: Command, closure: Closure, extent: Extent) -> dict[str, Array]:
        """q_TC, q_CS and q_SH. Just outside the extent the formula of its edge goes on."""
        return self.rotations_and_additions(command, closure, extent)[0]

    def rotations_and_additions(
        self, command: Command, closure: Closure, extent: Extent
    ) -> tuple[dict[str, Array], dict[str, Array]]:
        """The same, and what was added of axial, shrug and protraction (rad).

        `share` is how much of the offsets GH left, 1 where it did not stop them.
        """
        theta, psi = command.theta, command.psi
        if extent == "whole":
            q_TC, q_CS = (self.whole_rotation(joint, theta, psi) for joint in ("sc", "ac"))
            tau = self.whole_tau(theta, psi)
        else:
            q_TC, q_CS = (self.table_rotation(joint, theta, psi) for joint in ("sc", "ac"))
            tau = self.table_tau(theta, psi)

        # Protraction adds to the clavicle's first angle; its second, elevation, is negative.
        angles = np.radians(euler_angles_deg("yxz", q_TC))
        protraction = self.bounded("sc_protraction", angles[0], command.protraction)
        shrug = -self.bounded("sc_elevation", angles[1], -command.shrug)
        offset = np.stack([protraction, -shrug, np.zeros_like(shrug)])
        share = np.ones_like(protraction)

        if closure == "table":
            q_TC = euler_quaternions("yxz", np.degrees(angles + offset))
            q_SH = self.table_rotation("gh", theta, psi)
        else:
            # q_TH = S Ry(tau), q_SH = (q_TC q_CS)^-1 q_TH
            q_TH = multiply(swing(theta, psi), turns("y", tau))
            share = self.share_that_gh_allows(angles, offset, q_CS, q_TH)
            q_TC = euler_quaternions("yxz", np.degrees(angles + share * offset))
            q_SH = multiply(inverses(multiply(q_TC, q_CS)), q_TH)
            protraction, shrug = share * protraction, share * shrug
        # A turn about the humerus's own y, which the sequence has last, adds to its last angle.
        turn = np.radians(in_axial_window_deg(euler_angles_deg("xzy", q_SH)[2]))
        axial = self.bounded("gh_axial", turn, command.axial)
        q_SH = multiply(q_SH, turns("y", axial))
        additions = {"axial": axial, "shrug": shrug, "protraction": protraction, "share": share}
        return {"sc": q_TC, "ac": q_CS, "gh": q_SH}, additions

    def answerable(
        self, elevation_deg: Array | float, plane_deg: Array | float, extent: Extent
    ) -> tuple[Array, Array]:
        """The nearest elevation and, with the extent clamp, the nearest plane of the table.

        A plane is an angle: whole turns do not count.
        """
        if extent == "clamp":
            first_deg, last_deg = self.planes_deg[0], self.planes_deg[-1]
            seen_deg = as_seen_from(plane_deg, (first_deg + last_deg) / 2.0)
            return (
                np.clip(elevation_deg, self.elevations_deg[0], self.elevations_deg[-1]),
                np.clip(seen_deg, first_deg, last_deg),
            )
        theta_deg = np.clip(elevation_deg, math.degrees(HANGING), math.degrees(STRAIGHT_UP))
        return answer_deg(*np.broadcast_arrays(theta_deg, np.asarray(plane_deg, dtype=float)))

    def is_answered_by_another(self, elevation_deg: Array, plane_deg: Array, extent: Extent) -> Array:
        """Hanging, every plane is the same direction."""
        theta_deg, psi_deg = self.answerable(elevation_deg, plane_deg, extent)
        other_plane = np.abs(as_seen_from(plane_deg - psi_deg, 0.0)) > 1e-12
        is_hanging = (elevation_deg == 0.0) & (theta_deg < 1e-12)
        return ~is_hanging & ((theta_deg != elevation_deg) | other_plane)

    def command(
        self,
        elevation_deg: Array | float,
        plane_deg: Array | float,
        axial_deg: Array | float,
        shrug_deg: Array | float,
        protraction_deg: Array | float,
        closure: Closure,
        extent: Extent,
    ) -> Command:
        if closure == "table" and extent == "whole":
            raise ValueError("nothing is measured outside the table for its own closure")
        theta_deg, psi_deg = self.answerable(elevation_deg, plane_deg, extent)
        return Command(
            *(
                np.radians(np.broadcast_to(value, theta_deg.shape))
                for value in (theta_deg, psi_deg, axial_deg, shrug_deg, protraction_deg)
            )
        )

    def solve(
        self,
        elevation_deg: Array | float,
        plane_deg: Array | float,
        axial_deg: Array | float = 0.0,
        shrug_deg: Array | float = 0.0,
        protraction_deg: Array | float = 0.0,
        closure: Closure = "exact",
        extent: Extent = "whole",
    ) -> SmoothPoses:
        elevation_deg, plane_deg = (
            np.atleast_1d(np.asarray(value, dtype=float)) for value in (elevation_deg, plane_deg)
        )
        command = self.command(
            elevation_deg, plane_deg, axial_deg, shrug_deg, protraction_deg, closure, extent
        )
        theta_deg, psi_deg = self.answerable(elevation_deg, plane_deg, extent)
        rotations, additions = self.rotations_and_additions(command, closure, extent)
        share = additions.pop("share")
        angles_deg: dict[str, Array] = {}
        for joint, q in rotations.items():
            angles = euler_angles_deg(JOINT_SEQUENCES[joint], q)
            angles_deg.update(zip(JOINT_COORDINATES[joint], angles, strict=True))
        angles_deg["gh_axial"] = in_axial_window_deg(angles_deg["gh_axial"])
        clamped = self.is_answered_by_another(elevation_deg, plane_deg, extent)
        for name, added in additions.items():
            clamped |= added != getattr(command, name)
        return SmoothPoses(
            elevation_deg=theta_deg,
            plane_deg=psi_deg,
            **{f"{name}_deg": np.degrees(added) for name, added in additions.items()},
            clamped=clamped,
            distance_deg=distance_from_measured_deg(elevation_deg, plane_deg),
            gh_stops=share < 1.0,
            rotations=rotations,
            angles_deg=angles_deg,
        )

    def axial_on_rhythm_deg(
        self,
        elevation_deg: Array,
        plane_deg: Array,
        axial_deg: Array,
        zero: AxialFrom,
        closure: Closure = "exact",
        extent: Extent = "whole",
    ) -> Array:
        """An axial turn that is counted from another zero, counted from the rhythm's own humerus.

        The humerus that is meant is made first: of ISB's angles that were asked for, carried to the
        direction that answers, or of ISB's zero in the middle of the reach, carried there, and then
        turned. How far the rhythm's own humerus is turned until it is that one is the answer; of
        ISB's less where the direction that answers is more than 60 deg from the one asked for, and
        nothing where it is opposite.
        """
        if zero == "rhythm":
            return axial_deg
        own = self.solve(elevation_deg, plane_deg, closure=closure, extent=extent)
        to_deg = (own.elevation_deg, own.plane_deg)
        q_TH = multiply(multiply(own.rotations["sc"], own.rotations["ac"]), own.rotations["gh"])
        if closure == "table":
            # Where it was told to point, with the turn that it has.
            q_TH = multiply(swing(*np.radians(to_deg)), turns("y", twist(q_TH)))
        share = np.ones_like(elevation_deg)
        if zero == "isb":
            asked_deg = np.clip(elevation_deg, 0.0, 180.0)
            meant = carried(isb_humerus(asked_deg, plane_deg, axial_deg), *to_deg)
            cosine = np.sum(direction_deg(asked_deg, plane_deg) * direction_deg(*to_deg), axis=0)
            share = bump((0.5 - cosine) / 1.5)
        else:
            whole = np.ones_like(elevation_deg)
            start = isb_humerus(90.0 * whole, MIDDLE_DEG * whole, 0.0 * whole)
            meant = multiply(carried(start, *to_deg), turns("y", np.radians(axial_deg)))
        turn_deg = np.degrees(twist(multiply(inverses(q_TH), meant)))
        joint_deg = own.angles_deg["gh_axial"]
        lowest_deg = LOWEST_AXIAL_DEG
        wrapped_deg = lowest_deg + np.mod(joint_deg + turn_deg - lowest_deg, 360.0)
        return np.asarray(share * (wrapped_deg - joint_deg))

    def moved_or_answered(
        self,
        command: Command,
        is_other: Array,
        asked_deg: tuple[Array, Array],
        moved: tuple[float, float],
        extent: Extent,
    ) -> Command:
        """A command moved, or where another one answers it what answers the one asked for."""
        theta_deg, psi_deg = self.answerable(*asked_deg, extent)
        plain = command.moved(*moved)
        return Command(
            np.where(is_other, np.radians(theta_deg), plain.theta),
            np.where(is_other, np.radians(psi_deg), plain.psi),
            plain.axial,
            plain.shrug,
            plain.protraction,
        )

    def rates(
        self,
        elevation_deg: Array | float,
        plane_deg: Array | float,
        axial_deg: Array | float = 0.0,
        shrug_deg: Array | float = 0.0,
        protraction_deg: Array | float = 0.0,
        closure: Closure = "exact",
        extent: Extent = "whole",
    ) -> dict[str, dict[str, Array]]:
        """Angular velocities of child in parent, in the parent's axes, by joint and by command.

        w = 2 (d q / d t) q^-1, t the elevation or the plane: rad per rad. By differences upwards,
        which do not look across a border that the pose stands on:

            f' = (-3 f(0) + 4 f(h) - f(2 h)) / (2 h)
        """
        elevation_deg, plane_deg = (
            np.atleast_1d(np.asarray(value, dtype=float)) for value in (elevation_deg, plane_deg)
        )
        command = self.command(
            elevation_deg, plane_deg, axial_deg, shrug_deg, protraction_deg, closure, extent
        )
        h = 1e-6
        is_other = self.is_answered_by_another(elevation_deg, plane_deg, extent)
        result: dict[str, dict[str, Array]] = {joint: {} for joint in JOINT_SEQUENCES}
        here = self.joint_rotations(command, closure, extent)
        for name, d_theta, d_psi in (("elevation", h, 0.0), ("plane", 0.0, h)):
            once, twice = (
                self.joint_rotations(
                    self.moved_or_answered(
                        command,
                        is_other,
                        (elevation_deg + n * math.degrees(d_theta), plane_deg + n * math.degrees(d_psi)),
                        (n * d_theta, n * d_psi),
                        extent,
                    ),
                    closure,
                    extent,
                )
                for n in (1.0, 2.0)
            )
            for joint in JOINT_SEQUENCES:
                # From here, where the rotation vector is zero.
                back = inverses(here[joint])
                to_once, to_twice = (logs(multiply(q[joint], back)) for q in (once, twice))
                result[joint][name] = (4.0 * to_once - to_twice) / (2.0 * h)
        return result
