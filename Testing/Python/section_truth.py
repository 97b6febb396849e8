"""Sections of solids in float64: which solids contain the points of a plane that a camera sees."""

import numpy as np


class View:
    """A camera's rays through the centres of pixels, in float64."""

    def __init__(self, camera, width, height):
        matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
        to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        self._to_world = np.linalg.inv(to_clip)
        x = (np.arange(width) + 0.5) / width * 2.0 - 1.0
        y = (np.arange(height) + 0.5) / height * 2.0 - 1.0
        self._x, self._y = (values.ravel() for values in np.meshgrid(x, y))
        self._width = width

    def on_plane(self, normal, offset):
        """The point of the plane at each pixel, the size of a pixel there, and whether it is between near and far."""
        plane = np.append(normal, offset) @ self._to_world
        with np.errstate(divide="ignore", invalid="ignore"):
            z = -(plane[0] * self._x + plane[1] * self._y + plane[3]) / plane[2]
        seen = np.abs(z) < 0.9999
        z = np.where(seen, z, 0.0)
        place = self._unproject(self._x, z)
        beside = self._unproject(self._x + 2.0 / self._width, z)
        return place, np.linalg.norm(beside - place, axis=1), seen

    def rays(self):
        """Directions away from the eye, of length 1."""
        far = self._unproject(self._x, np.ones_like(self._x))
        near = self._unproject(self._x, -np.ones_like(self._x))
        along = far - near
        return along / np.linalg.norm(along, axis=1)[:, None]

    def _unproject(self, x, z):
        place = np.stack([x, self._y, z, np.ones_like(z)]) .T @ self._to_world.T
        return place[:, :3] / place[:, 3:]


def contains(points, triangles, normal, offset, places):
    """Whether the solid contains points of a plane, and their distances from its surface.

    Points of the solid in the plane count as beyond it, on the normal's side, so the answer is that of a plane moved
    against its normal by next to nothing. Faces in the plane do not count for the distances.
    """
    side = points @ normal + offset
    side[np.abs(side) < 1e-7 * np.abs(points).max()] = 0.0
    first, second = _axes(normal)
    here = np.stack([places @ first, places @ second], axis=1)
    odd = np.zeros(len(places), bool)
    distance = np.full(len(places), np.inf)
    for corners in triangles:
        sides = side[corners]
        if not sides.any():
            continue
        distance = np.minimum(distance, _distances(points[corners], places))
        kept = sides >= 0.0
        if kept.all() or not kept.any():
            continue
        ends = []
        for i, j in ((0, 1), (1, 2), (2, 0)):
            if kept[i] != kept[j]:
                # From the lower index on, so that triangles of an edge find the same point.
                a, b = sorted((corners[i], corners[j]))
                share = side[a] / (side[a] - side[b])
                ends.append(points[a] + share * (points[b] - points[a]))
        (u0, v0), (u1, v1) = ((end @ first, end @ second) for end in ends)
        spans = (v0 > here[:, 1]) != (v1 > here[:, 1])
        if spans.any():
            crossing = u0 + (here[spans, 1] - v0) / (v1 - v0) * (u1 - u0)
            odd[spans] ^= crossing > here[spans, 0]
    return odd, distance


def _axes(normal):
    other = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(other, normal)
    first /= np.linalg.norm(first)
    return first, np.cross(normal, first)


def _distances(triangle, places):
    """Distances of points from a triangle."""
    a, b, c = triangle
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal)
    distance = np.full(len(places), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        along = q - p
        size = along @ along
        share = np.clip((places - p) @ along / size, 0.0, 1.0) if size > 0.0 else np.zeros(len(places))
        distance = np.minimum(distance, np.linalg.norm(places - (p + share[:, None] * along), axis=1))
    if length > 0.0:
        unit = normal / length
        within = np.ones(len(places), bool)
        for p, q in ((a, b), (b, c), (c, a)):
            within &= (places - p) @ np.cross(unit, q - p) >= 0.0
        distance = np.where(within, np.abs((places - a) @ unit), distance)
    return distance


def crossings(points, triangles, places, rays):
    """Whether lines from `places` along `rays` cross a mesh an odd number of times, ahead and behind.

    Also returns where the answer is clear: the line stays clear of all edges.
    """
    ahead, behind = np.zeros(len(places), bool), np.zeros(len(places), bool)
    clear = np.ones(len(places), bool)
    for corners in triangles:
        a, b, c = points[corners]
        normal = np.cross(b - a, c - a)
        facing = rays @ normal
        with np.errstate(divide="ignore", invalid="ignore"):
            t = (a - places) @ normal / facing
            hit = places + t[:, None] * rays
            shares = np.stack([np.cross(q - p, hit - p) @ normal for p, q in ((a, b), (b, c), (c, a))])
        shares = shares / max(normal @ normal, 1e-300)
        inside = (shares >= 0.0).all(axis=0)
        # An edge is near if a share is small, and the hit is on the edge rather than on its line.
        near = (np.abs(shares) < 0.02).any(axis=0) & (shares > -0.02).all(axis=0)
        clear &= ~near & ~(inside & (np.abs(t) < 0.01))
        ahead ^= inside & (t > 0.0)
        behind ^= inside & (t < 0.0)
    return ahead, behind, clear
