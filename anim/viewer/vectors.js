// Vectors are arrays of three numbers, matrices arrays of sixteen by columns, as WebGL wants them.
const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
const scale = (s, v) => v.map((x) => s * x);
const unit = (v) => scale(1 / Math.hypot(...v), v);

function times(m, n) {
  const out = [];
  for (let c = 0; c < 4; c++)
    for (let r = 0; r < 4; r++)
      out.push(m[r] * n[4 * c] + m[4 + r] * n[4 * c + 1] + m[8 + r] * n[4 * c + 2] + m[12 + r] * n[4 * c + 3]);
  return out;
}

function perspective(height, aspect, near, far) {
  const f = 1 / height, d = near - far;
  return [f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / d, -1, 0, 0, (2 * far * near) / d, 0];
}

// The camera at angles azimuth and elevation around a point, z upwards.
function lookAt(azimuth, elevation, distance, target) {
  const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
  const right = [-sa, ca, 0], up = [-se * ca, -se * sa, ce], back = [ce * ca, ce * sa, se];
  const eye = back.map((x, n) => distance * x + target[n]);
  const rows = [right, up, back];
  return {
    eye,
    view: [0, 1, 2, 3].flatMap((c) => (c < 3 ? [...rows.map((r) => r[c]), 0] : [...rows.map((r) => -dot(r, eye)), 1])),
  };
}

// The unit quaternion that turns the z axis towards a vector by the shortest way.
function towards(vector) {
  const [x, y, z] = unit(vector);
  return z < -0.999999 ? [0, 1, 0, 0] : unit([1 + z, -y, x, 0]);
}

// Where a point of space is seen: x and y from −1 to 1.
function projected(matrix, [x, y, z]) {
  const row = (n) => matrix[n] * x + matrix[4 + n] * y + matrix[8 + n] * z + matrix[12 + n];
  return [row(0) / row(3), row(1) / row(3)];
}

// The attitude at a frame that need not be whole: along the shorter arc between its neighbours.
function attitude(quaternions, frame) {
  const last = quaternions.length / 4 - 1;
  const k = Math.min(Math.floor(frame), last), m = Math.min(k + 1, last), t = frame - k;
  const p = quaternions.subarray(4 * k, 4 * k + 4), q = quaternions.subarray(4 * m, 4 * m + 4);
  const cosine = p[0] * q[0] + dot(p.subarray(1), q.subarray(1)), sign = cosine < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const [s, r] = angle < 1e-4 ? [1 - t, t] : [Math.sin((1 - t) * angle) / Math.sin(angle), Math.sin(t * angle) / Math.sin(angle)];
  return [0, 1, 2, 3].map((n) => s * p[n] + sign * r * q[n]);
}

// T_q(v) = q v q⁻¹ for a unit quaternion, scalar first.
function rotate(q, v) {
  const [w, x, y, z] = q, n = w * w + x * x + y * y + z * z;
  const c = [y * v[2] - z * v[1] + w * v[0], z * v[0] - x * v[2] + w * v[1], x * v[1] - y * v[0] + w * v[2]];
  return [v[0] + (2 / n) * (y * c[2] - z * c[1]), v[1] + (2 / n) * (z * c[0] - x * c[2]), v[2] + (2 / n) * (x * c[1] - y * c[0])];
}
