"""Curves of all hosts over one another, as SVG."""

from __future__ import annotations

from html import escape

import numpy as np

COLOURS = ["#1e1e1e", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f", "#8c564b"]

AXES = {
    "hertz": ("place across the contact, m", "pressure, Pa"),
    "balls": ("distance from the axis, m", "pressure, Pa"),
    "wedge": ("place across the contact, m", "pressure, Pa"),
    "cone": ("distance from the axis, m", "pressure, Pa"),
    "punch": ("place across the contact, m", "pressure, Pa"),
    "ironing": ("part of the slide", "force across it, N/m"),
    "wall": ("time, s", "force on the body, N/m"),
    "impact": ("time, s", "force on the body, N/m"),
    "patch": ("iteration", "residual by the load"),
}


def overlay(kind: str, curves: dict[str, np.ndarray], width: int = 760, height: int = 340) -> str:
    """Lines of different widths and dashes, the first the widest, so that those below are seen."""
    across, up = AXES.get(kind, ("", ""))
    is_log = kind == "patch"
    shown = {name: np.where(curve > 0, curve, np.nan) if is_log else curve for name, curve in curves.items()}
    y_of = (lambda y: np.log10(y)) if is_log else (lambda y: y)
    x = np.concatenate([curve[:, 0] for curve in curves.values()])
    y = np.concatenate([y_of(curve[:, 1]) for curve in shown.values()])
    y = y[np.isfinite(y)]
    left, right, top, bottom = 80, 170, 16, 46
    x_low, x_high, y_low, y_high = x.min(), x.max(), min(y.min(), 0.0) if not is_log else y.min(), y.max()

    def at(px: float, py: float) -> tuple[float, float]:
        w, h = width - left - right, height - top - bottom
        return left + w * (px - x_low) / ((x_high - x_low) or 1), top + h * (1 - (py - y_low) / ((y_high - y_low) or 1))

    parts = [f'<svg viewBox="0 0 {width} {height}" role="img" aria-label="{escape(up)} over {escape(across)}">']
    for k in range(5):
        px, py = x_low + k / 4 * (x_high - x_low), y_low + k / 4 * (y_high - y_low)
        gx, gy = at(px, py)
        parts.append(f'<line x1="{left}" x2="{width - right}" y1="{gy:.1f}" y2="{gy:.1f}" class="grid"/>')
        tick = f"1e{py:.0f}" if is_log else f"{py:.3g}"
        parts.append(f'<text x="{left - 6}" y="{gy + 4:.1f}" text-anchor="end">{tick}</text>')
        parts.append(f'<text x="{gx:.1f}" y="{height - bottom + 18}" text-anchor="middle">{px:.3g}</text>')
    middle = left + (width - left - right) / 2, top + (height - top - bottom) / 2
    parts.append(f'<text x="{middle[0]}" y="{height - 8}" text-anchor="middle">{escape(across)}</text>')
    turned = f"translate(14 {middle[1]}) rotate(-90)"
    parts.append(f'<text transform="{turned}" text-anchor="middle">{escape(up)}</text>')
    for number, (name, curve) in enumerate(shown.items()):
        points = [at(px, py) for px, py in zip(curve[:, 0], y_of(curve[:, 1])) if np.isfinite(py)]
        line = " ".join(f"{px:.1f},{py:.1f}" for px, py in points)
        dash = "" if number == 0 else f' stroke-dasharray="{4 + 2 * number} {4 + 3 * number}"'
        thick = max(7.0 - 1.6 * number, 1.4)
        colour = COLOURS[number % len(COLOURS)]
        style = f'fill="none" stroke="{colour}" stroke-width="{thick}"{dash}'
        ly = top + 12 + 18 * number
        parts.append(f'<polyline points="{line}" {style} stroke-opacity="{0.35 if number == 0 else 1}"/>')
        parts.append(f'<line x1="{width - right + 14}" x2="{width - right + 44}" y1="{ly}" y2="{ly}" {style}/>')
        parts.append(f'<text x="{width - right + 50}" y="{ly + 4}">{escape(name)}</text>')
    return "\n".join([*parts, "</svg>"])
