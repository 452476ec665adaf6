// The top that is free on the ground: the forces and the steps of anim/physics/free_top_equations, in the same order.
// A state is { q, w, y }: y the fourteen numbers of Python's, q and w the first seven of them.
const STANDARD = 9.80665, SINK = 1 / 400, CREEP = 0.025, FREE_STEP = 8e-4, TURN = 0.02, STIFF = 0.05, AROUND = 30, FINER = 32;

// The lowest corners of an outline in m, those that can touch: [radius, height above the centre of mass, rounding].
const edgesOf = (body, outline, ball) => [[0, ball - body.height, ball], ...outline.slice(1).map(([r, z]) => [r, z - body.height, 0])];

function groundOf(body, gravity, losses, { friction, rolling }) {
  const pull = Math.max(STANDARD, gravity), pace = Math.sqrt(pull * body.height);
  return {
    transverse: body.transverse / body.mass - body.height ** 2, axial: body.axial / body.mass, gravity, tumbling: losses[0], spinning: losses[1],
    stiffness: pull / (SINK * body.height) ** 1.5, damping: 1 / pace, friction, creep: CREEP * pace, rolling,
  };
}

function slopeOf(y, out, edges, g) {
  const { transverse: i1, axial: i3 } = g, [a, b, c, d, w1, w2, w3] = y;
  const r11 = a * a + b * b - c * c - d * d, r12 = 2 * (b * c - a * d), r13 = 2 * (b * d + a * c);
  const r21 = 2 * (b * c + a * d), r22 = a * a - b * b + c * c - d * d, r23 = 2 * (c * d - a * b);
  const g1 = 2 * (b * d - a * c), g2 = 2 * (c * d + a * b), g3 = a * a - b * b - c * c + d * d;
  const v1 = r11 * y[10] + r21 * y[11] + g1 * y[12], v2 = r12 * y[10] + r22 * y[11] + g2 * y[12], v3 = r13 * y[10] + r23 * y[11] + g3 * y[12];
  const side = Math.sqrt(g1 * g1 + g2 * g2);
  let f1 = 0, f2 = 0, f3 = 0, t1 = 0, t2 = 0, t3 = 0, stiff = 0, lost = g.tumbling * i1 * (w1 * w1 + w2 * w2) + g.spinning * i3 * w3 * w3;
  for (const [radius, height, rounding] of edges) {
    if (radius > 0 && side < 1e-9) continue;
    const away = radius > 0 ? radius / side : 0, s1 = -(away + rounding) * g1, s2 = -(away + rounding) * g2, s3 = height - rounding * g3;
    const depth = -(y[9] + s1 * g1 + s2 * g2 + s3 * g3);
    if (depth <= 0) continue;
    const u1 = v1 + w2 * s3 - w3 * s2, u2 = v2 + w3 * s1 - w1 * s3, u3 = v3 + w1 * s2 - w2 * s1;
    const sinking = -(u1 * g1 + u2 * g2 + u3 * g3), elastic = g.stiffness * depth * Math.sqrt(depth);
    const press = Math.max(0, elastic * (1 + g.damping * sinking));
    const p1 = u1 + sinking * g1, p2 = u2 + sinking * g2, p3 = u3 + sinking * g3, slip = p1 * p1 + p2 * p2 + p3 * p3;
    const grip = (g.friction * press) / Math.sqrt(slip + g.creep * g.creep);
    const turning = w1 * w1 + w2 * w2 + w3 * w3, stay = (g.rolling * press) / Math.sqrt(turning + 1);
    const n1 = press * g1 - grip * p1, n2 = press * g2 - grip * p2, n3 = press * g3 - grip * p3;
    f1 += n1; f2 += n2; f3 += n3;
    t1 += s2 * n3 - s3 * n2 - stay * w1;
    t2 += s3 * n1 - s1 * n3 - stay * w2;
    t3 += s1 * n2 - s2 * n1 - stay * w3;
    lost += (press - elastic) * sinking + grip * slip + stay * turning;
    const outOfLine = s1 * s1 + s2 * s2;
    stiff += grip * (1 + (outOfLine + s3 * s3) / i1 + outOfLine / i3) + stay / Math.min(i1, i3);
  }
  out[0] = -(b * w1 + c * w2 + d * w3) / 2;
  out[1] = (a * w1 + c * w3 - d * w2) / 2;
  out[2] = (a * w2 + d * w1 - b * w3) / 2;
  out[3] = (a * w3 + b * w2 - c * w1) / 2;
  out[4] = ((i1 - i3) * w2 * w3 + t1) / i1 - g.tumbling * w1;
  out[5] = ((i3 - i1) * w3 * w1 + t2) / i1 - g.tumbling * w2;
  out[6] = t3 / i3 - g.spinning * w3;
  [out[7], out[8], out[9]] = [y[10], y[11], y[12]];
  out[10] = r11 * f1 + r12 * f2 + r13 * f3;
  out[11] = r21 * f1 + r22 * f2 + r23 * f3;
  out[12] = g1 * f1 + g2 * f2 + g3 * f3 - g.gravity;
  out[13] = lost;
  return stiff;
}

// Whether something begins or ends to touch the ground soon.
function changesContact(y, h, edges) {
  const g1 = 2 * (y[1] * y[3] - y[0] * y[2]), g2 = 2 * (y[2] * y[3] + y[0] * y[1]);
  const g3 = 1 - 2 * (y[1] * y[1] + y[2] * y[2]), side = Math.sqrt(g1 * g1 + g2 * g2), rising = g1 * y[5] - g2 * y[4];
  return edges.some(([radius, height, rounding]) => {
    if (radius > 0 && side < 1e-9) return false;
    const gap = y[9] + height * g3 - radius * side - rounding, outwards = radius > 0 ? (radius * g3) / side : 0;
    return Math.abs(gap) < AROUND * h * Math.abs(y[12] + (height + outwards) * rising);
  });
}

const ROOM = Array.from({ length: 5 }, () => new Float64Array(14));
const free = (y) => ({ q: [...y.slice(0, 4)], w: [...y.slice(4, 7)], y });

// One step of Kutta's fourth order, in parts where friction is stiff or a contact changes.
function stepOnGround(state, h, edges, ground) {
  const y = Float64Array.from(state.y);
  let parts = Math.max(1, Math.ceil((h * slopeOf(y, ROOM[0], edges, ground)) / STIFF));
  if (changesContact(y, h, edges)) parts = Math.max(parts, FINER);
  const step = h / parts;
  for (let part = 0; part < parts; part++) {
    if (part) slopeOf(y, ROOM[0], edges, ground);
    for (let k = 1; k < 4; k++) {
      const share = k === 3 ? step : step / 2;
      for (let n = 0; n < 14; n++) ROOM[4][n] = y[n] + share * ROOM[k - 1][n];
      slopeOf(ROOM[4], ROOM[k], edges, ground);
    }
    for (let n = 0; n < 14; n++) y[n] += (step / 6) * (ROOM[0][n] + 2 * ROOM[1][n] + 2 * ROOM[2][n] + ROOM[3][n]);
  }
  const size = Math.sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
  for (let n = 0; n < 4; n++) y[n] /= size;
  return free(y);
}

// Whether anything but the tip touches the ground.
function isDown({ y }, edges) {
  const up = 1 - 2 * (y[1] * y[1] + y[2] * y[2]), side = Math.sqrt(Math.max(0, 1 - up * up));
  return edges.slice(1).some(([radius, height, rounding]) => y[9] + height * up - radius * side - rounding < 0);
}

const freeStep = (body, { w }, gravity) => Math.min(FREE_STEP * Math.sqrt(body.height / Math.max(STANDARD, gravity)), TURN / Math.max(Math.hypot(...w), 1e-9));

// A pinned state let go upon a tip of the radius `ball`: the middle of the ball is at rest, and weight presses it in.
function letGo({ q, w }, body, ball, gravity) {
  const arm = seenFromSpace(q, [0, 0, body.height - ball]), omega = seenFromSpace(q, w);
  const sink = SINK * body.height * Math.cbrt(gravity / Math.max(STANDARD, gravity)) ** 2;
  const speed = [omega[1] * arm[2] - omega[2] * arm[1], omega[2] * arm[0] - omega[0] * arm[2], omega[0] * arm[1] - omega[1] * arm[0]];
  return free(Float64Array.from([...q, ...w, arm[0], arm[1], arm[2] + ball - sink, ...speed, 0]));
}

// Where the outline's first point is, in units of the outline; a pinned top's is at the origin.
function tipOf({ q, y }, body) {
  if (!y) return [0, 0, 0];
  const axis = seenFromSpace(q, [0, 0, 1]);
  return [0, 1, 2].map((n) => (y[7 + n] - body.height * axis[n]) / body.unit);
}

// The energy that moves and that is stored, in J, the angular momenta about the centre of mass, and Jellett's invariant.
function freeQuantities(state, body, edges, ground) {
  const { q, w, y } = state, i1 = ground.transverse * body.mass, own = [i1 * w[0], i1 * w[1], body.axial * w[2]];
  const up = vertical(q)[2], side = Math.sqrt(Math.max(0, 1 - up * up)), momentum = seenFromSpace(q, own), [, offset, ball] = edges[0];
  let stored = ground.gravity * y[9] + (y[10] ** 2 + y[11] ** 2 + y[12] ** 2) / 2;
  for (const [radius, height, rounding] of edges) stored += 0.4 * ground.stiffness * Math.max(0, -(y[9] + height * up - radius * side - rounding)) ** 2.5;
  const axis = seenFromSpace(q, [0, 0, 1]), arm = axis.map((x) => -offset * x);
  arm[2] += ball;
  return {
    energy: (own[0] * w[0] + own[1] * w[1] + own[2] * w[2]) / 2 + body.mass * stored,
    lost: body.mass * y[13], about: momentum[2], momentum, velocity: seenFromSpace(q, w), tilt: Math.acos(Math.max(-1, Math.min(1, up))),
    jellett: momentum[0] * arm[0] + momentum[1] * arm[1] + momentum[2] * arm[2],
  };
}
