// The law `depth` in 2D, for two bodies that are polygons, cut into triangles about a point inside. No library is loaded: these
// are the formulas of the page "The law depth", in closed form. `make site-check` compares every number with the library.
"use strict";

const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];
const between = (p, q, t) => [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])];

// A linear function with given values at the corners of a triangle: f(x) = slope . x + constant.
function linear([p, q, r], [fp, fq, fr]) {
  const [u, v] = [minus(q, p), minus(r, p)];
  const [a, b, twice] = [fq - fp, fr - fp, cross(u, v)];
  const slope = [(a * v[1] - b * u[1]) / twice, (b * u[0] - a * v[0]) / twice];
  return { slope, at: (x) => fp + slope[0] * (x[0] - p[0]) + slope[1] * (x[1] - p[1]) };
}

function toSegment(x, p, q) {
  const along = minus(q, p);
  const t = ((x[0] - p[0]) * along[0] + (x[1] - p[1]) * along[1]) / (along[0] ** 2 + along[1] ** 2);
  return Math.hypot(...minus(x, between(p, q, Math.min(1, Math.max(0, t)))));
}

// A body at rest: its outline, counter-clockwise, and a point inside that sees all of it. The depth is 0 on the outline. At the
// point it is the distance from the outline, and linear between. Where this is not the height above the side of a triangle, the
// triangle is divided about the centre of its inscribed circle, whose depth is the radius.
function body(outline, centre = [0, 0]) {
  const nodes = [...outline, centre];
  const last = outline.length;
  const side = (k) => [outline[k], outline[(k + 1) % last]];
  const depth = Math.min(...outline.map((_, k) => toSegment(centre, ...side(k))));
  const pieces = [];
  outline.forEach((_, k) => {
    const cell = [k, (k + 1) % last, last];
    const [p, q] = side(k);
    const [a, b, c] = [minus(q, p), minus(centre, q), minus(p, centre)].map((edge) => Math.hypot(...edge));
    const height = cross(minus(q, p), minus(centre, p)) / a;
    if (Math.abs(height - depth) <= 1e-12 * height) {
      pieces.push({ cell, weights: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], depths: [0, 0, depth] });
    } else {
      const round = a + b + c;
      const middle = [b / round, c / round, a / round]; // each corner weighs as the side opposite to it
      const radius = (a * height) / round;
      pieces.push({ cell, weights: [[1, 0, 0], [0, 1, 0], middle], depths: [0, 0, radius] });
      pieces.push({ cell, weights: [[0, 1, 0], [0, 0, 1], middle], depths: [0, depth, radius] });
      pieces.push({ cell, weights: [[0, 0, 1], [1, 0, 0], middle], depths: [depth, 0, radius] });
    }
  });
  return { nodes, pieces, sides: outline.map((_, k) => [k, (k + 1) % last]) };
}

// The same body, turned about its centre by an angle and moved.
function placed(rest, [x, y], angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { ...rest, nodes: rest.nodes.map(([p, q]) => [x + c * p - s * q, y + s * p + c * q]) };
}

// Triangles of a body where it is now, each with its depth and with the shares of the three nodes of its cell.
function triangles(one) {
  return one.pieces.map(({ cell, weights, depths }) => {
    const cellCorners = cell.map((node) => one.nodes[node]);
    const at = (w) => [0, 1].map((axis) => w.reduce((sum, share, k) => sum + share * cellCorners[k][axis], 0));
    const corners = weights.map(at);
    const shares = [0, 1, 2].map((k) => linear(cellCorners, [0, 1, 2].map((other) => Number(other === k))));
    return { cell, corners, depth: linear(corners, depths), shares };
  });
}

// The part of a convex polygon on the left of the line from p to q.
function leftOf(polygon, p, q) {
  const along = minus(q, p);
  const height = polygon.map((x) => cross(along, minus(x, p)));
  return polygon.flatMap((x, k) => {
    const next = (k + 1) % polygon.length;
    const kept = height[k] >= 0 ? [x] : [];
    const crosses = height[k] >= 0 !== height[next] >= 0;
    return crosses ? [...kept, between(x, polygon[next], height[k] / (height[k] - height[next]))] : kept;
  });
}

const clipped = (polygon, [p, q, r]) => [[p, q], [q, r], [r, p]].reduce((part, line) => leftOf(part, ...line), polygon);

// The integrals of 1 and of linear functions over a convex polygon.
function integrals(polygon, functions) {
  let area = 0;
  const sums = functions.map(() => 0);
  for (let k = 2; k < polygon.length; k++) {
    const corners = [polygon[0], polygon[k - 1], polygon[k]];
    const part = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])) / 2;
    area += part;
    functions.forEach((f, n) => (sums[n] += (part * corners.reduce((sum, x) => sum + f.at(x), 0)) / 3));
  }
  return [area, ...sums];
}

// Parameters between which a segment is inside a triangle, or nothing.
function inside(p, q, corners) {
  let [from, to] = [0, 1];
  for (let k = 0; k < 3; k++) {
    const along = minus(corners[(k + 1) % 3], corners[k]);
    const [a, b] = [cross(along, minus(p, corners[k])), cross(along, minus(q, corners[k]))];
    if (a < 0 && b < 0) return null;
    if (a < 0) from = Math.max(from, a / (a - b));
    if (b < 0) to = Math.min(to, a / (a - b));
  }
  return to > from ? [from, to] : null;
}

// k/2 times the integral of the depth of `deep` over the overlap: its forces are added to both bodies. Returned: this energy, the
// area of the overlap, and the parts of the other's outline that lie in `deep`, with the depth at their ends.
function half(stiffness, other, deep, forcesOther, forcesDeep) {
  let [energy, area] = [0, 0];
  const covered = [];
  const pieces = triangles(deep);
  for (const { cell, corners, depth, shares } of pieces) {
    for (const triangle of triangles(other)) {
      const [part, below, ...moments] = integrals(clipped(corners, triangle.corners), [depth, ...shares]);
      area += part;
      energy += (stiffness / 2) * below;
      cell.forEach((node, k) => [0, 1].forEach((axis) => (forcesDeep[node][axis] += (stiffness / 2) * depth.slope[axis] * moments[k])));
    }
    for (const [start, end] of other.sides) {
      const [p, q] = [other.nodes[start], other.nodes[end]];
      const range = inside(p, q, corners);
      if (!range) continue;
      const [s, t] = range;
      const [ds, dt] = range.map((at) => Math.max(0, depth.at(between(p, q, at))));
      covered.push({ from: between(p, q, s), to: between(p, q, t), depths: [ds, dt] });
      // The force is - k/2 times the depth along the outward normal; depth and share of a node are linear along the segment.
      const normal = [q[1] - p[1], p[0] - q[0]];
      const onEnd = ((t - s) * (2 * (ds * s + dt * t) + ds * t + dt * s)) / 6;
      const onBoth = ((t - s) * (ds + dt)) / 2;
      for (const axis of [0, 1]) {
        forcesOther[start][axis] -= (stiffness / 2) * normal[axis] * (onBoth - onEnd);
        forcesOther[end][axis] -= (stiffness / 2) * normal[axis] * onEnd;
      }
    }
  }
  return { energy, area, covered };
}

// Contact of two bodies: energy, area of the overlap, forces on the nodes, contact length, largest penetration, mean pressure.
function contact(stiffness, a, b) {
  const zero = (one) => one.nodes.map(() => [0, 0]);
  const [onA, onB] = [zero(a), zero(b)];
  const [inB, inA] = [half(stiffness, a, b, onA, onB), half(stiffness, b, a, onB, onA)];
  const [ofA, ofB] = [inB, inA].map(({ covered }) => {
    const lengths = covered.map(({ from, to }) => Math.hypot(...minus(to, from)));
    const depths = covered.map((one, k) => (lengths[k] * (one.depths[0] + one.depths[1])) / 2);
    return [lengths, depths].map((parts) => parts.reduce((sum, part) => sum + part, 0));
  });
  const mean = ([length, depth]) => (length > 0 ? depth / length : 0);
  return {
    energy: inB.energy + inA.energy,
    area: inB.area,
    length: (ofA[0] + ofB[0]) / 2,
    penetration: Math.max(0, ...[inB, inA].flatMap(({ covered }) => covered.flatMap((one) => one.depths))),
    pressure: (stiffness * (mean(ofA) + mean(ofB))) / 2,
    forces: [onA, onB],
    covered: [inB.covered, inA.covered],
  };
}

if (typeof module !== "undefined") module.exports = { body, placed, contact, triangles, clipped };
