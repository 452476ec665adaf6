// The heavy top on its tip: the equations, the splitting and the steps of anim/physics/heavy_top_equations, in the same order.
// A state is { q, w }: the attitude, scalar first, and the angular velocity in the body's axes, SI units.
const OUTER = 1 / (2 - 2 ** (1 / 3)), INNER = 1 - 2 * OUTER, ACCURACY = 0.02, HALVINGS = 60;

const hamilton = ([a, b, c, d], [e, f, g, h]) => [
  a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e,
];
const conjugate = ([a, b, c, d]) => [a, -b, -c, -d];
// A vector of space in the body's axes, and back.
const seenFromBody = (q, v) => hamilton(hamilton(conjugate(q), [0, ...v]), q).slice(1);
const seenFromSpace = (q, v) => hamilton(hamilton(q, [0, ...v]), conjugate(q)).slice(1);
const vertical = (q) => seenFromBody(q, [0, 0, 1]);

function rotor(x, y, z) {
  const angle = Math.sqrt(x * x + y * y + z * z), half = angle / 2;
  const ratio = half < 1e-4 ? 0.5 - (half * half) / 12 : Math.sin(half) / angle;
  return [Math.cos(half), x * ratio, y * ratio, z * ratio];
}

// Half friction, half gravity, free top, gravity, friction.
function secondOrder({ q, w }, h, { shape, gravity, tumbling, spinning }) {
  const across = Math.exp((-tumbling * h) / 2), along = Math.exp((-spinning * h) / 2), pull = (gravity * h) / 2;
  let [g1, g2] = vertical(q);
  let [w1, w2, w3] = [w[0] * across + pull * g2, w[1] * across - pull * g1, w[2] * along];
  const own = (1 - shape) * w3 * h, c = Math.cos(own), s = Math.sin(own);
  q = hamilton(hamilton(q, rotor(w1 * h, w2 * h, shape * w3 * h)), [Math.cos(own / 2), 0, 0, Math.sin(own / 2)]);
  [w1, w2] = [c * w1 + s * w2, c * w2 - s * w1];
  [g1, g2] = vertical(q);
  return { q, w: [(w1 + pull * g2) * across, (w2 - pull * g1) * across, w3 * along] };
}

// Yoshida's composition, the quaternion of norm 1.
function fourthOrder(state, h, rates) {
  for (const part of [OUTER, INNER, OUTER]) state = secondOrder(state, part * h, rates);
  const steady = (3 - state.q.reduce((sum, x) => sum + x * x, 0)) / 2;
  return { q: state.q.map((x) => x * steady), w: state.w };
}

// A step that ends where the rim touches the ground, if it does: { q, w, rest }, `rest` the time until then or null.
function stepToGround(state, h, rates) {
  const next = fourthOrder(state, h, rates);
  if (vertical(next.q)[2] >= rates.floor) return { ...next, rest: null };
  let [before, after] = [0, h];
  for (let k = 0; k < HALVINGS; k++) {
    const middle = (before + after) / 2;
    if (vertical(fourthOrder(state, middle, rates).q)[2] < rates.floor) after = middle;
    else before = middle;
  }
  return { q: fourthOrder(state, before, rates).q, w: [0, 0, 0], rest: before };
}

// The integrals of 1, z, x² + y² and x² + z² over the solid of an outline of pairs (radius, z), as anim/physics/inertia
// has them. The polynomials are of degree 4 at most, where three points of Gauss are exact.
function moments(profile) {
  const sums = [0, 0, 0, 0], t = Math.sqrt(3 / 5) / 2;
  for (let k = 0; k + 1 < profile.length; k++) {
    const [[r0, z0], [r1, z1]] = [profile[k], profile[k + 1]];
    for (const [x, weight] of [[0.5 - t, 5 / 18], [0.5, 4 / 9], [0.5 + t, 5 / 18]]) {
      const r = r0 + (r1 - r0) * x, z = z0 + (z1 - z0) * x, area = Math.PI * (z1 - z0) * weight * r * r;
      [1, z, (r * r) / 2, (r * r) / 4 + z * z].forEach((value, n) => (sums[n] += area * value));
    }
  }
  return sums;
}
const reach = (profile) => Math.min(...profile.filter(([r]) => r > 0).map(([r, z]) => Math.atan2(z, r)));
const widened = (profile, width) => profile.map(([r, z]) => [r * width, z]);

// What a body becomes when its outline is made wider and its mass stays.
function widenedBody(body, profile, width) {
  const wide = widened(profile, width), [v, m, a, b] = moments(profile), [V, M, A, B] = moments(wide);
  const grown = (value, before, after) => (value * (after / V)) / (before / v);
  return {
    mass: body.mass,
    unit: body.height / (m / v), // the length of the outline's unit, in m
    height: grown(body.height, m, M),
    axial: grown(body.axial, a, A),
    transverse: grown(body.transverse, b, B),
    reach: body.reach + reach(wide) - reach(profile),
  };
}

const torqueOf = (body, gravity) => body.mass * gravity * body.height;

// `losses` are 1/tilt_decay and 1/spin_decay.
const ratesOf = (body, gravity, losses) => ({
  shape: body.axial / body.transverse,
  gravity: torqueOf(body, gravity) / body.transverse,
  tumbling: losses[0],
  spinning: losses[1],
  floor: Math.cos(body.reach),
});

function longestStep({ w }, rates) {
  const fastest = Math.max(Math.abs(w[2]) * rates.shape, Math.hypot(w[0], w[1]), Math.sqrt(rates.gravity), rates.tumbling, rates.spinning);
  return fastest > 0 ? ACCURACY / fastest : Infinity;
}

function launched({ spin, tilt, precession = 0, heading = 0 }) {
  const turn = [Math.cos(heading / 2), 0, 0, Math.sin(heading / 2)], lean = [Math.cos(tilt / 2), 0, Math.sin(tilt / 2), 0];
  return { q: hamilton(turn, lean), w: [-precession * Math.sin(tilt), 0, spin] };
}

// Energy and angular momentum: about the vertical, as a vector of space, and ω as a vector of space.
function quantities({ q, w }, body, gravity) {
  const up = vertical(q), own = [body.transverse * w[0], body.transverse * w[1], body.axial * w[2]];
  const kinetic = (own[0] * w[0] + own[1] * w[1] + own[2] * w[2]) / 2;
  return {
    energy: kinetic + torqueOf(body, gravity) * up[2],
    kinetic,
    about: own[0] * up[0] + own[1] * up[1] + own[2] * up[2],
    momentum: seenFromSpace(q, own),
    velocity: seenFromSpace(q, w),
    tilt: Math.atan2(Math.hypot(up[0], up[1]), up[2]),
  };
}
