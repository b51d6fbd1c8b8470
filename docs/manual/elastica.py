"""The elastica: an Euler-Bernoulli beam of any deflection, by quadrature. L = 1, EI = 1.

A cantilever along x under a force alpha along y at its tip. With the angle t of the tangent and the
stretch e = alpha sin t / EA, balance of moments integrates once to
t'^2 = 2 alpha (sin T - sin t) + alpha^2 (sin^2 T - sin^2 t) / EA, T the angle of the tip. The
substitution t = T (1 - z^2) takes the singular end away.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_X, _W = np.polynomial.legendre.leggauss(12)
_PIECES = np.linspace(0.0, 1.0, 61)


@dataclass(frozen=True)
class Curve:
    """Points from the tip to the root: place along the axis, coordinates, angle of the tangent, moment."""

    s: np.ndarray
    x: np.ndarray
    y: np.ndarray
    angle: np.ndarray
    moment: np.ndarray

    @property
    def slope(self) -> float:
        """Angle of the tip, rad."""
        return float(self.angle[0])

    @property
    def u(self) -> float:
        """Shortening of the tip."""
        return 1.0 - float(self.x[0])

    @property
    def v(self) -> float:
        """Deflection of the tip."""
        return float(self.y[0])


def _bending(alpha: float, tip: float, compliance: float, t):
    """t' where the angle is t, which is the moment too."""
    rise = 2.0 * np.cos((tip + t) / 2.0) * np.sin((tip - t) / 2.0)
    return np.sqrt(2.0 * alpha * rise + alpha**2 * compliance * rise * (np.sin(tip) + np.sin(t)))


def _integrals(alpha: float, tip: float, compliance: float) -> np.ndarray:
    """Cumulative integrals of ds, dx, dy from the tip on, a row for each piece."""
    low, high = _PIECES[:-1, None], _PIECES[1:, None]
    z = low + (high - low) * (_X + 1.0) / 2.0
    weight = (high - low) * _W / 2.0
    t = tip * (1.0 - z * z)
    arc = 2.0 * tip * z / _bending(alpha, tip, compliance, t) * weight
    stretch = 1.0 + alpha * np.sin(t) * compliance
    parts = [arc, arc * stretch * np.cos(t), arc * stretch * np.sin(t)]
    return np.stack([np.cumsum(p.sum(axis=1)) for p in parts], axis=1)


def tip_force(alpha: float, ea: float = np.inf) -> Curve:
    """The cantilever under a transverse force alpha EI / L^2 of fixed direction."""
    low, high = 0.0, np.pi / 2.0
    for _ in range(60):
        tip = (low + high) / 2.0
        # A larger angle at the tip needs a longer beam.
        if _integrals(alpha, tip, 1.0 / ea)[-1, 0] < 1.0:
            low = tip
        else:
            high = tip
    sums = _integrals(alpha, tip, 1.0 / ea)
    from_tip = np.vstack([[0.0, 0.0, 0.0], sums])
    along, x, y = (from_tip[-1] - from_tip).T
    angle = tip * (1.0 - _PIECES**2)
    return Curve(along, x, y, angle, _bending(alpha, tip, 1.0 / ea, angle))


def by_elliptic_integrals(alpha: float) -> tuple[float, float]:
    """u and v of the inextensible cantilever from Legendre's integrals (Bisshopp and Drucker 1945)."""

    def legendre(phi: float, k: float) -> tuple[float, float]:
        low, high = phi * _PIECES[:-1, None], phi * _PIECES[1:, None]
        t = low + (high - low) * (_X + 1.0) / 2.0
        root = np.sqrt(1.0 - (k * np.sin(t)) ** 2)
        weight = (high - low) * _W / 2.0
        return float((weight / root).sum()), float((weight * root).sum())

    def parts(k: float) -> tuple[float, float]:
        start = np.arcsin(1.0 / (k * np.sqrt(2.0)))
        (whole_f, whole_e), (start_f, start_e) = legendre(np.pi / 2.0, k), legendre(start, k)
        return whole_f - start_f, whole_e - start_e

    low, high = np.sqrt(0.5), 1.0 - 1e-12
    for _ in range(80):
        k = (low + high) / 2.0
        if parts(k)[0] ** 2 < alpha:
            low = k
        else:
            high = k
    _, e = parts(k)
    return 1.0 - np.sqrt(2.0 * (2.0 * k * k - 1.0) / alpha), 1.0 - 2.0 * e / np.sqrt(alpha)


def circle(moment: float, points: int = 200) -> tuple[np.ndarray, np.ndarray]:
    """The arc under an end moment EI / L times this."""
    s = np.linspace(0.0, 1.0, points)
    return np.sin(moment * s) / moment, (1.0 - np.cos(moment * s)) / moment
