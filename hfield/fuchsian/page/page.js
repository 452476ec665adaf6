"use strict";
// Complex numbers are [x, y]; a motion is [a, b] for the matrix [[a, b], [conj b, conj a]] of determinant 1,
// which maps z of the disc to (a z + b)/(conj(b) z + conj(a)). It moves 0 to b/conj(a).
const mul = (p, q) => [p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]];
const add = (p, q) => [p[0] + q[0], p[1] + q[1]];
const conj = (p) => [p[0], -p[1]];
const abs2 = (p) => p[0] * p[0] + p[1] * p[1];
const div = (p, q) => { const n = abs2(q), r = mul(p, conj(q)); return [r[0] / n, r[1] / n]; };
const act = ([a, b], z) => div(add(mul(a, z), b), add(mul(conj(b), z), conj(a)));
const inverse = ([a, b]) => [conj(a), [-b[0], -b[1]]];
function times([a, b], [c, d]) {
  const p = add(mul(a, c), mul(b, conj(d))), q = add(mul(a, d), mul(b, conj(c)));
  const size = Math.sqrt(Math.abs(abs2(p) - abs2(q))) || 1;
  return [[p[0] / size, p[1] / size], [q[0] / size, q[1] / size]];
}
const klein = (z) => { const n = 1 + abs2(z); return [2 * z[0] / n, 2 * z[1] / n]; };
const poincare = (k) => { const s = 1 + Math.sqrt(Math.max(0, 1 - abs2(k))); return [k[0] / s, k[1] / s]; };
const to = (p) => { const s = 1 / Math.sqrt(1 - abs2(p)); return [[s, 0], [p[0] * s, p[1] * s]]; };  // moves 0 to p

const CUSP = 1e-7;  // so near to the circle a vertex is a cusp

// --- domains: the polygon of the points nearer to 0 than to its images ---------------------------------

function hull(points) {  // numbers of the corners, counterclockwise
  const turn = points.map((p) => mul(p, [Math.cos(0.7), Math.sin(0.7)]));
  const order = turn.map((_, n) => n).sort((m, n) => turn[m][0] - turn[n][0]);
  const found = [];
  for (const sweep of [order, order.slice().reverse()]) {
    const start = found.length;
    for (const n of sweep) {
      while (found.length >= start + 2) {
        const p = turn[found.at(-2)], q = turn[found.at(-1)], r = turn[n];
        if ((q[0] - p[0]) * (r[1] - p[1]) > (q[1] - p[1]) * (r[0] - p[0]) + 1e-11) break;
        found.pop();
      }
      found.push(n);
    }
    found.pop();
  }
  return found;
}

function polygon(units) {
  const dual = units.map(([a, b]) => div(a, conj(b)));  // where the line halfway lies, in the dual of Klein's model
  const square = [[0.9, 0], [0, 0.9], [-0.9, 0], [0, -0.9]];
  const sides = hull(dual.concat(square)).filter((n) => n < units.length);
  const corners = sides.map((n, k) => {
    const p = dual[sides.at(k - 1)], q = dual[n], area = p[0] * q[1] - p[1] * q[0];
    return [(q[1] - p[1]) / area, (p[0] - q[0]) / area];
  });
  return { units: sides.map((n) => units[n]), dual: sides.map((n) => dual[n]), corners, used: new Set(sides) };
}

function beyond(shape, k) {  // the side beyond which a point of Klein's model lies
  let best = 1e-7, found = -1;
  shape.dual.forEach((w, n) => {
    const value = 2 * abs2(shape.units[n][1]) * (w[0] * k[0] + w[1] * k[1] - 1);
    if (value > best) { best = value; found = n; }
  });
  return found;
}

function domain(units) {  // after Voight: reduce what bounds nothing, cut off what is not paired
  const key = (g) => { const z = act(g, [0, 0]); return `${z[0].toFixed(7)},${z[1].toFixed(7)}`; };
  const tried = new Set();
  let shape;
  for (let round = 0; round < 40; round++) {
    const all = new Map();
    for (const g of units) for (const h of [g, inverse(g)]) if (abs2(h[1]) > 1e-8) all.set(key(h), h);
    units = [...all.values()];
    shape = polygon(units);
    const fresh = [];
    units.forEach((g, n) => {
      if (shape.used.has(n)) return;
      for (let step = 0; step < 200; step++) {
        const side = beyond(shape, klein(act(g, [0, 0])));
        if (side < 0) break;
        g = times(inverse(shape.units[side]), g);
      }
      if (abs2(g[1]) > 1e-8 && !tried.has(key(g))) { tried.add(key(g)); fresh.push(g); }
    });
    if (!fresh.length) shape.units.forEach((g, n) => {
      for (const corner of [shape.corners[n], shape.corners[(n + 1) % shape.corners.length]]) {
        if (abs2(corner) > 1 - CUSP) continue;
        const side = beyond(shape, klein(act(inverse(g), poincare(corner))));
        if (side < 0) continue;
        const cut = times(g, shape.units[side]);
        if (abs2(cut[1]) > 1e-8 && !tried.has(key(cut))) { tried.add(key(cut)); fresh.push(cut); }
      }
    });
    units = shape.units.concat(fresh);
    if (!fresh.length) break;
  }
  const images = shape.units.map((g) => act(g, [0, 0]));
  shape.partners = shape.units.map((g) => {
    const z = act(inverse(g), [0, 0]);
    return images.findIndex((w) => abs2([w[0] - z[0], w[1] - z[1]]) < 1e-10);
  });
  const corners = shape.corners.map(poincare);
  shape.angles = corners.map((z, n) => {
    if (abs2(shape.corners[n]) > 1 - CUSP) return 0;
    const back = inverse(to(z)), p = act(back, corners.at(n - 1)), q = act(back, corners[(n + 1) % corners.length]);
    return (Math.atan2(p[1], p[0]) - Math.atan2(q[1], q[0]) + 4 * Math.PI) % (2 * Math.PI);
  });
  shape.area = (corners.length - 2) / 2 - shape.angles.reduce((s, x) => s + x, 0) / (2 * Math.PI);
  return shape;
}

function begun(shape, start) {  // the same domain, its sides counted from another one on
  const count = shape.units.length;
  for (const name of ["units", "dual", "corners", "angles", "partners"]) {
    shape[name] = shape[name].slice(start).concat(shape[name].slice(0, start));
  }
  shape.partners = shape.partners.map((p) => (p < 0 ? p : (p - start + count) % count));
  return shape;
}

function orders(shape) {  // the order of the rotations about each vertex
  const count = shape.units.length, found = new Array(count).fill(1);
  for (let start = 0; start < count; start++) {
    let n = start, total = 0, steps = 0;
    do {
      total += shape.angles[n];
      n = (shape.partners[n] + 1) % count;
    } while (n !== start && ++steps < count);
    found[start] = total > 1e-6 ? Math.round(2 * Math.PI / total) : 1;
  }
  return found;
}

// --- the picture -----------------------------------------------------------------------------------

const BASE = GROUP.units.map(([p, q, r, s]) => [[p, q], [r, s]]);
const canvas = document.getElementById("plane"), pen = canvas.getContext("2d");
let center = [0, 0], shape, halfPlane = false, dragging = false, dark = matchMedia("(prefers-color-scheme: dark)").matches;
const SMALL = 0.012, MOST = 5000, MOST_DRAGGED = 6000;

function recompute() {
  const there = to(center), back = inverse(there);
  const seen = (g) => times(back, times(g, there));
  const known = (shape ? shape.world : []).concat(BASE);
  const right = () => Math.abs(shape.area - GROUP.area) < 1e-4;
  shape = domain(known.map(seen));
  if (!right()) shape = domain(BASE.flatMap((g) => [g, ...BASE.map((h) => times(g, h))]).map(seen));
  shape.right = right();
  // The sides are counted as in the other pictures, so that colours are the same.
  const [x, y] = act(seen(BASE[0]), [0, 0]);
  const start = shape.units.findIndex((g) => { const z = act(g, [0, 0]); return abs2([z[0] - x, z[1] - y]) < 1e-10; });
  if (start > 0) begun(shape, start);
  shape.world = shape.units.map((g) => times(there, times(g, back)));
  shape.there = there;
  shape.orders = orders(shape);
  shape.hues = hues(shape.partners);
}

// from the disc around the first centre to the canvas: the disc itself, or the half plane with the first centre at its height
function project(z) {
  const w = canvas.width, h = canvas.height;
  if (!halfPlane) return [w / 2 + z[0] * w * 0.485, h / 2 - z[1] * h * 0.485];
  const v = div([-z[1], 1 + z[0]], [1 - z[0], -z[1]]);  // i(1 + z)/(1 − z)
  const unit = h / 3.1;
  return [w / 2 + Math.max(-50, Math.min(50, v[0])) * unit, h - 2 - Math.min(80, v[1]) * unit];
}
function unproject([x, y]) {
  const w = canvas.width, h = canvas.height;
  if (!halfPlane) return [(x - w / 2) / (w * 0.485), (h / 2 - y) / (h * 0.485)];
  const v = [(x - w / 2) / (h / 3.1), Math.max(1e-3, (h - 2 - y) / (h / 3.1))];
  return div([v[0], v[1] - 1], [v[0], v[1] + 1]);  // (v − i)/(v + i)
}

function side(motion, n, steps) {  // points on a side, but the last
  const p = shape.corners[n], q = shape.corners[(n + 1) % shape.corners.length], found = [];
  for (let k = 0; k < steps; k++) {
    const t = (1 - Math.cos(Math.PI * k / steps)) / 2;
    found.push(act(motion, poincare([p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t])));
  }
  return found;
}
function path(points, close) {
  pen.beginPath();
  points.forEach((z, n) => { const [x, y] = project(z); if (n) pen.lineTo(x, y); else pen.moveTo(x, y); });
  if (close) pen.closePath();
}
function hues(partners) {  // one for a pair, neighbours far apart on the circle of colours
  const firsts = partners.map((p, n) => Math.min(n, p < 0 ? n : p)), ranks = [...new Set(firsts)];
  return firsts.map((n) => (208.8 + 137.50776 * ranks.indexOf(n)) % 360);
}
function shade(h, length) {
  if (!length) return `hsl(${h} 72% ${dark ? 62 : 45}%)`;
  return dark ? `hsl(${h} 42% ${Math.max(18, 44 - 7 * length)}%)` : `hsl(${h} 55% ${Math.min(93, 70 + 5.5 * length)}%)`;
}

// Where a motion moves 0, on the hyperboloid: images of 0 are nowhere nearer to one another there than at 0.
// Steps of a thousandth tell them apart; the shift keeps simple numbers away from where rounding jumps.
function key([a, b]) {
  const p = mul(a, b), step = (x) => Math.floor(2000 * x + 0.37);
  return `${step(p[0])},${step(p[1])}`;
}
function tiles() {
  const back = inverse(shape.there), found = [], seen = new Set([key(times(back, shape.there))]);
  const queue = [[shape.there, -1, 0]], outline = shape.corners.map(poincare);
  const most = dragging ? Math.max(300, MOST_DRAGGED / outline.length) : MOST;
  for (let at = 0; at < queue.length && found.length < most; at++) {
    const [motion, first, length] = queue[at];
    shape.units.forEach((g, n) => {
      if (found.length >= most) return;
      const image = times(motion, g), name = key(times(back, image));
      if (seen.has(name)) return;
      seen.add(name);
      const points = outline.map((p) => act(image, p)), xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
      const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
      if (size < SMALL) return;
      const tile = [image, first < 0 ? n : first, length + 1, size];
      found.push(tile);
      queue.push(tile);
    });
  }
  return found;
}

function draw() {
  const ratio = devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  canvas.width = Math.round(box.width * ratio);
  canvas.height = Math.round(box.height * ratio);
  const ink = dark ? "#eef1f7" : "#1d2433", page = dark ? "#11141b" : "#ffffff", count = shape.units.length;
  pen.fillStyle = dark ? "#1a1f2a" : "#f4f5f8";
  pen.lineJoin = pen.lineCap = "round";
  if (halfPlane) pen.fillRect(0, 0, canvas.width, canvas.height);
  else { pen.beginPath(); pen.arc(canvas.width / 2, canvas.height / 2, canvas.width * 0.485, 0, 7); pen.fill(); }
  const whole = (motion, steps) => shape.units.flatMap((_, n) => side(motion, n, steps));
  pen.strokeStyle = page;
  pen.lineWidth = 0.6 * ratio;
  for (const [motion, first, length, size] of tiles()) {
    path(whole(motion, Math.ceil((size > 0.3 ? 14 : size > 0.08 ? 6 : 3) * (halfPlane ? 2.5 : 1))), true);
    pen.fillStyle = shade(shape.hues[first], length);
    pen.fill();
    pen.stroke();
  }
  path(whole(shape.there, 60), true);
  pen.fillStyle = dark ? "#1f2633" : "#ffffff";
  pen.fill();
  for (let n = 0; n < count; n++) {
    path(side(shape.there, n, 60).concat(side(shape.there, (n + 1) % count, 60).slice(0, 1)), false);
    pen.strokeStyle = shade(shape.hues[n], 0);
    pen.lineWidth = 3 * ratio;
    pen.stroke();
  }
  pen.fillStyle = ink;
  pen.strokeStyle = page;
  pen.lineWidth = ratio;
  for (let n = 0; n < count; n++) {
    if (shape.orders[n] > 1) mark(act(shape.there, poincare(shape.corners[n])), shape.orders[n], ratio);
    if (shape.partners[n] === n) {  // its middle is the middle between the centre and its image
      const z = act(shape.units[n], [0, 0]), k = abs2(z), s = (1 - Math.sqrt(1 - k)) / k;
      mark(act(shape.there, [z[0] * s, z[1] * s]), 2, ratio);
    }
  }
  if (!halfPlane) {
    pen.beginPath();
    pen.arc(canvas.width / 2, canvas.height / 2, canvas.width * 0.485, 0, 7);
    pen.strokeStyle = ink;
    pen.lineWidth = 1.4 * ratio;
    pen.stroke();
  }
  if (halfPlane) {
    pen.fillStyle = ink;
    pen.fillRect(0, canvas.height - 2 * ratio, canvas.width, 2 * ratio);
  }
  const [x, y] = project(center);
  pen.beginPath();
  pen.arc(x, y, 5 * ratio, 0, 7);
  pen.fill();
  pen.strokeStyle = dark ? "#1f2633" : "#ffffff";
  pen.lineWidth = 2 * ratio;
  pen.stroke();
  document.getElementById("reading").textContent = shape.right
    ? `${count} sides · area 2π·${shape.area.toFixed(6)}`
    : "a rotation of the group fixes this point, or comes too near: it has no domain";
}
function mark(z, order, ratio) {
  const [x, y] = project(z), r = 5.5 * ratio, corners = order === 2 ? 4 : 3;
  pen.beginPath();
  for (let k = 0; k < corners; k++) {
    const angle = -Math.PI / 2 + 2 * Math.PI * k / corners;
    pen.lineTo(x + r * Math.cos(angle), y + r * Math.sin(angle));
  }
  pen.closePath();
  pen.fill();
  pen.stroke();
}

// --- hands -----------------------------------------------------------------------------------------

let waiting = false;
function refresh() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; recompute(); draw(); });
}
function move(z) {
  const size = Math.sqrt(abs2(z));
  center = size > 0.93 ? [z[0] * 0.93 / size, z[1] * 0.93 / size] : z;
  refresh();
}
function pointed(event) {
  const box = canvas.getBoundingClientRect(), scale = canvas.width / box.width;
  move(unproject([(event.clientX - box.left) * scale, (event.clientY - box.top) * scale]));
}
canvas.addEventListener("pointerdown", (event) => { dragging = true; canvas.setPointerCapture(event.pointerId); pointed(event); });
canvas.addEventListener("pointermove", (event) => { if (event.buttons) pointed(event); });
for (const end of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(end, () => { dragging = false; shape = undefined; refresh(); });  // from the given units again
}
canvas.addEventListener("keydown", (event) => {
  const step = { ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowUp: [0, 0.02], ArrowDown: [0, -0.02] }[event.key];
  if (step) { event.preventDefault(); move(act(to(center), step)); }
});
document.getElementById("model").addEventListener("click", (event) => {
  halfPlane = !halfPlane;
  event.target.textContent = halfPlane ? "disc" : "half plane";
  canvas.classList.toggle("wide", halfPlane);
  refresh();
});
document.getElementById("home").addEventListener("click", () => { shape = undefined; move([0, 0]); });
function look() {
  document.documentElement.classList.toggle("dark", dark);
  document.getElementById("look").textContent = dark ? "light" : "dark";
}
document.getElementById("look").addEventListener("click", () => { dark = !dark; look(); refresh(); });
addEventListener("resize", refresh);
if (location.hash.includes("dark")) dark = true;  // #dark and #half say how the page begins
look();
if (location.hash.includes("half")) document.getElementById("model").click();
recompute();
draw();
