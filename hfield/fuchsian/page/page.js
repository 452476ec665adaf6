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

const MOST_UNITS = 600;  // where rounding errors make ever more units, the search ends
const CUSP = 1e-7;  // so near to the circle a vertex is a cusp
const FIXED = 1e-8;  // motions with a smaller |b|² fix the centre

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
    const value = w ? 2 * abs2(shape.units[n][1]) * (w[0] * k[0] + w[1] * k[1] - 1) : beside(shape, n, k);
    if (value > best) { best = value; found = n; }
  });
  return found;
}

// The rotations about 0 among units and their products: of the order of the least, by multiples of its angle.
function rotations(units) {
  const angle = ([a]) => (2 * Math.atan2(a[1], a[0]) + 4 * Math.PI) % (2 * Math.PI);
  const least = Math.min(2 * Math.PI, ...units.filter(([, b]) => abs2(b) < FIXED).map(angle).filter((t) => t > 0.01 && t < 6.27));
  const order = Math.round(2 * Math.PI / least);
  return Array.from({ length: order }, (_, n) => [[Math.cos(Math.PI * n / order), Math.sin(Math.PI * n / order)], [0, 0]]);
}

function beside(shape, n, k) {  // how far to the outer side of a line from 0, the first or the last side of a sector
  const p = shape.corners.at(n ? -1 : 1), cross = (p[0] * k[1] - p[1] * k[0]) / Math.sqrt(abs2(p));
  return n ? cross : -cross;
}

function domain(units) {  // after Voight: reduce what bounds nothing, cut off what is not paired
  const turns = rotations(units.flatMap((g) => [g, inverse(g)]));
  const key = (g) => { const z = act(g, [0, 0]); return `${z[0].toFixed(7)},${z[1].toFixed(7)}`; };
  const tried = new Set();
  let shape;
  for (let round = 0; round < 40; round++) {
    const all = new Map();
    for (const g of units) for (const h of [g, inverse(g)]) {
      if (abs2(h[1]) > FIXED) for (const turn of turns) all.set(key(times(turn, h)), times(turn, h));
    }
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
      if (abs2(g[1]) > FIXED && !tried.has(key(g))) { tried.add(key(g)); fresh.push(g); }
    });
    if (!fresh.length) shape.units.forEach((g, n) => {
      for (const corner of [shape.corners[n], shape.corners[(n + 1) % shape.corners.length]]) {
        if (abs2(corner) > 1 - CUSP) continue;
        const side = beyond(shape, klein(act(inverse(g), poincare(corner))));
        if (side < 0) continue;
        const cut = times(g, shape.units[side]);
        if (abs2(cut[1]) > FIXED && !tried.has(key(cut))) { tried.add(key(cut)); fresh.push(cut); }
      }
    });
    units = shape.units.concat(fresh);
    if (!fresh.length || units.length > MOST_UNITS) break;
  }
  const images = shape.units.map((g) => act(g, [0, 0]));
  shape.partners = shape.units.map((g) => {
    const z = act(inverse(g), [0, 0]);
    return images.findIndex((w) => abs2([w[0] - z[0], w[1] - z[1]]) < 1e-10);
  });
  if (turns.length > 1) shape = sector(shape, turns);
  const corners = shape.corners.map(poincare);
  shape.inside = to(poincare(shape.corners.reduce(add).map((x) => x / corners.length)));
  shape.order = turns.length;
  shape.angles = corners.map((z, n) => {
    if (abs2(shape.corners[n]) > 1 - CUSP) return 0;
    const back = inverse(to(z)), p = act(back, corners.at(n - 1)), q = act(back, corners[(n + 1) % corners.length]);
    return (Math.atan2(p[1], p[0]) - Math.atan2(q[1], q[0]) + 4 * Math.PI) % (2 * Math.PI);
  });
  shape.area = (corners.length - 2) / 2 - shape.angles.reduce((s, x) => s + x, 0) / (2 * Math.PI);
  return shape;
}

// The sector of a polygon between two lines from 0 to corners, of which a rotation maps the first to the second.
function sector(whole, turns) {
  const order = turns.length, all = whole.units.length, count = all / order, start = nearestCorner(whole.corners);
  if (!Number.isInteger(count) || whole.partners.includes(-1)) return whole;
  const from = (list, number) => Array.from({ length: number }, (_, n) => list[(start + n) % all]);
  const partners = from(whole.partners, count).map((p) => (p - start + all) % all);
  const units = from(whole.units, count).map((g, n) => times(g, turns[Math.floor(partners[n] / count)]));
  return {
    units: [turns.at(-1), ...units, turns[1]], partners: [count + 1, ...partners.map((p) => p % count + 1), 0],
    corners: [[0, 0], ...from(whole.corners, count + 1)], dual: [undefined, ...from(whole.dual, count), undefined],
  };
}
function nearestCorner(corners) {  // the corner in the direction that is given for the first centre
  const cosine = (p) => (p[0] * GROUP.corner[0] + p[1] * GROUP.corner[1]) / Math.sqrt(abs2(p));
  return corners.reduce((best, p, n) => (cosine(p) > cosine(corners[best]) + 1e-9 ? n : best), 0);
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

const BASE = GROUP.units.map(([p, q, r, s]) => [[p, q], [r, s]]), IDENTITY = [[1, 0], [0, 0]];
const canvas = document.getElementById("plane"), pen = canvas.getContext("2d");
const FIRST_CENTER = to(GROUP.first);  // moves 0 to the centre of the first domain, whose units are given
let center = [0, 0], shape, halfPlane = false, dragging = false;
let dark = document.documentElement.dataset.look === "dark" || matchMedia("(prefers-color-scheme: dark)").matches;
const SMALL = 0.012, MOST = 5000, SMALL_DRAGGED = 0.02, MOST_DRAGGED = 6000, DRAGGED_RATIO = 1.5;
const MOST_PRODUCTS = 300, MOST_MOVED = 0.25;  // from farther away the last domain is no help
const STEP = 0.15, MAX_STEPS = 40;  // of a walk from the first centre, in the disc around the place reached
const near = (z, w) => abs2([z[0] - w[0], z[1] - w[1]]) < 1e-9;

// The domain around a point, given units among which its sides, or products of two that give them, probably are.
function around(z, units) {
  const there = to(z), back = inverse(there), seen = units.map((g) => times(back, times(g, there)));
  const right = (found) => Math.abs(found.area - GROUP.area) < 1e-4;
  let found = domain(seen);
  if (!right(found)) {
    const products = seen.flatMap((g) => seen.map((h) => times(g, h))).filter(([, b]) => abs2(b) > FIXED);
    const nearest = products.sort(([, b], [, d]) => abs2(b) - abs2(d)).slice(0, MOST_PRODUCTS);
    found = domain(found.units.concat(seen, nearest));
  }
  found.there = there;
  found.right = right(found);
  found.world = found.units.map((g) => times(there, times(g, back)));
  return found;
}

// The domain around a point of the first domain, by steps from its centre: sides change little in each.
function walked(z) {
  let found = around(GROUP.first, BASE), here = GROUP.first;
  for (let step = 0; step < MAX_STEPS; step++) {
    const way = act(inverse(to(here)), z), size = Math.sqrt(abs2(way)), last = size <= STEP || step === MAX_STEPS - 1;
    here = last ? z : act(to(here), [way[0] * STEP / size, way[1] * STEP / size]);
    const next = around(here, found.world);
    if (next.right || last) found = next;
    if (last) break;
  }
  return found;
}

// The unit h and the point z' of the first domain with h·z' = z.
const FIRST = polygon(BASE.map((g) => times(inverse(FIRST_CENTER), times(g, FIRST_CENTER))));
function reduced(z) {
  let h = IDENTITY;
  z = act(inverse(FIRST_CENTER), z);
  for (let step = 0; step < 200; step++) {
    const n = beyond(FIRST, klein(z));
    if (n < 0) break;
    z = act(inverse(FIRST.units[n]), z);
    h = times(h, FIRST.units[n]);
  }
  return [times(FIRST_CENTER, times(h, inverse(FIRST_CENTER))), act(FIRST_CENTER, z)];
}

function recompute(afresh = false) {
  const [h, z] = reduced(center), back = inverse(h), before = afresh ? undefined : shape;
  let found;
  if (before?.right && abs2(act(inverse(to(before.center)), center)) < MOST_MOVED ** 2) {
    found = around(z, before.world.map((g) => times(back, times(g, h))));
  }
  if (!found?.right) found = walked(z);
  found.world = found.world.map((g) => times(h, times(g, back)));
  found.there = times(h, found.there);
  found.center = center;
  if (found.order === 1) begin(found, times(inverse(found.there), times(BASE[0], found.there)));
  found.orders = orders(found);
  number(found, shape);
  shape = found;
}

// Count the sides from the first given unit's on, as the other pictures do, where it has one.
function begin(found, first) {
  const [x, y] = act(first, [0, 0]), count = found.units.length;
  const start = Math.max(0, found.units.findIndex((g) => near(act(g, [0, 0]), [x, y])));
  for (const name of ["units", "dual", "corners", "angles", "partners", "world"]) {
    found[name] = found[name].slice(start).concat(found[name].slice(0, start));
  }
  found.partners = found.partners.map((p) => (p < 0 ? p : (p - start + count) % count));
}

// Numbers for the pairs of sides, from 0: those that the pairs had before, or in the order of the given units. The
// first of a pair has the letter, the other its inverse.
function number(found, before) {
  const here = inverse(found.there), place = (g) => act(times(here, times(g, found.there)), [0, 0]);
  const known = before ?? (found.order > 1 ? { world: [] } : numbered(BASE)), places = found.units.map((g) => act(g, [0, 0]));
  const count = places.length, chosen = new Array(count), first = new Array(count), taken = new Set();
  const give = (n, k, isFirst) => {
    const partner = found.partners[n];
    if (partner >= 0) [chosen[partner], first[partner]] = [k, !isFirst];
    [chosen[n], first[n]] = [k, isFirst || partner === n];
    taken.add(k);
  };
  known.world.forEach((g, k) => {
    const z = place(g), n = places.findIndex((w) => near(z, w));
    if (n >= 0 && chosen[n] === undefined && !taken.has(known.numbers[k])) give(n, known.numbers[k], known.first[k]);
  });
  let next = 0;
  for (let n = 0; n < count; n++) {
    if (chosen[n] !== undefined) continue;
    while (taken.has(next)) next++;
    give(n, next, true);
  }
  found.numbers = chosen;
  found.first = first;
  found.letters = chosen.map((k, n) => letter(k) + (first[n] ? "" : "⁻¹"));
}
function numbered(units) {
  const places = units.map((g) => act(g, [0, 0]));
  const partners = units.map((g) => { const z = act(inverse(g), [0, 0]); return places.findIndex((w) => near(w, z)); });
  return { world: units, numbers: numbersOf(partners), first: partners.map((p, n) => n <= p) };
}
function numbersOf(partners) {
  const firsts = partners.map((p, n) => Math.min(n, p < 0 ? n : p)), ranks = [...new Set(firsts)];
  return firsts.map((n) => ranks.indexOf(n));
}
function letter(number) {
  const turn = Math.floor(number / 26), index = turn ? [...String(turn)].map((d) => "₀₁₂₃₄₅₆₇₈₉"[d]).join("") : "";
  return String.fromCharCode(97 + number % 26) + index;
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

function side(motion, n, steps) {  // points on a side, but the last, evenly on the screen
  const end = (m) => klein(act(motion, poincare(shape.corners[m % shape.corners.length]))), p = end(n), q = end(n + 1), found = [];
  for (let k = 0; k < steps; k++) {
    const t = (1 - Math.cos(Math.PI * k / steps)) / 2;
    found.push(poincare([p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t]));
  }
  return found;
}
function path(points, close) {
  pen.beginPath();
  points.forEach((z, n) => { const [x, y] = project(z); if (n) pen.lineTo(x, y); else pen.moveTo(x, y); });
  if (close) pen.closePath();
}
function sideSteps(size) {  // points on each side of an image; fewer where there are many sides
  const fewer = dragging ? Math.min(1, 16 / shape.units.length) : 1;
  return Math.max(1, (size > 0.3 ? 14 : size > 0.08 ? 6 : 3) * fewer);
}
const look = () => GROUP.colors[dark ? "dark" : "light"];
function shade(number, length) {  // a pair's colour, mixed with the disc's
  const { pairs, disc } = look(), [nearest, next, greatest] = GROUP.colors.shares;
  const share = length ? Math.min(greatest, nearest + next * (length - 1)) : 0, color = pairs[number % pairs.length];
  const part = (n) => [color, disc].map((text) => parseInt(text.slice(n, n + 2), 16));
  return "rgb(" + [1, 3, 5].map(part).map(([a, b]) => Math.round(a + (b - a) * share)).join(" ") + ")";
}

// Where a motion moves 0, on the hyperboloid: images of 0 are nowhere nearer to one another there than at 0. In a
// sector that is fixed by rotations, and a point inside is moved to it first. Steps of a thousandth tell them apart; the shift keeps simple numbers away from where rounding jumps.
function key([a, b]) {
  const p = mul(a, b), step = (x) => Math.floor(2000 * x + 0.37);
  return `${step(p[0])},${step(p[1])}`;
}
function tiles() {
  const back = inverse(shape.there), inside = shape.order > 1 ? shape.inside : IDENTITY, found = [];
  const name = (motion) => key(times(inverse(inside), times(back, times(motion, inside))));
  const seen = new Set([name(shape.there)]);
  const queue = [[shape.there, -1, 0]], outline = shape.corners.map(poincare);
  const most = dragging ? Math.max(300, MOST_DRAGGED / outline.length) : MOST, small = dragging ? SMALL_DRAGGED : SMALL;
  // An image lies beyond a side, where not much is seen if the ends of its line are near to one another.
  const ends = dragging ? shape.dual.map((w, n) => {
    if (!w) {  // a line through the centre, to the first or the last corner
      const p = shape.corners.at(n ? -1 : 1), s = Math.sqrt(abs2(p));
      return [[p[0] / s, p[1] / s], [-p[0] / s, -p[1] / s]];
    }
    const size = abs2(w), t = Math.sqrt(Math.max(0, size - 1));
    return [[(w[0] - t * w[1]) / size, (w[1] + t * w[0]) / size], [(w[0] + t * w[1]) / size, (w[1] - t * w[0]) / size]];
  }) : [];
  for (let at = 0; at < queue.length && found.length < most; at++) {
    const [motion, first, length] = queue[at];
    shape.units.forEach((g, n) => {
      if (found.length >= most) return;
      if (dragging) {
        const [p, q] = ends[n].map((z) => act(motion, z));
        if (abs2([p[0] - q[0], p[1] - q[1]]) < small * small) return;
      }
      const image = times(motion, g), place = name(image);
      if (seen.has(place)) return;
      seen.add(place);
      const points = outline.map((p) => act(image, p)), xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
      const size = Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
      if (size < small) return;
      const tile = [image, first < 0 ? n : first, length + 1, size];
      found.push(tile);
      queue.push(tile);
    });
  }
  return found;
}

function draw() {
  const ratio = Math.min(devicePixelRatio || 1, dragging ? DRAGGED_RATIO : 3), box = canvas.getBoundingClientRect();
  const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  else pen.clearRect(0, 0, width, height);
  const { ink, page, disc, domain: inside } = look(), count = shape.units.length;
  pen.fillStyle = disc;
  pen.lineJoin = pen.lineCap = "round";
  if (halfPlane) pen.fillRect(0, 0, canvas.width, canvas.height);
  else { pen.beginPath(); pen.arc(canvas.width / 2, canvas.height / 2, canvas.width * 0.485, 0, 7); pen.fill(); }
  const whole = (motion, steps) => shape.units.flatMap((_, n) => side(motion, n, steps));
  pen.strokeStyle = page;
  pen.lineWidth = 0.6 * ratio;
  for (const [motion, first, length, size] of tiles()) {
    path(whole(motion, Math.ceil(sideSteps(size) * (halfPlane ? 2.5 : 1))), true);
    pen.fillStyle = shade(shape.numbers[first], length);
    pen.fill();
    pen.stroke();
  }
  path(whole(shape.there, 60), true);
  pen.fillStyle = inside;
  pen.fill();
  for (let n = 0; n < count; n++) {
    path(side(shape.there, n, 60).concat(side(shape.there, (n + 1) % count, 60).slice(0, 1)), false);
    pen.strokeStyle = shade(shape.numbers[n], 0);
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
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  for (let n = 0; n < count; n++) name(n, ratio);
  pen.strokeStyle = inside;
  pen.lineWidth = 2 * ratio;
  if (shape.order > 1) mark(center, shape.order, 1.4 * ratio);
  else {
    pen.beginPath();
    pen.arc(...project(center), 5 * ratio, 0, 7);
    pen.fill();
    pen.stroke();
  }
  markPoints(ratio);
  document.getElementById("reading").textContent = shape.right
    ? `${count} sides · area 2π·${shape.area.toFixed(6)}` + (shape.order > 1 ? ` · the centre is fixed by a rotation of order ${shape.order}` : "")
    : "a rotation of the group fixes a point that is too near: the page does not find the domain";
}
function name(n, ratio) {  // a letter inside the domain, beside the middle of a side that is long enough
  const [before, middle, after] = [0, 1, 2].map((k) => project(side(shape.there, n, 2).concat(side(shape.there, (n + 1) % shape.units.length, 1))[k]));
  const way = [after[0] - before[0], after[1] - before[1]], long = Math.hypot(...way), size = Math.min(15 * ratio, 0.28 * long);
  if (size < 4 * ratio) return;
  const away = 0.95 * size / long;  // the corners go round the domain, and y goes down
  pen.font = `${size}px "DejaVu Sans", Verdana, sans-serif`;
  pen.fillText(shape.letters[n], middle[0] + way[1] * away, middle[1] - way[0] * away);
}
function moved(z) {  // the image of a point in the domain
  let w = act(inverse(shape.there), z);
  for (let step = 0; step < 300; step++) {
    const n = beyond(shape, klein(w));
    if (n < 0) break;
    w = act(inverse(shape.units[n]), w);
  }
  return act(shape.there, w);
}
function markPoints(ratio) {  // CM points
  pen.lineWidth = 1.4 * ratio;
  pen.strokeStyle = look().ink;
  for (const { color, places } of GROUP.points) for (const z of places) {
    pen.fillStyle = color;
    pen.beginPath();
    pen.arc(...project(moved(z)), 5 * ratio, 0, 7);
    pen.fill();
    pen.stroke();
  }
}
function mark(z, order, ratio) {
  const [x, y] = project(z), r = 5.5 * ratio, corners = order === 2 ? 4 : order < 8 ? order : 24;
  const start = order === 4 ? Math.PI / 4 : -Math.PI / 2, narrow = order === 2 ? 0.75 : 1;
  pen.beginPath();
  for (let k = 0; k < corners; k++) {
    const angle = start + 2 * Math.PI * k / corners;
    pen.lineTo(x + narrow * r * Math.cos(angle), y + r * Math.sin(angle));
  }
  pen.closePath();
  pen.fill();
  pen.stroke();
}

// --- hands -----------------------------------------------------------------------------------------

let waiting = false, afresh = false;
function refresh() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    recompute(afresh);
    draw();
    waiting = afresh = false;
  });
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
  canvas.addEventListener(end, () => { dragging = false; afresh = true; refresh(); });
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
function showLook() {
  document.documentElement.classList.toggle("dark", dark);
  document.getElementById("look").textContent = dark ? "light" : "dark";
}
document.getElementById("look").addEventListener("click", () => { dark = !dark; showLook(); refresh(); });
addEventListener("resize", refresh);
if (location.hash.includes("dark")) dark = true;  // #dark and #half say how the page begins
showLook();
if (location.hash.includes("half")) document.getElementById("model").click();
if (GROUP.points.length) {
  const legend = document.getElementById("points");
  legend.hidden = false;
  legend.append("CM points of discriminant");
  for (const { name, color } of GROUP.points) {
    const dot = document.createElement("span");
    dot.className = "dot";
    dot.style.background = color;
    legend.append(" ", dot, ` ${name}`);
  }
}
recompute();
draw();
