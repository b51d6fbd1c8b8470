"""The two markers of a beam in space, drawn from coordinates: what the displacements are, and which
way positive loads point. Axes: x along the beam, y up, z towards the reader."""

from __future__ import annotations

import numpy as np

# Where a unit along each axis goes on paper, which counts downwards.
_PAPER = np.array([[0.985, -0.10], [0.0, -1.0], [-0.56, 0.40]])
_LENGTH = 250.0
_X, _Y, _Z = np.eye(3)
_WIDTH = 450.0


class _Drawing:
    """Points are in the axes of J, in units of the paper."""

    def __init__(self, origin: tuple[float, float]):
        self.origin = np.array(origin)
        self.parts: list[str] = []
        self.low, self.high = self.origin, self.origin

    def at(self, point) -> np.ndarray:
        place = self.origin + np.asarray(point, float) @ _PAPER
        self.low, self.high = np.minimum(self.low, place), np.maximum(self.high, place)
        return place

    def line(self, points, style: str) -> None:
        d = "M" + "L".join(f"{x:.1f},{y:.1f}" for x, y in map(self.at, points))
        self.parts.append(f'<path class="{style}" d="{d}"/>')

    def head(self, tip, direction: np.ndarray, style: str) -> None:
        """A filled arrow head; the direction is on paper."""
        n = direction / np.linalg.norm(direction)
        across = np.array([-n[1], n[0]])
        base = tip - 9.0 * n
        corners = [tip, base + 3.4 * across, base + 2.0 * n, base - 3.4 * across]
        self.parts.append(f'<path class="{style} head" d="M{"L".join(f"{x:.1f},{y:.1f}" for x, y in corners)}z"/>')

    def arrow(self, start, end, style: str) -> None:
        a, b = self.at(start), self.at(end)
        n = (b - a) / np.linalg.norm(b - a)
        short = b - 6.0 * n
        self.parts.append(f'<path class="{style}" d="M{a[0]:.1f},{a[1]:.1f}L{short[0]:.1f},{short[1]:.1f}"/>')
        self.head(b, n, style)

    def turn(self, centre, axis: int, radius: float, style: str) -> np.ndarray:
        """A bent arrow that turns right-handedly about an axis of J; gives a point beside it."""
        u, w = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
        angles = np.linspace(np.radians(-50.0), np.radians(215.0), 40)
        ring = [np.asarray(centre) + radius * (np.cos(t) * u + np.sin(t) * w) for t in angles]
        self.line(ring[:-2], style)
        tip = self.at(ring[-1])
        self.head(tip, tip - self.at(ring[-4]), style)
        return np.asarray(centre)

    def text(self, point, label: str, style: str, shift=(0.0, 0.0), anchor: str = "middle") -> None:
        x, y = self.at(point) + np.array(shift)
        name, _, below = label.partition("_")
        sub = f'<tspan class="sub" dy="4">{below}</tspan>' if below else ""
        self.parts.append(f'<text class="{style}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{name}{sub}</text>')

    def dot(self, point, style: str) -> None:
        x, y = self.at(point)
        self.parts.append(f'<circle class="{style}" cx="{x:.1f}" cy="{y:.1f}" r="4.2"/>')

    def svg(self, title: str) -> str:
        # All drawings have one width, so that letters have one size.
        margin = (_WIDTH - (self.high - self.low)[0]) / 2.0
        top, height = self.low[1] - 30.0, (self.high - self.low)[1] + 56.0
        view = f'viewBox="{self.low[0] - margin:.0f} {top:.0f} {_WIDTH:.0f} {height:.0f}"'
        return f'<svg class="drawing" role="img" aria-label="{title}" {view}>{"".join(self.parts)}</svg>'


def _bent(end: np.ndarray, slope: np.ndarray) -> list[np.ndarray]:
    """The axis of the bent beam: clamped along x at J, along `slope` at I."""
    t = np.linspace(0.0, 1.0, 40)[:, None]
    h = [t**3 - 2 * t**2 + t, -2 * t**3 + 3 * t**2, t**3 - t**2]
    return list(h[0] * _LENGTH * _X + h[1] * end + h[2] * _LENGTH * slope)


def displacement() -> str:
    """L, x y z and a b c."""
    d = _Drawing((92, 236))
    rest = _LENGTH * _X
    step = np.array([34.0, 92.0, 50.0])
    end = rest + step
    turned = _rotation(np.radians([10.0, -10.0, 50.0]))
    d.line([(0, 0, 0), rest], "faint dashed")
    for origin in ((0, 0, 0), rest):
        d.line([np.asarray(origin) - 10 * _Y, np.asarray(origin) - 50 * _Y], "faint")
    d.arrow(0.5 * rest - 44 * _Y, -44 * _Y, "thin")
    d.arrow(0.5 * rest - 44 * _Y, rest - 44 * _Y, "thin")
    d.text(0.5 * rest - 44 * _Y, "L", "symbol", (0, -6))
    d.line(_bent(end, turned[:, 0]), "beam")
    # From where I would be without load to where it is.
    corners = [rest, rest + step[0] * _X, rest + step[0] * _X + step[1] * _Y, end]
    for a, b, label, shift in zip(corners, corners[1:], "xyz", ((4, 19), (12, 6), (9, 15))):
        d.arrow(a, b, "shift")
        d.text((np.asarray(a) + b) / 2.0, label, "symbol shift", shift)
    for axis, label, shift in ((_X, "x_J", (4, 20)), (_Y, "y_J", (0, -8)), (_Z, "z_J", (-12, 10))):
        d.arrow((0, 0, 0), 76 * axis, "axis")
        d.text(76 * axis, label, "symbol", shift)
    for axis in (_Y, _Z):
        d.line([rest, rest + 34 * axis], "faint dashed")
    for n, (label, shift) in enumerate((("a", (4, -16)), ("b", (-23, -2)), ("c", (-18, -6)))):
        d.turn(46 * np.eye(3)[n], n, 12.0, "turn")
        d.text(46 * np.eye(3)[n], label, "symbol turn", shift)
    for n, (label, shift) in enumerate((("x_I", (8, -8)), ("y_I", (-12, -4)), ("z_I", (-10, 14)))):
        d.arrow(end, end + 62 * turned[:, n], "axis own")
        d.text(end + 62 * turned[:, n], label, "symbol own", shift)
    d.dot((0, 0, 0), "point")
    d.dot(rest, "ghost")
    d.dot(end, "point own")
    d.text((0, 0, 0), "J", "point", (-14, -4))
    d.text(end, "I", "point own", (-17, 5))
    return d.svg(
        "Displacements x, y, z and rotations a, b, c of marker I from where it is without load, in the axes of J"
    )


def _rotation(angles: np.ndarray) -> np.ndarray:
    """By angles about x, then y, then z."""
    (ca, cb, cc), (sa, sb, sc) = np.cos(angles), np.sin(angles)
    about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    about_y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    about_z = np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


def loads() -> str:
    """Which way the six components are counted at both ends."""
    d = _Drawing((92, 200))
    d.line([(0, 0, 0), _LENGTH * _X], "beam")
    d.line([(0, 0, 0), _LENGTH * _X], "axis dashed inner")
    for origin, end in ((0.0 * _X, "J"), (_LENGTH * _X, "I")):
        label = [((8, 22), (0, -8), (-15, 10)), ((4, -13), (-27, 6), (25, 14))]
        for n, axis in enumerate(np.eye(3)):
            d.arrow(origin, origin + 92 * axis, "force")
            d.text(origin + 92 * axis, f"F_{'xyz'[n]}", "symbol force", label[0][n])
            d.turn(origin + 54 * axis, n, 14.0, "turn")
            shift = np.array(label[1][n]) + ((0, -8) if n == 0 else (0, 0))
            d.text(origin + 54 * axis, f"T_{'xyz'[n]}", "symbol turn", shift)
        style = "point own" if end == "I" else "point"
        d.dot(origin, style)
        d.text(origin, end, style, (-14, -6))
    d.at(-112 * _Y)
    d.text(_LENGTH * 0.5 * _X, "BEAM(id, 1, …)", "code", (-130, 100))
    d.text(_LENGTH * 0.5 * _X, "BEAM(id, 0, …)", "code", (112, 100))
    return d.svg("Positive forces and torques on I and on J, along and about the axes of J at both ends")
