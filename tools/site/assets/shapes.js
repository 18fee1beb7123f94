// The bodies that the page offers: outlines, counter-clockwise, about a centre that sees all of each.
"use strict";

const around = (count, radius) =>
  Array.from({ length: count }, (_, k) => {
    const [r, angle] = [radius(k), (2 * Math.PI * k) / count + Math.PI / 2];
    return [r * Math.cos(angle), r * Math.sin(angle)];
  });

const SHAPES = {
  block: [[-1.3, -0.7], [1.3, -0.7], [1.3, 0.7], [-1.3, 0.7]],
  star: around(10, (k) => (k % 2 ? 0.55 : 1.2)),
  triangle: around(3, () => 1.1),
  hexagon: around(6, () => 1),
  disc: around(32, () => 0.9),
};

if (typeof module !== "undefined") module.exports = { SHAPES };
