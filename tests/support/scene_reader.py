# SPDX-License-Identifier: Apache-2.0
"""Reads a scene as docs/scene_format.md says, with nothing of the package: what the viewer would see."""

from __future__ import annotations

import base64
import gzip
import json
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation


class Seen:
    """A scene read from its two texts."""

    def __init__(self, header: str, numbers: str) -> None:
        self.header: dict[str, Any] = json.loads(header)
        self.data = gzip.decompress(base64.b64decode(numbers))
        assert self.header["format"] == "pitchpoint-scene-2"

    def array(self, where: dict[str, Any]) -> np.ndarray:
        shape = tuple(where["shape"])
        assert where["at"] % 8 == 0
        if where["type"] == "planes":
            found = self.planes(where, shape)
        else:
            kind = {"f8": "<f8", "f4": "<f4", "u4": "<u4", "u2": "<u2", "u1": "u1"}[where["type"]]
            found = np.frombuffer(self.data, kind, int(np.prod(shape)), where["at"]).reshape(shape)
        found = found * np.asarray(where["scale"]) if "scale" in where else found
        if "mix" in where:
            found = found @ np.asarray(where["mix"]).reshape(shape[1], -1)
        found = found + np.asarray(where["offset"]) if "offset" in where else found
        return np.exp(found) if where.get("exponent") else found

    def planes(self, where: dict[str, Any], shape: tuple[int, ...]) -> np.ndarray:
        """Whole numbers from the bytes of their differences."""
        length = int(np.prod(shape))
        stored = np.zeros(length, np.int64)
        for p in range(where["bytes"]):
            stored += (
                np.frombuffer(self.data, "u1", length, where["at"] + p * length).astype(np.int64) << 8 * p
            )
        stored = np.where(stored & 1, -(stored + 1) // 2, stored // 2)
        rows = shape[-1] if where.get("across") else shape[0]
        columns = stored.reshape(length // max(rows, 1), rows)
        if where["differences"] == 0:
            columns[:, 1:] += columns[:, :1]
        elif where["differences"] == 2:
            columns[:, 1:] = np.cumsum(columns[:, 1:], axis=1)
        columns = np.cumsum(columns, axis=1) if where["differences"] else columns
        return (columns if where.get("across") else columns.T).reshape(shape)

    def channel(self, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Instants, least, most and mean value of a curve."""
        entry = next(c for c in self.header["channels"] if c["name"] == name)
        table, column = entry["curve"]
        curve = self.header["curves"][table]
        least = self.array(curve["least"])[:, column]
        span, share = (self.array(curve[k])[:, column] if k in curve else 0 for k in ("span", "mean"))
        offset, step = entry["from"]
        return self.array(curve["times"]), *(offset + step * (least + k * span) for k in (0, 1, share / 63))

    @property
    def times(self) -> np.ndarray:
        return self.array(self.header["times"])

    def body(self, name: str) -> int:
        return [b["name"] for b in self.header["bodies"]].index(name)

    def pose(self, b: int, frame: int) -> tuple[np.ndarray, np.ndarray]:
        """Origin and spinning axes of a body in the world."""
        if b < 0:
            return np.zeros(3), np.eye(3)
        body = self.header["bodies"][b]

        def track(key: str, zero: Any) -> Any:
            if key not in body:
                return zero
            table = self.array(body[key])
            return table[frame if len(table) > 1 else 0]

        axes = Rotation.from_quat(body["axes"]).as_matrix()
        place = np.array(body["place"]) + axes @ (
            track("position", np.zeros(3)) + track("travel", np.zeros(3))
        )
        angle = body.get("ratio", 1.0) * track("gross", 0.0) + track("spin", 0.0)
        turn = Rotation.from_rotvec(track("turn", np.zeros(3)))
        if "quaternion" in body:
            turn = Rotation.from_quat(track("quaternion", None))
        turn = turn * Rotation.from_rotvec([0.0, 0.0, angle])
        origin, base = self.pose(body["parent"], frame)
        return origin + base @ place, base @ axes @ turn.as_matrix()

    def solid(self, name: str) -> dict[str, Any]:
        return next(s for s in self.header["solids"] if s["name"] == name)

    def mesh(self, name: str, level: int = -1) -> tuple[np.ndarray, np.ndarray]:
        """Points of a solid in its body, all copies of its pieces in one fineness, and triangles."""
        solid = self.solid(name)
        points, triangles, count = [], [], 0
        parts = solid.get("pieces") or [{"levels": [solid]}]
        for part in parts:
            surface = part["levels"][level]
            corners = self.array(surface["points"]).astype(float)
            faces = self.array(surface["triangles"]).astype(int)
            for turn in self.array(part["turns"]) if "turns" in part else [0.0]:
                turned = Rotation.from_rotvec([0.0, 0.0, turn]).as_matrix()
                points.append(corners @ turned.T)
                triangles.append(faces + count)
                count += len(corners)
        seat = Rotation.from_quat(solid.get("axes", [0.0, 0.0, 0.0, 1.0])).as_matrix()
        return np.concatenate(points) @ seat.T + solid.get("place", [0.0] * 3), np.concatenate(triangles)

    def placed(self, name: str, frame: int) -> np.ndarray:
        """Corners of a solid in the world."""
        solid = self.solid(name)
        points = self.mesh(name)[0]
        if "between" in solid:
            return self._between(solid["between"], points, frame)
        if "blend" not in solid:
            origin, axes = self.pose(solid["body"], frame)
            return origin + points @ axes.T
        blend = solid["blend"]
        poses = [self.pose(b, frame) for b in blend["bodies"]]
        rests = [self.rest(b) for b in blend["bodies"]]
        at_rest = rests[0][0] + points @ rests[0][1].T
        moved = np.stack([p + (at_rest - r) @ q @ a.T for (p, a), (r, q) in zip(poses, rests, strict=True)])
        rows = np.arange(len(points))
        w = self.array(blend["weight"])[:, None]
        return (1.0 - w) * moved[self.array(blend["first"]), rows] + w * moved[
            self.array(blend["second"]), rows
        ]

    def _between(self, stretched: dict[str, Any], points: np.ndarray, frame: int) -> np.ndarray:
        """Points whose third axis goes from one end to the other; those across it lie somewhere around it."""
        poses = [self.pose(b, frame) for b in stretched["bodies"]]
        a, b = (o + m @ np.array(end) for (o, m), end in zip(poses, stretched["ends"], strict=True))
        z = (b - a) / np.linalg.norm(b - a)
        x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
        x /= np.linalg.norm(x)
        return a + points @ np.array([x, np.cross(z, x), b - a])

    def rest(self, b: int) -> tuple[np.ndarray, np.ndarray]:
        if b < 0:
            return np.zeros(3), np.eye(3)
        body = self.header["bodies"][b]
        origin, base = self.rest(body["parent"])
        axes = Rotation.from_quat(body["axes"]).as_matrix()
        return origin + base @ np.array(body["place"]), base @ axes

    def arrow(self, name: str) -> dict[str, Any]:
        return next(a for a in self.header["arrows"] if a["name"] == name)

    def force(self, name: str, frame: int) -> np.ndarray:
        """Sum of the components of an arrow."""
        tables = [self.array(c) for c in self.arrow(name)["components"].values()]
        return sum(table[frame if len(table) > 1 else 0] for table in tables)

    def contact(self, name: str) -> dict[str, Any]:
        return next(c for c in self.header["contacts"] if c["name"] == name)

    def mesh_frame(self, contact: dict[str, Any], frame: int) -> tuple[np.ndarray, np.ndarray, float]:
        """Pitch point, axes as columns (towards gear 2, tangent, axis) and pressure angle of a mesh."""

        def row(key: str) -> Any:
            table = self.array(contact[key])
            return table[frame if len(table) > 1 else 0]

        return row("at"), Rotation.from_quat(row("axes")).as_matrix(), float(row("pressure_angle"))

    def lines(self, contact: dict[str, Any], side: int, frame: int) -> dict[int, dict[str, Any]]:
        """Contact lines of one side by the number of their pair: points in the world, force, loads."""
        flank = next(f for f in contact["flanks"] if f["side"] == side)
        origin, axes, alpha = self.mesh_frame(contact, frame)
        travel, forces, loads = (
            table[frame if len(table) > 1 else 0]
            for table in map(self.array, (flank["travel"], flank["forces"], flank["loads"]))
        )
        slope = side * np.tan(contact["base_helix"])
        normal = axes @ [np.sin(alpha), side * np.cos(alpha), 0.0]
        (low, high), (start, end) = contact["width"], contact["path"]
        found = {}
        for pair in range(int(travel / contact["base_pitch"]) - 9, int(travel / contact["base_pitch"]) + 10):
            place = travel - pair * contact["base_pitch"]
            z = np.linspace(low, high, 4001)
            z = z[(place + slope * z >= start) & (place + slope * z <= end)]
            if z.size < 2:
                continue
            z = np.linspace(z[0], z[-1], loads.shape[1])
            along, across = z, place + slope * z
            if "cone" in contact:
                R_m = contact["cone"][0]
                R, sigma = R_m * np.exp(z / R_m), (place + slope * z) / R_m
                along, across = R * np.cos(sigma) - R_m, R * np.sin(sigma)
            points = origin + np.outer(along, axes[:, 2]) + np.outer(across, normal)
            slot = pair % len(forces)
            found[pair] = {"z": z, "points": points, "force": forces[slot], "loads": loads[slot]}
        return found
