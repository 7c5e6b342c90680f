# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
"""The published shoulder inverse kinematics, written a second time, straight and slow.

Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics". Equation numbers are theirs. The
program and the plugin are tested against this file, so nothing here is taken from them.

Frames: T thorax, C clavicle, S scapula, H humerus; x anterior, y up, z to the right. q_AB is the
rotation of frame B in frame A, a unit quaternion (w, x, y, z). Euler sequences are intrinsic:
"yxz" means Ry(first) Rx(second) Rz(third). Elevation is theta, plane of elevation is psi. A name
that ends in _deg is in degrees, a vector of log and exp is half the rotation vector in radians.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

Array = np.ndarray
Interpolation = Literal["squad", "slerp"]

# Joint, frames, Euler sequence and the coordinates in the order of that sequence.
SC_SEQUENCE = "yxz"  # q_TC
AC_SEQUENCE = "yxz"  # q_CS
GH_SEQUENCE = "xzy"  # q_SH
ST_SEQUENCE = "yxz"  # q_TS = q_TC q_CS
HUMEROTHORACIC_SEQUENCE = "yxy"  # q_TH = q_TS q_SH: plane, -elevation, axial

JOINT_SEQUENCES: dict[str, str] = {"sc": SC_SEQUENCE, "ac": AC_SEQUENCE, "gh": GH_SEQUENCE}
JOINT_COORDINATES: dict[str, tuple[str, str, str]] = {
    "sc": ("sc_protraction", "sc_elevation", "sc_rotation"),
    "ac": ("ac_internal_rotation", "ac_upward_rotation", "ac_tilt"),
    "gh": ("gh_elevation", "gh_flexion", "gh_axial"),
}
ST_COORDINATES = ("st_internal_rotation", "st_upward_rotation", "st_tilt")
COORDINATES: tuple[str, ...] = tuple(c for joint in JOINT_COORDINATES.values() for c in joint)

DATABASE = Path(__file__).resolve().parents[2] / "data" / "ludewig2009.csv"

# Below this angle (rad) sin(W)/W is 1 to the last bit of a double.
SMALL_ANGLE = 1e-9


# --- Quaternions ---------------------------------------------------------------------------------


def multiply(a: Array, b: Array) -> Array:
    """The product a b: turn by b first, then by a, both about fixed axes."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return np.array(
        [
            aw * bw - ax * bx - ay * by - az * bz,
            aw * bx + ax * bw + ay * bz - az * by,
            aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw,
        ]
    )


def inverse(q: Array) -> Array:
    """The inverse of a unit quaternion."""
    return q * np.array([1.0, -1.0, -1.0, -1.0])


def normalized(q: Array) -> Array:
    return q / np.linalg.norm(q)


def log(q: Array) -> Array:
    """u a of the unit quaternion (cos a, u sin a), a in 0..pi: half the rotation vector."""
    vector = q[1:]
    sine = float(np.linalg.norm(vector))
    angle = math.atan2(sine, float(q[0]))
    if sine < SMALL_ANGLE:
        if q[0] < 0.0:
            raise ValueError(f"the logarithm of {q} has no axis")
        return vector.copy()
    return vector * (angle / sine)


def exp(vector: Array) -> Array:
    """The unit quaternion (cos a, u sin a) of the vector u a, the inverse of log."""
    angle = float(np.linalg.norm(vector))
    factor = math.sin(angle) / angle if angle > SMALL_ANGLE else 1.0
    return np.concatenate(([math.cos(angle)], factor * vector))


def rotation_angle_deg(a: Array, b: Array) -> float:
    """The angle of the rotation from a to b, 0..180 deg; the signs of a and b do not count."""
    difference = multiply(inverse(a), b)
    return 2.0 * math.degrees(math.atan2(np.linalg.norm(difference[1:]), abs(difference[0])))


def matrix(q: Array) -> Array:
    """The rotation matrix whose columns are the turned x, y and z axes."""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


# --- Euler angles --------------------------------------------------------------------------------


def axis_rotation(axis: str, angle_deg: float) -> Array:
    half = math.radians(angle_deg) / 2.0
    q = np.zeros(4)
    q[0] = math.cos(half)
    q["xyz".index(axis) + 1] = math.sin(half)
    return q


def quaternion_from_euler(sequence: str, angles_deg: Sequence[float]) -> Array:
    """The intrinsic rotation: each turn is about the axis as the turns before left it."""
    q = np.array([1.0, 0.0, 0.0, 0.0])
    for axis, angle_deg in zip(sequence, angles_deg, strict=True):
        q = multiply(q, axis_rotation(axis, angle_deg))
    return q


def euler_from_quaternion(sequence: str, q: Array) -> tuple[float, float, float]:
    """The angles (deg) of one of the three sequences in use.

    The second angle is in -90..90 for "yxz" and "xzy". For "yxy" it is in -180..0, the ISB choice
    for the humerus: the elevation, which is its negative, is then positive.
    """
    r = matrix(q)
    if sequence == "yxz":
        # R = Ry(a) Rx(b) Rz(c): last column (sin a cos b, -sin b, cos a cos b),
        # middle row (cos b sin c, cos b cos c, -sin b).
        first = math.atan2(r[0, 2], r[2, 2])
        second = math.atan2(-r[1, 2], math.hypot(r[1, 0], r[1, 1]))
        third = math.atan2(r[1, 0], r[1, 1])
    elif sequence == "xzy":
        # R = Rx(a) Rz(b) Ry(c): middle column (-sin b, cos a cos b, sin a cos b),
        # first row (cos b cos c, -sin b, cos b sin c).
        first = math.atan2(r[2, 1], r[1, 1])
        second = math.atan2(-r[0, 1], math.hypot(r[0, 0], r[0, 2]))
        third = math.atan2(r[0, 2], r[0, 0])
    elif sequence == "yxy":
        # R = Ry(a) Rx(b) Ry(c): middle column (sin a sin b, cos b, cos a sin b),
        # middle row (sin b sin c, cos b, -sin b cos c); sin b is negative.
        first = math.atan2(-r[0, 1], -r[2, 1])
        second = -math.atan2(math.hypot(r[1, 0], r[1, 2]), r[1, 1])
        third = math.atan2(-r[1, 0], r[1, 2])
    else:
        raise ValueError(f"no such Euler sequence: {sequence}")
    return math.degrees(first), math.degrees(second), math.degrees(third)


def elevation_and_plane_deg(q_TH: Array) -> tuple[float, float]:
    """Elevation and plane of elevation of the humerus in the thorax."""
    plane_deg, minus_elevation_deg, _ = euler_from_quaternion(HUMEROTHORACIC_SEQUENCE, q_TH)
    return -minus_elevation_deg, plane_deg


# --- Interpolation -------------------------------------------------------------------------------


def slerp(a: Array, b: Array, t: float) -> Array:
    """Equation (1), W the angle between a and b.

    slerp(a, b, t) = sin((1 - t) W) / sin(W) a + sin(t W) / sin(W) b
    """
    # An arc cosine of a . b would lose half the digits where a and b are close.
    w = 2.0 * math.atan2(np.linalg.norm(a - b), np.linalg.norm(a + b))
    if w < SMALL_ANGLE:
        return normalized((1.0 - t) * a + t * b)
    return (math.sin((1.0 - t) * w) * a + math.sin(t * w) * b) / math.sin(w)


def squad(q_i: Array, q_i1: Array, s_i: Array, s_i1: Array, t: float) -> Array:
    """Equation (4).

    squad(q_i, q_i+1, t) = slerp(slerp(q_i, q_i+1, t), slerp(s_i, s_i+1, t), 2 t (1 - t))
    """
    return slerp(slerp(q_i, q_i1, t), slerp(s_i, s_i1, t), 2.0 * t * (1.0 - t))


def inner_quaternion(q: Sequence[Array], i: int) -> Array:
    """Equation (5) inside a series of knots; at its ends s_0 = q_0 and s_n = q_n.

    s_i = q_i exp(-(log(q_i^-1 q_i+1) + log(q_i^-1 q_i-1)) / 4)
    """
    if i in (0, len(q) - 1):
        return q[i].copy()
    to_next = log(multiply(inverse(q[i]), q[i + 1]))
    to_previous = log(multiply(inverse(q[i]), q[i - 1]))
    return multiply(q[i], exp(-(to_next + to_previous) / 4.0))


def interpolate(q: Sequence[Array], i: int, t: float, interpolation: Interpolation) -> Array:
    """Between the knots i and i + 1 of a series, by squad or, in its place, by slerp."""
    if interpolation == "slerp":
        return slerp(q[i], q[i + 1], t)
    if interpolation == "squad":
        return squad(q[i], q[i + 1], inner_quaternion(q, i), inner_quaternion(q, i + 1), t)
    raise ValueError(f"no such interpolation: {interpolation}")


# --- The database --------------------------------------------------------------------------------


@dataclass(frozen=True)
class Position:
    """One row of the database, angles in degrees in the order of their Euler sequence."""

    elevation_deg: float
    plane_deg: float
    joint_angles_deg: dict[str, tuple[float, float, float]]
    st_angles_deg: tuple[float, float, float]

    def rotation(self, joint: str) -> Array:
        return quaternion_from_euler(JOINT_SEQUENCES[joint], self.joint_angles_deg[joint])

    def angles_deg(self) -> dict[str, float]:
        return {
            coordinate: angle_deg
            for joint, coordinates in JOINT_COORDINATES.items()
            for coordinate, angle_deg in zip(coordinates, self.joint_angles_deg[joint], strict=True)
        }


def read_database(path: Path = DATABASE) -> list[Position]:
    """The 66 positions in file order. Leading lines that start with # are comments."""
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))

    def angles(row: dict[str, str], coordinates: tuple[str, ...]) -> tuple[float, float, float]:
        first, second, third = (float(row[f"{coordinate}_deg"]) for coordinate in coordinates)
        return first, second, third

    return [
        Position(
            elevation_deg=float(row["elevation_deg"]),
            plane_deg=float(row["plane_deg"]),
            joint_angles_deg={j: angles(row, names) for j, names in JOINT_COORDINATES.items()},
            st_angles_deg=angles(row, ST_COORDINATES),
        )
        for row in rows
    ]


def align_signs(grid: list[list[Array]]) -> list[list[Array]]:
    """The same rotations, grid[plane][elevation], signed so that neighbours have q . q' >= 0.

    Along the first plane, then from each plane to the next. That the elevations of the other
    planes agree too is checked, not assumed.
    """
    aligned = [[q.copy() for q in plane] for plane in grid]
    for j, plane in enumerate(aligned):
        for i, q in enumerate(plane):
            neighbour = aligned[j - 1][i] if j > 0 else plane[i - 1] if i > 0 else q
            if float(neighbour @ q) < 0.0:
                plane[i] = -q
            if i > 0 and float(plane[i - 1] @ plane[i]) < 0.0:
                raise ValueError(f"signs cannot be aligned at plane {j}, elevation {i}")
    return aligned


# --- Inverse kinematics --------------------------------------------------------------------------


@dataclass(frozen=True)
class Bracket:
    """knots[index] < value <= knots[index + 1], the lowest knot belonging to the first cell."""

    index: int
    weight: float


def bracket(knots: Sequence[float], value: float) -> Bracket:
    """Equations (6) to (9), the value inside the knots.

    theta_i < theta <= theta_i+1                                    (6)
    psi_j < psi <= psi_j+1                                          (7)
    t_theta = (theta - theta_i) / 5                                 (8)
    t_psi = (psi - psi_j) / 40 if psi <= 40, else (psi - psi_j) / 50    (9)

    The 5, 40 and 50 are the widths of the cells.
    """
    index = 0
    while value > knots[index + 1]:
        index += 1
    return Bracket(index, (value - knots[index]) / (knots[index + 1] - knots[index]))


@dataclass(frozen=True)
class ShoulderPose:
    angles_deg: dict[str, float]
    rotations: dict[str, Array]  # "sc" q_TC, "ac" q_CS, "gh" q_SH
    clamped: bool
    elevation: Bracket
    plane: Bracket


class ReferenceRhythm:
    """SC, AC and GH at an elevation and a plane of elevation, each joint interpolated by itself."""

    def __init__(self, positions: list[Position]) -> None:
        self.elevations_deg = sorted({p.elevation_deg for p in positions})
        self.planes_deg = sorted({p.plane_deg for p in positions})
        by_place = {(p.plane_deg, p.elevation_deg): p for p in positions}
        self.grids: dict[str, list[list[Array]]] = {
            joint: align_signs(
                [
                    [by_place[psi, theta].rotation(joint) for theta in self.elevations_deg]
                    for psi in self.planes_deg
                ]
            )
            for joint in JOINT_SEQUENCES
        }

    def solve(
        self, elevation_deg: float, plane_deg: float, interpolation: Interpolation = "squad"
    ) -> ShoulderPose:
        """The pose at the nearest point of the domain; clamped says that this is another point."""
        theta = min(max(elevation_deg, self.elevations_deg[0]), self.elevations_deg[-1])
        psi = min(max(plane_deg, self.planes_deg[0]), self.planes_deg[-1])
        along_theta = bracket(self.elevations_deg, theta)
        along_psi = bracket(self.planes_deg, psi)

        angles_deg: dict[str, float] = {}
        rotations: dict[str, Array] = {}
        for joint, grid in self.grids.items():
            # q_j = squad(q_i,j, q_i+1,j, t_theta)              (10)
            # q_j+1 = squad(q_i,j+1, q_i+1,j+1, t_theta)        (11)
            # in every plane, for the inner quaternions of (12) need the neighbours of j and j + 1.
            planes = [
                interpolate(plane, along_theta.index, along_theta.weight, interpolation) for plane in grid
            ]
            # q = squad(q_j, q_j+1, t_psi)                      (12)
            q = interpolate(planes, along_psi.index, along_psi.weight, interpolation)
            rotations[joint] = q
            angles = euler_from_quaternion(JOINT_SEQUENCES[joint], q)
            angles_deg.update(zip(JOINT_COORDINATES[joint], angles, strict=True))

        return ShoulderPose(
            angles_deg=angles_deg,
            rotations=rotations,
            clamped=theta != elevation_deg or psi != plane_deg,
            elevation=along_theta,
            plane=along_psi,
        )
