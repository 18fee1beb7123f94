// Two bodies to drag: what the law says of them is drawn and printed at each move.
"use strict";

const scene = document.getElementById("scene");
const STIFFNESS = 1;
const WIDE = 6; // the picture's width in the bodies' units
const STARTS = [{ shape: "block", at: [0, -0.75], angle: 0 }, { shape: "triangle", at: [0.25, 0.62], angle: Math.PI + 0.15 }];
const bodies = STARTS.map((start) => ({ ...start }));
let chosen = 1;
let held = null;

const rest = (one) => body(SHAPES[one.shape]);
const now = (one) => placed(rest(one), one.at, one.angle);
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const handle = (one) => [one.at[0] + 0.42 * Math.cos(one.angle + Math.PI / 2), one.at[1] + 0.42 * Math.sin(one.angle + Math.PI / 2)];

function pen() {
  const [width, height, ratio] = [scene.clientWidth, scene.clientHeight, window.devicePixelRatio || 1];
  [scene.width, scene.height] = [width * ratio, height * ratio];
  const context = scene.getContext("2d");
  const unit = width / WIDE;
  context.setTransform(unit * ratio, 0, 0, -unit * ratio, (width / 2) * ratio, (height / 2) * ratio);
  context.lineWidth = 1.5 / unit;
  context.lineJoin = "round";
  return { context, unit };
}

function outline(context, points) {
  context.beginPath();
  points.forEach((x, k) => (k ? context.lineTo(...x) : context.moveTo(...x)));
  context.closePath();
}

function arrow({ context, unit }, from, vector, thick) {
  const [to, length] = [[from[0] + vector[0], from[1] + vector[1]], Math.hypot(...vector)];
  if (length * unit < 2) return;
  const [head, along] = [Math.min(11 / unit, length / 2), vector.map((v) => v / length)];
  context.lineWidth = thick / unit;
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(to[0] - along[0] * head, to[1] - along[1] * head);
  context.stroke();
  outline(context, [to, ...[0.45, -0.45].map((side) => [0, 1].map((k) => to[k] - head * (along[k] + side * [-along[1], along[0]][k])))]);
  context.fill();
}

// The overlap, in strips of equal g_A + g_B: a linear function on each common part of two triangles.
function shade({ context }, [a, b], largest) {
  for (const one of triangles(a)) {
    for (const other of triangles(b)) {
      const part = clipped(one.corners, other.corners);
      if (part.length < 3) continue;
      const depth = (x) => one.depth.at(x) + other.depth.at(x);
      const slope = [0, 1].map((k) => one.depth.slope[k] + other.depth.slope[k]);
      const size = slope[0] ** 2 + slope[1] ** 2;
      const alpha = (value) => `rgba(118, 42, 131, ${0.15 + 0.75 * Math.min(1, Math.max(0, value / largest))})`;
      if (size > 1e-12) {
        const start = part[0].map((x, k) => x - (depth(part[0]) * slope[k]) / size);
        const end = start.map((x, k) => x + (largest * slope[k]) / size);
        const ramp = context.createLinearGradient(...start, ...end);
        ramp.addColorStop(0, alpha(0));
        ramp.addColorStop(1, alpha(largest));
        context.fillStyle = ramp;
      } else {
        context.fillStyle = alpha(depth(part[0]));
      }
      outline(context, part);
      context.fill();
    }
  }
}

// Pressure along the outline of one body inside the other, as a comb that stands on it.
function comb({ context, unit }, covered) {
  context.lineWidth = 1.2 / unit;
  for (const { from, to, depths } of covered) {
    const along = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(...along);
    const outward = [along[1] / length, -along[0] / length];
    const tooth = (t) => [0, 1].map((k) => from[k] + t * along[k] + STIFFNESS * (depths[0] + t * (depths[1] - depths[0])) * outward[k]);
    outline(context, [from, to, tooth(1), tooth(0)]);
    context.globalAlpha = 0.18;
    context.fill();
    context.globalAlpha = 1;
    const count = Math.max(1, Math.round((length * unit) / 7));
    for (let k = 0; k <= count; k++) {
      context.beginPath();
      context.moveTo(from[0] + (k / count) * along[0], from[1] + (k / count) * along[1]);
      context.lineTo(...tooth(k / count));
      context.stroke();
    }
  }
}

// Sum of forces on the nodes of a body, and the point of its line of action nearest to the middle of the contact.
function resultant(nodes, forces, near) {
  const sum = forces.reduce(([x, y], f) => [x + f[0], y + f[1]], [0, 0]);
  const moment = nodes.reduce((total, x, k) => total + (x[0] - near[0]) * forces[k][1] - (x[1] - near[1]) * forces[k][0], 0);
  const size = sum[0] ** 2 + sum[1] ** 2;
  return { sum, moment, at: size > 0 ? [near[0] - (moment * sum[1]) / size, near[1] + (moment * sum[0]) / size] : near };
}

function numbers(result, [onFirst, onSecond]) {
  const format = (x) => (Math.abs(x) < 5e-7 ? "0" : x.toPrecision(4));
  const rows = [
    ["Overlap area", format(result.area)], ["Energy", format(result.energy)], ["Contact length", format(result.length)],
    ["Largest penetration", format(result.penetration)], ["Mean pressure", format(result.pressure)],
    ["Force on orange", onSecond.sum.map(format).join(", ")], ["Force on blue", onFirst.sum.map(format).join(", ")],
  ];
  document.getElementById("numbers").innerHTML = rows.map(([name, value]) => `<div><dt>${name}</dt><dd>${value.replace(/-/g, "−")}</dd></div>`).join("");
}

function draw() {
  const placedNow = bodies.map(now);
  const result = contact(STIFFNESS, ...placedNow);
  const paper = pen();
  const { context, unit } = paper;
  const colours = ["--first", "--second"].map(colour);
  placedNow.forEach((one, k) => {
    context.strokeStyle = context.fillStyle = colours[k];
    outline(context, one.nodes.slice(0, -1));
    context.globalAlpha = 0.22;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = (k === chosen ? 2.4 : 1.5) / unit;
    context.stroke();
    if (document.getElementById("cells").checked) {
      context.lineWidth = 0.7 / unit;
      triangles(one).forEach(({ corners }) => { outline(context, corners); context.stroke(); });
    }
    context.beginPath();
    context.arc(...handle(bodies[k]), 6 / unit, 0, 2 * Math.PI);
    context.fill();
    context.beginPath();
    context.moveTo(...bodies[k].at);
    context.lineTo(...handle(bodies[k]));
    context.lineWidth = 1 / unit;
    context.stroke();
  });
  shade(paper, placedNow, Math.max(0.05, 2 * result.penetration));
  const ends = result.covered.flat().flatMap(({ from, to }) => [from, to]);
  const middle = [0, 1].map((k) => (ends.length ? ends.reduce((sum, x) => sum + x[k], 0) / ends.length : 0));
  const sums = placedNow.map((one, k) => resultant(one.nodes, result.forces[k], middle));
  const longest = Math.max(...sums.map(({ sum }) => Math.hypot(...sum)));
  // Forces of very different size are all seen: the length grows as the square root.
  const scale = longest > 0 ? Math.min(1.3, 1.6 * Math.sqrt(longest)) / longest : 0;
  placedNow.forEach((one, k) => {
    context.strokeStyle = context.fillStyle = colours[k];
    comb(paper, result.covered[k]);
    if (document.getElementById("nodal").checked) {
      one.nodes.forEach((x, n) => arrow(paper, x, result.forces[k][n].map((f) => f * scale), 1.5));
    }
    arrow(paper, sums[k].at, sums[k].sum.map((f) => f * scale), 4);
  });
  numbers(result, sums);
}

function place(event) {
  const box = scene.getBoundingClientRect();
  const unit = box.width / WIDE;
  return [(event.clientX - box.left - box.width / 2) / unit, (box.height / 2 - (event.clientY - box.top)) / unit];
}

const isInside = (x, points) => points.reduce((count, p, k) => {
  const q = points[(k + 1) % points.length];
  return count ^ (p[1] > x[1] !== q[1] > x[1] && x[0] < p[0] + ((x[1] - p[1]) / (q[1] - p[1])) * (q[0] - p[0]));
}, 0);

scene.addEventListener("pointerdown", (event) => {
  const x = place(event);
  const reach = 16 / (scene.clientWidth / WIDE);
  const turned = [1, 0].find((k) => Math.hypot(...minus(x, handle(bodies[k]))) < reach);
  const moved = [1, 0].find((k) => isInside(x, now(bodies[k]).nodes.slice(0, -1)));
  const found = turned ?? moved;
  if (found === undefined) return;
  chosen = found;
  held = { turns: turned !== undefined, from: minus(bodies[found].at, x) };
  if (event.isTrusted) scene.setPointerCapture(event.pointerId); // a test has no pointer to capture
  draw();
});
scene.addEventListener("pointermove", (event) => {
  if (!held) return;
  const [x, one] = [place(event), bodies[chosen]];
  if (held.turns) one.angle = Math.atan2(x[1] - one.at[1], x[0] - one.at[0]) - Math.PI / 2;
  else one.at = [0, 1].map((k) => Math.max(-2.9, Math.min(2.9, x[k] + held.from[k])));
  draw();
});
for (const end of ["pointerup", "pointercancel"]) scene.addEventListener(end, () => (held = null));
scene.addEventListener("keydown", (event) => {
  const one = bodies[chosen];
  const [moves, turns] = [{ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key], { q: 1, e: -1 }[event.key.toLowerCase()]];
  if (!moves && !turns) return;
  event.preventDefault();
  if (moves) one.at = one.at.map((x, k) => x + 0.02 * moves[k]);
  if (turns) one.angle += turns * 0.02;
  draw();
});
["first", "second"].forEach((id, k) => {
  const list = document.getElementById(id);
  list.append(...Object.keys(SHAPES).map((name) => new Option(name, name, false, name === bodies[k].shape)));
  list.addEventListener("change", () => { bodies[k].shape = list.value; draw(); });
});
document.getElementById("again").addEventListener("click", () => {
  STARTS.forEach((start, k) => { bodies[k] = { ...start }; document.getElementById(["first", "second"][k]).value = start.shape; });
  draw();
});
for (const id of ["cells", "nodal"]) document.getElementById(id).addEventListener("change", draw);
new ResizeObserver(draw).observe(scene);
new MutationObserver(draw).observe(document.documentElement, { attributes: true });
draw();
