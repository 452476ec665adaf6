const MOST_SECTORS = 240; // an edge of a top's outline goes around in about so many steps: more cannot be seen

// Neighbouring sectors of one colour, each [from, to, colour] in radians.
function merged(sectors) {
  const n = sectors.length, most = Math.ceil(n / MOST_SECTORS), angle = (k) => (2 * Math.PI * k) / n, out = [];
  for (let start = 0, k = 1; k <= n; k++) {
    if (k < n && sectors[k] === sectors[start] && k - start < most) continue;
    out.push([angle(start), angle(k), sectors[start]]);
    start = k;
  }
  return out;
}

// The surface of revolution: position, normal and colour of each corner of each triangle.
function surface(profile, sectors, colours) {
  const out = [], around = merged(sectors);
  for (let k = 0; k + 1 < profile.length; k++) {
    const [[r0, z0], [r1, z1]] = [profile[k], profile[k + 1]], length = Math.hypot(r1 - r0, z1 - z0);
    const corner = (angle, r, z, colour) => {
      const c = Math.cos(angle), s = Math.sin(angle);
      out.push(r * c, r * s, z, (c * (z1 - z0)) / length, (s * (z1 - z0)) / length, (r0 - r1) / length, ...colour);
    };
    for (const [a, b, number] of around) {
      const colour = colours[number];
      if (r0 > 0) for (const [t, r, z] of [[a, r0, z0], [b, r0, z0], [b, r1, z1]]) corner(t, r, z, colour);
      if (r1 > 0) for (const [t, r, z] of [[a, r0, z0], [b, r1, z1], [a, r1, z1]]) corner(t, r, z, colour);
    }
  }
  return new Float32Array(out);
}

// Lighting that all shaders share, by the numbers of environment.toml in the page. Noise of one 8-bit step prevents
// banding in gradients.
const number = (table, name) => data.environment[table][name].toFixed(5);
const byPaper = (name) => `mix(${number("light", name)}, ${number("dark", name)}, dark)`;
const colourOf = (text) => [1, 3, 5].map((n) => parseInt(text.slice(n, n + 2), 16) / 255);
const DITHER = `
precision highp float; uniform vec3 paper;
vec4 dithered(vec3 c) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(.06711056, .00583715))));
  return vec4(c + (noise - .5) / 255., 1.);
}`;
const TOP_VERTEX = `
attribute vec3 position, normal, colour; uniform vec4 q; uniform vec3 size, place; uniform mat4 matrix;
varying vec3 n, at, tint;
vec3 turn(vec3 v) { return v + 2. * cross(q.yzw, cross(q.yzw, v) + q.x * v); }
void main() { n = turn(normal / size); at = turn(position * size) + place; tint = colour; gl_Position = matrix * vec4(at, 1.); }`;
// On dark paper a rim of light and a lift of the blacks show where the top ends.
const topFragment = () => `${DITHER}
varying vec3 n, at, tint; uniform vec3 light, glint, eye;
vec3 linear(vec3 c) { return mix(c / 12.92, pow((c + .055) / 1.055, vec3(2.4)), step(.04045, c)); }
vec3 encoded(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1. / 2.4)) - .055, step(.0031308, c)); }
void main() {
  vec3 m = normalize(n), view = normalize(eye - at), h = normalize(glint + view);
  float dark = 1. - smoothstep(.2, .6, paper.g);
  float lit = ${number("light", "sky")} + ${number("light", "rise")} * m.z + ${number("light", "bounce")} * max(-m.z, 0.) + ${number("light", "sun")} * max(dot(m, light), 0.);
  float white = ${number("light", "gloss")} * pow(max(dot(m, h), 0.), ${number("light", "sharpness")}) + ${byPaper("rim")} * pow(1. - max(dot(m, view), 0.), 3.);
  gl_FragColor = dithered(encoded(min(max(linear(tint), vec3(${byPaper("darkest")})) * lit + white, 1.)));
}`;
const FLAT_VERTEX = `
attribute vec3 position; uniform mat4 matrix; uniform vec2 shift; varying vec3 at;
void main() { at = position + vec3(shift, 0.); gl_Position = matrix * vec4(at, 1.); }`;
// The top as the cones of its outline: how much of each a ray to the light meets, softer the farther away it is; and
// darker near the top, as anim/picture/ground_kernels has it. A cone is discs across its axis or, where it is thin,
// balls. How far the ray passes outside the one it comes nearest to is the least of |a + t·b| − r(t), t from 0 to 1.
// Dark paper is lit by a pool of light.
const groundFragment = (cones) => `${DITHER}
varying vec3 at; uniform vec3 light, axis, place; uniform vec4 cones[${cones}]; uniform vec2 focus, reach; uniform float above;
float nearestOf(vec3 a, vec3 b, float grows) {
  float bb = max(dot(b, b), 1e-9), ab = dot(a, b), rest = bb - grows * grows;
  float t = rest > 0. ? (grows * sqrt(max(dot(a, a) * bb - ab * ab, 0.) / rest) - ab) / bb : grows > 0. ? 1. : 0.;
  return clamp(t, 0., 1.);
}
void main() {
  float r = length(at.xy - focus), far = length(at.xy), along = dot(light, axis), shade = 0., nearest = 1e9;
  vec3 from = place - at, height = axis * reach.y;
  float below = dot(height, light), part = clamp(dot(light * dot(from, light) - from, height - light * below) / max(dot(height, height) - below * below, 1e-6), 0., 1.);
  vec3 middle = from + part * height;
  float away = length(middle - light * dot(middle, light)) - reach.x;
  float close = length(from - axis * clamp(dot(from, axis), -reach.y, 0.)) - reach.x;
  along = along < 0. ? min(along, -.05) : max(along, .05);
  if (away < ${number("shadow", "sharp")} + ${number("shadow", "soft")} * (reach.y + reach.x) || close < 3. * ${number("shadow", "reach")}) for (int k = 0; k < ${cones}; k++) {
    float z0 = cones[k].x, z1 = cones[k].z, r0 = cones[k].y, grows = cones[k].w - r0, rise = z1 - z0;
    vec3 v = from + axis * z0, w = axis * rise;
    float high = dot(v, axis), out_ = sqrt(max(0., dot(v, v) - high * high));
    float t0 = clamp(-high / max(rise, 1e-6), 0., 1.), gap = max(out_ - r0 - t0 * grows, 0.);
    nearest = min(nearest, pow(max(abs(high + t0 * rise) - .035, 0.), 2.) + gap * gap);
    bool thin = rise > 2. * abs(grows);
    vec3 slant = thin ? light : light / along;
    vec3 a = v - slant * (thin ? dot(v, light) : high), b = w - slant * (thin ? rise * dot(axis, light) : rise);
    float t = nearestOf(a, b, grows), radius = r0 + t * grows, s = thin ? dot(v + t * w, light) : (high + t * rise) / along;
    float wide = ${number("shadow", "sharp")} + ${number("shadow", "soft")} * abs(s), d = length(a + t * b);
    if (s > 0.) shade = max(shade, smoothstep(radius + wide, radius - wide, d) * min(1., radius / wide));
  }
  float near = smoothstep(${number("ground", "far")}, ${number("ground", "near")}, r), dark = 1. - smoothstep(.2, .6, paper.g);
  float ring = far > .5 ? smoothstep(.03, .0, abs(fract(far + .5) - .5)) * ${number("ground", "ring")} : 0.;
  vec3 lit = mix(paper * (1. - (${number("ground", "shade")} + ring) * near), paper + (${number("ground", "pool")} - ring * .5) * near, dark);
  float contact = ${number("shadow", "contact")} * exp(-nearest / ${(data.environment.shadow.reach ** 2).toFixed(5)});
  gl_FragColor = dithered(above > 0. ? lit * (1. - ${number("shadow", "depth")} * shade) * (1. - contact) : lit);
}`;
const TRAIL_FRAGMENT = `precision highp float; varying vec3 at; uniform vec3 ink; void main() { gl_FragColor = vec4(ink, 1.); }`;
const FAINTEST = 0.22, FADING = 2; // of the path: the least strength, and the seconds in which the rest falls to 1/e
const SHAFT = 0.024, HEAD = [0.07, 0.26]; // radii of an arrow's shaft and head, and how long the head is
const ARROWS = { momentum: [0.2, 0.55, 0.9], velocity: [0, 0.62, 0.45], pull: [0.85, 0.35, 0.6] };

// All that WebGL knows. `draw` paints one top in one part of the canvas.
class Scene {
  constructor(gl, model, shows, paper) {
    this.gl = gl;
    this.paper = paper;
    const { aside, height, window: low } = data.environment.light, turn = data.camera.azimuth + (aside * Math.PI) / 180;
    const towards = (rise) => [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)];
    this.light = towards((height * Math.PI) / 180);
    this.glint = towards((low * Math.PI) / 180); // what is mirrored in the top: a window below the light
    this.model = model;
    this.shape(model.profile);
    this.arrows = Object.entries(ARROWS).map(([name, colour]) => {
      const around = Array(24).fill(0), mesh = (outline) => this.buffer(surface(outline, around, [colour]));
      return [name, mesh([[0, 0], [SHAFT, 0], [SHAFT, 1], [0, 1]]), mesh([[0, 0], [HEAD[0], 0], [0, HEAD[1]]])];
    });
    this.ground = this.buffer(new Float32Array([-5, -5, 0, 5, -5, 0, 5, 5, 0, -5, -5, 0, 5, 5, 0, -5, 5, 0]));
    const apex = [0, 0, model.profile[model.profile.length - 1][1]];
    this.trails = shows.map((show) => this.buffer(this.trail(show, apex)));
    this.programs = {
      top: this.program(TOP_VERTEX, topFragment()),
      ground: this.program(FLAT_VERTEX, groundFragment(model.profile.length - 1)),
      trail: this.program(FLAT_VERTEX, TRAIL_FRAGMENT),
    };
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.SCISSOR_TEST);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  // The top's outline, which may change: its surface, and for the shadow its cones: height and radius where they begin and end.
  shape(profile) {
    if (this.top) this.gl.deleteBuffer(this.top);
    this.top = this.buffer(surface(profile, [...this.model.sectors].map(Number), this.model.colours));
    this.height = profile[profile.length - 1][1];
    this.reach = [Math.max(...profile.map(([r]) => r)), this.height];
    this.cones = profile.slice(1).flatMap(([r, z], n) => [profile[n][1], profile[n][0], z, r]);
  }

  trail({ quaternions, places }, apex) {
    const out = new Float32Array((3 * quaternions.length) / 4);
    for (let k = 0; 4 * k < quaternions.length; k++) out.set(rotate(quaternions.subarray(4 * k, 4 * k + 4), apex).map((x, n) => x + (places?.[3 * k + n] ?? 0)), 3 * k);
    return out;
  }

  buffer(values, buffer = this.gl.createBuffer()) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
    buffer.count = values.length;
    return buffer;
  }

  program(...sources) {
    const { gl } = this, program = gl.createProgram();
    sources.forEach((source, n) => {
      const shader = gl.createShader(n ? gl.FRAGMENT_SHADER : gl.VERTEX_SHADER);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    gl.bindAttribLocation(program, 0, "position");
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "no program");
    return program;
  }

  use(name, buffer, fields, uniforms) {
    const { gl } = this, program = this.programs[name], stride = 12 * fields.length;
    gl.useProgram(program);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    fields.forEach((field, n) => {
      const at = gl.getAttribLocation(program, field);
      if (at < 0) return; // the compiler drops what a shader does not read
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 3, gl.FLOAT, false, stride, 12 * n);
    });
    for (const [key, value] of Object.entries({ paper: this.paper, ...uniforms })) {
      const at = gl.getUniformLocation(program, key);
      if (key === "cones") gl.uniform4fv(at, value);
      else if (value.length === 16) gl.uniformMatrix4fv(at, false, value);
      else gl[`uniform${value.length > 4 ? 3 : value.length}fv`](at, value);
    }
  }

  clear(width, height) {
    const { gl } = this;
    gl.scissor(0, 0, width, height);
    gl.clearColor(...this.paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  // `box` is x, y, width, height in pixels; `frame` may lie between two frames.
  draw(n, show, frame, camera, box) {
    const k = Math.floor(frame), t = frame - k, { places } = show;
    const place = places ? [0, 1, 2].map((n) => places[3 * k + n] + t * ((places[3 * k + 3 + n] ?? places[3 * k + n]) - places[3 * k + n])) : [0, 0, 0];
    this.paint(attitude(show.quaternions, frame), this.trails[n], Array.from({ length: k + 1 }, (_, m) => (frame - m) / data.fps), {}, camera, box, place);
  }

  // The top as `q` says at its `place`, the view on its `focus`; the points of a trail by their `ages`, and vectors from the tip (or from `from`); returns the matrix of the view.
  paint(q, trail, ages, vectors, camera, box, place = [0, 0, 0], focus = [0, 0]) {
    const { gl } = this, [x, y, width, height] = box, aspect = width / height;
    const { view, eye } = lookAt(camera.azimuth, camera.elevation, camera.distance, [...focus, 1.35]);
    const matrix = times(perspective(0.27 / Math.min(1, aspect), aspect, 0.5, 60), view);
    const fields = ["position", "normal", "colour"], { light, glint, cones, reach } = this, size = [1, 1, 1];
    gl.viewport(x, y, width, height);
    gl.scissor(x, y, width, height);
    const axis = rotate(q, [0, 0, 1]);
    this.use("top", this.top, fields, { matrix, q, size, place, eye, light, glint });
    gl.drawArrays(gl.TRIANGLES, 0, this.top.count / 9);
    gl.disable(gl.CULL_FACE); // the ground is seen from below too
    gl.depthRange(1, 1); // and only where the top is not
    this.use("ground", this.ground, ["position"], { matrix, light, axis, place, cones, reach, focus, shift: focus, above: [eye[2]] });
    gl.drawArrays(gl.TRIANGLES, 0, 6);
    gl.depthRange(0, 1);
    gl.enable(gl.CULL_FACE);
    this.path(trail, ages, matrix);
    for (const [name, shaft, head] of this.arrows) {
      const { vector, from = [0, 0, 0] } = vectors[name] ?? {}, length = vector ? Math.hypot(...vector) : 0;
      if (length < 0.05) continue;
      const q = towards(vector), tall = Math.min(HEAD[1], 0.6 * length), neck = length - tall;
      const place = from.map((x, n) => x + (vector[n] * neck) / length);
      this.use("top", shaft, fields, { matrix, q, size: [1, 1, neck], place: from, eye, light, glint });
      gl.drawArrays(gl.TRIANGLES, 0, shaft.count / 9);
      this.use("top", head, fields, { matrix, q, size: scale(tall / HEAD[1], [1, 1, 1]), place, eye, light, glint });
      gl.drawArrays(gl.TRIANGLES, 0, head.count / 9);
    }
    return matrix;
  }

  // The first ages.length points of a trail, each passed so many seconds ago; it fades with age as in films.
  path(trail, ages, matrix) {
    const { gl } = this, ink = colourOf(data.environment.trace[this.paper[1] < 0.4 ? "dark" : "light"]);
    const strength = (age) => FAINTEST + (1 - FAINTEST) * Math.exp(-age / FADING);
    this.use("trail", trail, ["position"], { matrix, shift: [0, 0] });
    const at = gl.getUniformLocation(this.programs.trail, "ink");
    for (let k = 0; k + 1 < ages.length; ) {
      const now = strength(ages[k]);
      let end = k + 1;
      while (end + 1 < ages.length && Math.abs(strength(ages[end]) - now) < 0.04) end++;
      gl.uniform3fv(at, ink.map((x, n) => this.paper[n] + (x - this.paper[n]) * now));
      gl.drawArrays(gl.LINE_STRIP, k, end - k + 1);
      k = end;
    }
  }
}
