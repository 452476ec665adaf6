// The live top: launched with sliders, pulled by hand, its state in the link. It plays in the player's place.
const SLIDERS = [
  // name, label, least, most, step, unit, whether it starts anew
  ["spin", "spin", -60, 60, 0.1, "rad/s", true],
  ["tilt", "tilt", 0, 40, 0.5, "°", true],
  ["tip", "tip radius", 0, 12, 0.5, "cm", true], // 0: the tip is held where it is
  ["grip", "friction μ", 0, 1, 0.01, "", false],
  ["friction", "damping", 0, 5, 0.05, "×", false],
  ["gravity", "gravity", 0, 25, 0.05, "m/s²", false],
  ["width", "width", 0.6, 1.4, 0.01, "×", false],
];
const TRACE = 3000, MOST_LINKED = 120, MOST_STEPS = 4000, DEGREE = Math.PI / 180;

class Simulator {
  constructor(player, start) {
    Object.assign(this, { player, start });
    const slow = start.losses.every((loss) => loss === 0);
    this.losses = slow ? [1 / 12, 1 / 40] : start.losses; // what friction 1 stands for
    this.first = { spin: start.spin, tilt: start.tilt / DEGREE, tip: 100 * start.contact.radius, grip: start.contact.friction, friction: slow ? 0 : 1, gravity: start.gravity, width: 1 };
    this.set = { ...this.first };
    this.trace = new Float32Array(3 * TRACE);
    this.passed = new Float64Array(TRACE); // when the apex was at each point of the trace
    this.pulled = null; // where the hand holds the apex, in space
    this.fields = Object.fromEntries(SLIDERS.map((slider) => [slider[0], this.slider(slider)]));
    this.readings = ["tilt", "spin", "energy", "lost", "L vertical", "time"].map((name) => {
      const row = $("readings").appendChild(document.createElement("tr"));
      Object.assign(row.appendChild(document.createElement("th")), { textContent: name, scope: "row" });
      return row.appendChild(document.createElement("td"));
    });
    this.labels = [["momentum", "L"], ["velocity", "ω"]].map(([name, text]) => {
      const label = $("labels").appendChild(document.createElement("b"));
      [label.textContent, label.hidden] = [text, true];
      return [name, label];
    });
    $("launch").addEventListener("click", () => this.launch(true));
    $("push").addEventListener("click", () => this.push());
    $("share").addEventListener("click", () => this.share());
    $("record").addEventListener("click", () => this.record());
    $("vectors").addEventListener("change", () => (player.stale = true));
    $("share").hidden = location.protocol === "about:"; // in a notebook's frame, which has no address
    if (!window.MediaRecorder || !$("view").captureStream) $("record").hidden = true;
    this.read();
    addEventListener("hashchange", () => this.read());
  }

  slider([name, label, low, high, step, unit, anew]) {
    const widest = Math.max(high, Math.ceil(1.5 * Math.abs(this.first[name])));
    const row = $("sliders").appendChild(document.createElement("label"));
    row.append(label);
    const told = row.appendChild(document.createElement("span"));
    const input = row.appendChild(document.createElement("input"));
    Object.assign(input, { type: "range", name, min: low < 0 ? -widest : low, max: widest, step });
    const show = () => {
      const value = this.set[name];
      input.value = value;
      told.textContent = `${value.toFixed(step < 0.5 ? 2 : 1)} ${unit}`;
      input.setAttribute("aria-valuetext", told.textContent);
    };
    input.addEventListener("input", () => {
      this.set[name] = Number(input.value);
      show();
      this.change(anew);
    });
    return { show, input, low: Number(input.min), high: widest };
  }

  // Takes over what the sliders say; launch conditions start the top anew.
  change(anew) {
    const { friction, gravity, width } = this.set, { profile } = data.model;
    this.body = widenedBody(this.start.body, profile, width);
    const losses = this.losses.map((loss) => friction * loss);
    this.rates = ratesOf(this.body, gravity, losses);
    this.ball = this.set.tip / 100;
    this.edges = edgesOf(this.body, widened(profile, width).map((corner) => scale(this.body.unit, corner)), this.ball);
    this.ground = groundOf(this.body, gravity, losses, { friction: this.set.grip, rolling: this.start.contact.rolling });
    this.fields.grip.input.disabled = !this.ball;
    if (this.width !== width) {
      this.width = width;
      this.player.scene?.shape(widened(profile, width));
    }
    if (anew) this.launch(false);
    else if (!this.state.y && vertical(this.state.q)[2] < this.rates.floor) this.land();
    this.player.stale = true;
    this.link(false);
  }

  launch(play) {
    this.width = NaN;
    this.state = launched({ ...this.start, spin: this.set.spin, tilt: this.set.tilt * DEGREE });
    Object.assign(this, { time: 0, owed: 0, landed: null, traced: 0, focus: [0, 0] });
    this.change(false);
    const limit = this.body.reach - 1e-3;
    if (this.set.tilt * DEGREE > limit && this.landed !== null) {
      this.set.tilt = limit / DEGREE;
      return this.launch(play);
    }
    if (this.ball) this.state = letGo(this.state, this.body, this.ball, this.set.gravity);
    for (const { show } of Object.values(this.fields)) show();
    const { momentum, velocity } = this.quantities();
    this.scales = { momentum: 3.9 / Math.max(Math.hypot(...momentum), 1e-9), velocity: 3.5 / Math.max(Math.hypot(...velocity), 1e-9) };
    if (play && !this.player.playing) this.player.toggle();
  }

  land() {
    [this.landed, this.state] = [this.time, { q: this.state.q, w: [0, 0, 0] }];
  }

  quantities() {
    if (this.state.y) return freeQuantities(this.state, this.body, this.edges, this.ground);
    return quantities(this.state, this.body, this.set.gravity);
  }

  // Whole steps only, so that what happens does not hang on how often the screen is drawn.
  advance(seconds) {
    this.owed += seconds;
    const { y } = this.state, fixed = y && freeStep(this.body, this.state, this.set.gravity);
    for (let n = 0; n < MOST_STEPS && (y || this.landed === null); n++) {
      const h = fixed ?? Math.min(longestStep(this.state, this.rates), 0.01);
      if (this.owed < h) break;
      if (this.pulled) this.kick(h / 2);
      const { rest = null, ...state } = y ? stepOnGround(this.state, h, this.edges, this.ground) : stepToGround(this.state, h, this.rates);
      this.state = state;
      this.time += rest ?? h;
      this.owed -= h;
      if (y && this.landed === null && isDown(state, this.edges)) this.landed = this.time;
      if (rest !== null) this.land();
      else if (this.pulled) this.kick(h / 2);
      this.mark();
    }
    this.owed = Math.min(this.owed, 0.05);
  }

  height() {
    return this.player.scene?.height ?? 3;
  }

  apex() {
    const tip = tipOf(this.state, this.body);
    return rotate(this.state.q, [0, 0, this.height()]).map((x, n) => x + tip[n]);
  }

  // The hand holds the apex by an elastic: a twelfth of the top's weight for each unit that it is stretched.
  kick(h) {
    const apex = this.apex(), gap = this.pulled.map((x, n) => x - apex[n]);
    const force = seenFromBody(this.state.q, scale(this.body.mass * 9.80665 / 12, gap));
    const { w, y, q } = this.state, reach = this.body.unit * this.height();
    const arm = (y ? (reach - this.body.height) / (this.ground.transverse * this.body.mass) : reach / this.body.transverse) * h;
    this.spins([w[0] - arm * force[1], w[1] + arm * force[0], w[2]]);
    if (y) seenFromSpace(q, force).forEach((x, n) => (y[10 + n] += (x * h) / this.body.mass));
  }

  spins(w) {
    this.state.w = w;
    this.state.y?.set(w, 4);
  }

  // A blow against the apex, square to the top's lean.
  push() {
    if (this.landed !== null) return;
    const { w } = this.state;
    this.spins([w[0] + 0.3 * Math.sqrt(torqueOf(this.body, 9.80665) / this.body.transverse), w[1], w[2]]);
    this.player.stale = true;
  }

  mark() {
    const here = this.apex(), k = this.traced;
    if (k && Math.hypot(...here.map((x, n) => x - this.trace[3 * k - 3 + n])) < 0.012) return;
    if (k === TRACE) {
      this.trace.copyWithin(0, 3);
      this.passed.copyWithin(0, 1);
    }
    this.trace.set(here, 3 * Math.min(k, TRACE - 1));
    this.passed[Math.min(k, TRACE - 1)] = this.time;
    this.traced = Math.min(k + 1, TRACE);
  }

  paint(box, ratio) {
    const { scene, camera } = this.player, found = this.quantities(), tip = tipOf(this.state, this.body), shown = {};
    if ($("vectors").checked) for (const [name] of this.labels) shown[name] = { vector: scale(this.scales[name], found[name]), from: tip };
    if (this.pulled) {
      const from = this.apex();
      shown.pull = { vector: this.pulled.map((x, n) => x - from[n]), from };
    }
    this.buffer = scene.buffer(this.trace.subarray(0, 3 * this.traced), this.buffer && scene.gl.isBuffer(this.buffer) ? this.buffer : undefined);
    this.focus = this.focus.map((x, n) => x + 0.06 * (tip[n] - x)); // the view follows a top that wanders
    const ages = Array.from(this.passed.subarray(0, this.traced), (then) => this.time - then);
    this.matrix = scene.paint(this.state.q, this.buffer, ages, shown, camera, box, tip, this.focus);
    const places = [];
    for (const [name, label] of this.labels) {
      const vector = shown[name]?.vector;
      label.hidden = !vector || Math.hypot(...vector) < 0.05;
      if (label.hidden) continue;
      const [x, y] = projected(this.matrix, vector.map((part, n) => part + tip[n]));
      places.push([label, ((x + 1) / 2) * (box[2] / ratio), ((1 - y) / 2) * (box[3] / ratio) - 12]);
    }
    // The labels stand to the right of the heads; where two would touch, the one of the head on the left stands to its left.
    const touch = places.length === 2 && Math.abs(places[0][1] - places[1][1]) < 26 && Math.abs(places[0][2] - places[1][2]) < 24;
    if (touch) places.sort((a, b) => a[1] - b[1]);
    places.forEach(([label, x, y], n) => Object.assign(label.style, { left: `${touch && !n ? x - 10 - label.offsetWidth : x + 8}px`, top: `${y}px` }));
  }

  tell() {
    const { energy, lost, about, tilt } = this.quantities();
    const said = [`${(tilt / DEGREE).toFixed(1)}°`, `${this.state.w[2].toFixed(2)} rad/s`, `${energy.toPrecision(5)} J`, lost === undefined ? "" : `${lost.toPrecision(4)} J`, `${about.toPrecision(5)} kg m²/s`,
      this.landed === null ? `${this.time.toFixed(2)} s` : `${this.time.toFixed(2)} s, fallen`];
    this.readings.forEach((cell, n) => {
      cell.textContent = said[n];
      cell.parentNode.hidden = !said[n];
    });
  }

  // Whether a point of the view, x and y from −1 to 1, is on the top: near its axis as it is seen.
  holds([x, y], aspect) {
    const [x0, y0] = projected(this.matrix, tipOf(this.state, this.body)), [x1, y1] = projected(this.matrix, this.apex());
    const [u, v, p, q] = [(x1 - x0) * aspect, y1 - y0, (x - x0) * aspect, y - y0], length = Math.hypot(u, v);
    const along = (p * u + q * v) / (length * length || 1);
    return along > -0.05 && along < 1.15 && Math.hypot(p - along * u, q - along * v) < 0.3 * Math.max(length, 0.3);
  }

  // The hand has gone from one point of the view to another; the apex is held so far from where it is, seen by the camera.
  pull([x0, y0], [x, y], aspect) {
    const { azimuth, elevation, distance } = this.player.camera, apex = this.apex();
    const wide = (0.27 / Math.min(1, aspect)) * distance, right = (x - x0) * wide * aspect, up = (y - y0) * wide;
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(elevation), Math.sin(elevation)];
    const stretch = Math.min(1, 4 / Math.hypot(right, up));
    this.pulled = [-sa * right - se * ca * up, ca * right - se * sa * up, ce * up].map((part, n) => apex[n] + stretch * part);
    if (this.landed !== null && !this.state.y) this.launch(true);
    this.player.stale = true;
  }

  release() {
    this.pulled = null;
    this.player.stale = true;
    this.link(false);
  }

  // The link holds the sliders and, where `exact`, the very state and the view.
  link(exact) {
    const words = Object.entries(this.set).filter(([name, value]) => value !== this.first[name]).map(([name, value]) => [name, +value.toPrecision(6)]);
    const { azimuth, elevation, distance } = this.player.camera;
    if (exact) words.push(["q", this.state.q.join()], ["w", this.state.w.join()], ["t", this.time], ["view", [azimuth, elevation, distance].map((x) => x.toFixed(4)).join()]);
    if (exact && this.state.y) words.push(["x", this.state.y.slice(7, 14).join()]); // the place, its speed, and what is lost
    if (exact && this.landed !== null) words.push(["fell", this.landed]);
    if (exact && this.traced) words.push(["path", this.pathWords()]);
    if (this.reading || (!exact && !words.length && !location.hash)) return;
    try {
      history.replaceState(null, "", `#${new URLSearchParams(words).toString().replaceAll("%2C", ",")}`);
    } catch {} // a page inside another may not
  }

  // The path of the apex as the link holds it: at most so many points, each x, y, z and the time.
  pathWords() {
    const every = Math.ceil(this.traced / MOST_LINKED), last = this.traced - 1, chosen = [];
    for (let k = last; k >= 0; k -= every) chosen.unshift(k);
    return chosen.map((k) => [...this.trace.subarray(3 * k, 3 * k + 3), this.passed[k]].map((x) => +x.toFixed(3)).join()).join();
  }

  readPath(text) {
    const numbers = (text ?? "").split(",").map(Number);
    if (!text || numbers.length % 4 || numbers.length > 4 * TRACE || !numbers.every((x) => Math.abs(x) < 1e6)) return;
    this.traced = numbers.length / 4;
    for (let k = 0; k < this.traced; k++) {
      this.trace.set(numbers.slice(4 * k, 4 * k + 3), 3 * k);
      this.passed[k] = numbers[4 * k + 3];
    }
  }

  read() {
    const words = new URLSearchParams(location.hash.slice(1)), numbers = (name, n) => {
      const found = (words.get(name) ?? "").split(",").map((text) => (text.trim() ? Number(text) : NaN));
      return found.length === n && found.every(Number.isFinite) ? found : null;
    };
    this.reading = true; // nothing is written back while it is read
    for (const [name, { low, high }] of Object.entries(this.fields)) {
      const [value] = numbers(name, 1) ?? [this.first[name]];
      this.set[name] = Math.max(low, Math.min(high, value));
    }
    this.launch(false);
    const q = numbers("q", 4), w = numbers("w", 3), size = q && Math.hypot(...q), view = numbers("view", 3);
    if (q && w && size > 1e-9 && Math.max(...w.map(Math.abs)) < 1e4) {
      this.state = { q: scale(1 / size, q), w };
      const moved = numbers("x", 7) ?? numbers("x", 6);
      if (this.ball) this.state = letGo(this.state, this.body, this.ball, this.set.gravity);
      if (this.ball && moved && Math.max(...moved.map(Math.abs)) < 1e4) this.state.y.set(moved, 7);
      this.time = numbers("t", 1)?.[0] ?? 0;
      this.landed = numbers("fell", 1)?.[0] ?? null;
      this.readPath(words.get("path"));
      this.focus = tipOf(this.state, this.body).slice(0, 2);
      if (!this.ball && vertical(this.state.q)[2] < this.rates.floor + 1e-12) this.land();
      this.still = true; // the moment that was sent, until it is played on
      if (this.player.playing) this.player.toggle();
    }
    if (view) {
      Object.assign(this.player.camera, { azimuth: view[0], elevation: 0, distance: 9 });
      this.player.orbit(0, view[1]);
      this.player.zoom(view[2] / 9);
    }
    this.reading = false;
    this.player.stale = true;
  }

  share() {
    if (this.player.playing) this.player.toggle();
    this.link(true);
    navigator.clipboard?.writeText(location.href).catch(() => {});
    $("share").textContent = "in the address bar";
    setTimeout(() => ($("share").textContent = "link"), 1500);
  }

  // A film of what the view shows, until the button is pressed again.
  record() {
    if (this.recorder) return this.recorder.stop();
    const parts = [], recorder = (this.recorder = new MediaRecorder($("view").captureStream(50)));
    recorder.ondataavailable = (event) => parts.push(event.data);
    recorder.onstop = () => {
      const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(new Blob(parts, { type: recorder.mimeType })), download: "top.webm" });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1e4);
      this.recorder = null;
      $("record").textContent = "record";
    };
    recorder.start();
    $("record").textContent = "stop";
    if (!this.player.playing) this.player.toggle();
  }
}
