// The surface of revolution: position, normal and colour of each corner of each triangle.
function surface(profile, sectors, colours) {
  const out = [], n = sectors.length;
  for (let k = 0; k + 1 < profile.length; k++) {
    const [[r0, z0], [r1, z1]] = [profile[k], profile[k + 1]], length = Math.hypot(r1 - r0, z1 - z0);
    const corner = (angle, r, z, colour) => {
      const c = Math.cos(angle), s = Math.sin(angle);
      out.push(r * c, r * s, z, (c * (z1 - z0)) / length, (s * (z1 - z0)) / length, (r0 - r1) / length, ...colour);
    };
    for (let i = 0; i < n; i++) {
      const a = (2 * Math.PI * i) / n, b = (2 * Math.PI * (i + 1)) / n, colour = colours[sectors[i]];
      if (r0 > 0) for (const [t, r, z] of [[a, r0, z0], [b, r0, z0], [b, r1, z1]]) corner(t, r, z, colour);
      if (r1 > 0) for (const [t, r, z] of [[a, r0, z0], [b, r1, z1], [a, r1, z1]]) corner(t, r, z, colour);
    }
  }
  return new Float32Array(out);
}

const TOP_VERTEX = `
attribute vec3 position, normal, colour; uniform vec4 q; uniform mat4 matrix;
varying vec3 n, at, tint;
vec3 turn(vec3 v) { return v + 2. * cross(q.yzw, cross(q.yzw, v) + q.x * v); }
void main() { n = turn(normal); at = turn(position); tint = colour; gl_Position = matrix * vec4(at, 1.); }`;
const TOP_FRAGMENT = `
precision highp float; varying vec3 n, at, tint; uniform vec3 light, eye;
void main() {
  vec3 m = normalize(n), h = normalize(light + normalize(eye - at));
  float lit = .30 + .12 * m.z + .62 * max(dot(m, light), 0.);
  gl_FragColor = vec4(sqrt(tint * tint * lit + .10 * pow(max(dot(m, h), 0.), 40.)), 1.);
}`;
const SHADOW_FRAGMENT = `
precision highp float; varying vec3 at, n, tint; uniform vec3 paper;
void main() { gl_FragColor = vec4(paper * mix(.62, .92, clamp(at.z / 3.2, 0., 1.)), 1.); }`;
const FLAT_VERTEX = `
attribute vec3 position; uniform mat4 matrix; varying vec3 at;
void main() { at = position; gl_Position = matrix * vec4(position, 1.); }`;
const GROUND_FRAGMENT = `
precision highp float; varying vec3 at; uniform vec3 paper;
void main() {
  float r = length(at.xy);
  float ring = smoothstep(.03, .0, abs(fract(r + .5) - .5)) * .05;
  gl_FragColor = vec4(paper * (1. - (.07 + ring) * smoothstep(4., 1., r)), 1.);
}`;
const TRAIL_FRAGMENT = `precision highp float; varying vec3 at; uniform vec3 paper; void main() { gl_FragColor = vec4(.84, .37, 0., 1.); }`;

// All that WebGL knows. `draw` paints one top in one part of the canvas.
class Scene {
  constructor(gl, model, shows, paper) {
    this.gl = gl;
    this.paper = paper;
    this.light = unit([0.45, -0.35, 0.85]);
    this.top = this.buffer(surface(model.profile, [...model.sectors].map(Number), model.colours));
    this.ground = this.buffer(new Float32Array([-5, -5, 0, 5, -5, 0, 5, 5, 0, -5, -5, 0, 5, 5, 0, -5, 5, 0]));
    const apex = [0, 0, model.profile[model.profile.length - 1][1]];
    this.trails = shows.map((show) => this.buffer(this.trail(show.quaternions, apex)));
    this.programs = {
      top: this.program(TOP_VERTEX, TOP_FRAGMENT),
      shadow: this.program(TOP_VERTEX, SHADOW_FRAGMENT),
      ground: this.program(FLAT_VERTEX, GROUND_FRAGMENT),
      trail: this.program(FLAT_VERTEX, TRAIL_FRAGMENT),
    };
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.SCISSOR_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  trail(quaternions, apex) {
    const out = new Float32Array((3 * quaternions.length) / 4);
    for (let k = 0; 4 * k < quaternions.length; k++) out.set(rotate(quaternions.subarray(4 * k, 4 * k + 4), apex), 3 * k);
    return out;
  }

  buffer(values) {
    const { gl } = this, buffer = gl.createBuffer();
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
      if (value.length === 16) gl.uniformMatrix4fv(at, false, value);
      else gl[`uniform${value.length}fv`](at, value);
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
    const { gl } = this, [x, y, width, height] = box, aspect = width / height;
    const { view, eye } = lookAt(camera.azimuth, camera.elevation, camera.distance, 1.35);
    const matrix = times(perspective(0.27 / Math.min(1, aspect), aspect, 0.5, 60), view);
    const q = attitude(show.quaternions, frame), fields = ["position", "normal", "colour"], corners = this.top.count / 9;
    gl.viewport(x, y, width, height);
    gl.scissor(x, y, width, height);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE); // the ground is seen from below too, and a shadow has no sides
    this.use("ground", this.ground, ["position"], { matrix });
    gl.drawArrays(gl.TRIANGLES, 0, 6);
    if (eye[2] > 0) {
      // A shadow fades with the height of what throws it: the upper cone first, so that the darker stays.
      this.use("shadow", this.top, fields, { matrix: times(matrix, shadowOf(this.light)), q });
      for (let part = 3; part >= 0; part--) gl.drawArrays(gl.TRIANGLES, (part * corners) / 4, corners / 4);
    }
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    this.use("top", this.top, fields, { matrix, q, eye, light: this.light });
    gl.drawArrays(gl.TRIANGLES, 0, corners);
    this.use("trail", this.trails[n], ["position"], { matrix });
    gl.drawArrays(gl.LINE_STRIP, 0, Math.floor(frame) + 1);
  }
}
