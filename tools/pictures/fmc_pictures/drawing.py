"""Pictures as SVG: frames with scenes or curves, in few colours, on white, so that they can be read on light and dark pages alike."""

import html

import numpy as np

LOWER, UPPER, THIRD, FOURTH = "#0072b2", "#d55e00", "#009e73", "#cc79a7"
DARK = "#222"
WIDTH = 720
SIZE = 15


def number(value):
    return f"{value:.1f}".removesuffix(".0").replace("-0", "0") if abs(value) < 0.05 else f"{value:.1f}".removesuffix(".0")


def path(points):
    return "L".join(f"{number(x)} {number(y)}" for x, y in points)


class Picture:
    """Frames and texts, in pixels from the upper left corner."""

    def __init__(self, height, title, width=WIDTH):
        self.parts, self.clips = [], 0
        self.width, self.height, self.title = width, height, title

    def add(self, part):
        self.parts.append(part)

    def text(self, at, words, anchor="middle", colour=DARK, size=SIZE, bold=False):
        x, y = at
        weight = ' font-weight="bold"' if bold else ""
        small = f' font-size="{size}"' if size != SIZE else ""
        self.add(f'<text x="{number(x)}" y="{number(y)}" text-anchor="{anchor}" fill="{colour}"{small}{weight}>{html.escape(words)}</text>')

    def key(self, at, colour, words, line=False):
        """A sign of the legend, with its words."""
        x, y = at
        if line:
            self.add(f'<path d="M{number(x)} {number(y - 5)}h22" stroke="{colour}" stroke-width="2.5"/>')
        else:
            self.add(f'<circle cx="{number(x + 16)}" cy="{number(y - 5)}" r="5" fill="{colour}"/>')
        self.text((x + 28, y), words, "start")

    def svg(self):
        size = f'viewBox="0 0 {self.width} {self.height}" width="{self.width}" height="{self.height}"'
        font = f'font-family="system-ui,Helvetica,Arial,sans-serif" font-size="{SIZE}"'
        head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} {font} role="img">\n<title>{html.escape(self.title)}</title>'
        return "\n".join([head, '<rect width="100%" height="100%" rx="8" fill="#fff"/>', *self.parts, "</svg>\n"])


class Frame:
    """A box of the picture with coordinates of its own.

    box: left, top, width, height in pixels; x, y: the ranges. With ``equal`` a unit is as long in y as in x, about the middle of ``y``.
    """

    def __init__(self, picture, box, x, y, equal=False):
        left, top, width, height = box
        if equal:
            middle, half = (y[0] + y[1]) / 2, (x[1] - x[0]) * height / width / 2
            y = (middle - half, middle + half)
        self.picture, self.box, self.x, self.y = picture, box, x, y
        self.scale = np.array([width / (x[1] - x[0]), -height / (y[1] - y[0])])
        self.origin = np.array([left - x[0] * self.scale[0], top + height - y[0] * self.scale[1]])
        self.clip = f"c{picture.clips}"
        picture.clips += 1
        picture.add(f'<clipPath id="{self.clip}"><path d="M{left} {top}h{width}v{height}h-{width}z"/></clipPath>')

    def at(self, points):
        return np.asarray(points, float) * self.scale + self.origin

    def shapes(self, polygons, fill="none", stroke="#fff", width=0.8, opacity=1.0):
        """Closed polygons, as one path."""
        outline = "".join(f"M{path(self.at(one))}Z" for one in polygons)
        see = f' fill-opacity="{opacity}"' if opacity < 1 else ""
        line = f' stroke="{stroke}" stroke-width="{width}"' if stroke else ""
        self.picture.add(f'<path clip-path="url(#{self.clip})" d="{outline}" fill="{fill}"{see}{line}/>')

    def mesh(self, coords, cells, colour, opacity=0.45):
        """Cells of a body, with the lines of its mesh."""
        self.shapes(coords[np.asarray(cells)][..., :2], colour, opacity=opacity)

    def line(self, points, colour=DARK, width=2.5):
        outline = f'd="M{path(self.at(points))}" fill="none" stroke-linejoin="round"'
        self.picture.add(f'<path clip-path="url(#{self.clip})" {outline} stroke="{colour}" stroke-width="{width}"/>')

    def dots(self, points, colour, radius=3.5):
        circles = "".join(f'<circle cx="{number(x)}" cy="{number(y)}" r="{radius}"/>' for x, y in self.at(points))
        self.picture.add(f'<g fill="{colour}">{circles}</g>')

    def arrows(self, points, vectors, colour, scale, width=2.2):
        """Arrows from points; ``scale``: pixels for a vector of length 1. Those shorter than 3 pixels are left out."""
        parts = []
        for start, vector in zip(self.at(points), np.asarray(vectors, float) * [scale, -scale]):
            length = np.hypot(*vector)
            if length < 3:
                continue
            along, end = vector / length, start + vector
            side, tip = np.array([-along[1], along[0]]), min(8.0, 0.6 * length)
            wings = [end - tip * along + 0.45 * tip * side, end, end - tip * along - 0.45 * tip * side]
            parts.append(f"M{path([start, end])}M{path(wings)}")
        self.picture.add(f'<path d="{"".join(parts)}" fill="none" stroke="{colour}" stroke-width="{width}"/>')

    def text(self, at, words, anchor="middle", colour=DARK, size=SIZE):
        self.picture.text(self.at(at), words, anchor, colour, size)

    def axes(self, across="", up="", ticks_x=(), ticks_y=()):
        """Lines of the axes, with ticks (value, words) and names."""
        left, top, width, height = self.box
        self.picture.add(f'<path d="M{left} {top}v{height}h{width}" fill="none" stroke="{DARK}"/>')
        for value, words in ticks_x:
            x = self.at((value, self.y[0]))[0]
            self.picture.add(f'<path d="M{number(x)} {top + height}v5" stroke="{DARK}"/>')
            self.picture.text((x, top + height + 19), words, size=13)
        for value, words in ticks_y:
            y = self.at((self.x[0], value))[1]
            self.picture.add(f'<path d="M{left} {number(y)}h-5" stroke="{DARK}"/>')
            self.picture.text((left - 8, y + 4), words, "end", size=13)
        if across:
            self.picture.text((left + width / 2, top + height + (38 if ticks_x else 20)), across)
        if up:
            self.picture.text((left, top - 9), up, "start")
