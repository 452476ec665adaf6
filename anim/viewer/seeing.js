// Unit quaternions seen: S³ from −1 by stereographic projection, x ↦ p·x·q as what it does there, and the units over
// GF(3) and GF(5), which are the corners of the 24-cell and of the 600-cell taken modulo 3 and √5.
const $ = (id) => document.getElementById(id), PHI = (1 + Math.sqrt(5)) / 2, ONE = [1, 0, 0, 0];
const TWICE_AROUND = 16;
const FAR = -0.97; // what is nearer to −1 than this lies too far away to be drawn
const hamilton = ([a, b, c, d], [e, f, g, h]) => [
  a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e,
];
const conjugate = ([a, b, c, d]) => [a, -b, -c, -d];
const turning = (x, y, z, half) => [Math.cos(half), ...[x, y, z].map((part) => part * Math.sin(half))];

// The corners as twice their coordinates, each a pair [a, b] for a + bφ.
function corners(prime) {
  const out = [], signs = [1, -1], place = (values) => out.push(values);
  for (let n = 0; n < 4; n++) for (const s of signs) place([0, 1, 2, 3].map((m) => [m === n ? 2 * s : 0, 0]));
  for (let n = 0; n < 16; n++) place([0, 1, 2, 3].map((m) => [(n >> m) & 1 ? 1 : -1, 0]));
  if (prime === 5)
    for (const order of ["0123", "0231", "0312", "1032", "1203", "1320", "2013", "2130", "2301", "3021", "3102", "3210"])
      for (const s of signs) for (const t of signs) for (const u of signs) {
        const values = [[0, s], [t, 0], [-u, u], [0, 0]]; // φ, 1, 1/φ = φ − 1, 0
        place([...order].map((k) => values[k]));
      }
  return out;
}
// φ is 1/2 modulo √5, and 2 has an inverse: (prime + 1)/2.
const reduced = (corner, prime) => corner.map(([a, b]) => ((((a + 3 * b) * ((prime + 1) / 2)) % prime) + prime) % prime);
const placed = (corner) => corner.map(([a, b]) => (a + b * PHI) / 2);

// Fibres of the map of Hopf: circles x·e^{kt} over some points of the sphere.
function fibres() {
  const out = [];
  for (const [eta, count] of [[0, 1], [0.45, 7], [0.95, 11], [Math.PI / 2, 1]])
    for (let n = 0; n < count; n++) {
      const a = (2 * Math.PI * n) / count, start = [Math.cos(eta), Math.sin(eta) * Math.cos(a), Math.sin(eta) * Math.sin(a), 0];
      const line = Array.from({ length: 193 }, (_, k) => hamilton(start, turning(0, 0, 1, (2 * Math.PI * k) / 192)));
      out.push({ line, hue: (360 * (n + eta)) / count });
    }
  return out;
}

class Seeing {
  constructor() {
    Object.assign(this, { base: ONE, view: [0.5, 0.35], goal: null, chosen: null, circles: fibres() });
    for (const name of ["space", "side", "axis", "turn"]) $(name).addEventListener("input", () => this.change(name));
    $("unit").addEventListener("input", () => ($("unit").value ? this.take(Number($("unit").value)) : this.reset()));
    $("back").addEventListener("click", () => this.reset());
    $("play").addEventListener("click", () => this.play(!this.playing));
    for (const kind of ["input", "pointerdown"]) document.addEventListener(kind, (e) => e.target.id !== "play" && this.play(false), true);
    const view = $("view");
    view.addEventListener("pointerdown", (e) => { this.held = this.began = [e.clientX, e.clientY]; view.setPointerCapture(e.pointerId); });
    view.addEventListener("pointermove", (e) => this.held && this.drag([e.clientX, e.clientY]));
    view.addEventListener("pointerup", (e) => {
      if (Math.hypot(e.clientX - this.began[0], e.clientY - this.began[1]) < 5) this.choose(e);
      this.held = null;
    });
    view.addEventListener("pointercancel", () => (this.held = null));
    view.addEventListener("keydown", (e) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
      if (!way) return;
      e.preventDefault();
      this.play(false);
      this.held = [0, 0];
      this.drag(way.map((x) => 13 * x)); // p by 5 degrees
      this.held = null;
    });
    document.addEventListener("keydown", (e) => e.key === "Escape" && this.reset());
    new ResizeObserver(() => this.draw()).observe(view);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    this.change("space");
    this.play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
  }

  // The slider runs by itself, twice around in as many seconds as TWICE_AROUND, until somebody takes over.
  play(playing) {
    const began = playing && !this.playing;
    [this.playing, this.before] = [playing, null];
    $("play").textContent = playing ? "pause" : "play";
    if (began) requestAnimationFrame((now) => this.tick(now));
  }

  tick(now) {
    if (!this.playing) return;
    const seconds = Math.min(0.25, (now - (this.before ?? now)) / 1000);
    this.before = now;
    this.angle = (Number(this.shown === $("turn").value ? this.angle : $("turn").value) + (720 * seconds) / TWICE_AROUND) % 720;
    $("turn").value = Math.round(this.angle);
    this.shown = $("turn").value; // of its own, not a reader's
    this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  get prime() { return Number($("space").value); }

  change(name) {
    if (name === "space") {
      const prime = this.prime, list = prime ? corners(prime) : [];
      [this.points, this.names] = [list.map(placed), list.map((corner) => reduced(corner, prime))];
      $("unit").parentElement.hidden = !prime;
      $("unit").replaceChildren(new Option("none", ""), ...this.names.map((name, n) => new Option(`(${name.join(", ")})`, n)));
      const near = prime === 3 ? 0.49 : 0.8;
      this.edges = [];
      this.points.forEach((p, m) => this.points.forEach((q, n) => m < n && p.reduce((sum, x, k) => sum + x * q[k], 0) > near && this.edges.push([m, n])));
      this.reset();
    } else this.draw();
  }

  reset() {
    this.play(false);
    Object.assign(this, { base: ONE, chosen: null });
    $("turn").value = 0;
    $("unit").value = "";
    this.draw();
  }

  // The slider leads from 1 to the unit g.
  take(number) {
    [this.base, this.chosen] = [ONE, number];
    $("turn").value = 360;
    $("unit").value = number;
    this.draw();
  }

  // The quaternion of the turn: of the slider about its axis, after what the hand has done.
  get turn() {
    const half = (Number($("turn").value) * Math.PI) / 360;
    if (this.chosen !== null) {
      const [w, ...v] = this.points[this.chosen], size = Math.hypot(...v), part = Number($("turn").value) / 360, angle = Math.atan2(size, w) * part;
      return size > 1e-9 ? turning(...v.map((x) => x / size), angle) : turning(0, 0, 1, angle);
    }
    return hamilton(turning(...{ i: [1, 0, 0], j: [0, 1, 0], k: [0, 0, 1] }[$("axis").value], half), this.base);
  }

  moved(x, p) {
    const side = $("side").value;
    return side === "left" ? hamilton(p, x) : side === "right" ? hamilton(x, p) : hamilton(hamilton(p, x), conjugate(p));
  }

  drag(at) {
    const [dx, dy] = [(at[0] - this.held[0]) / 150, (at[1] - this.held[1]) / 150];
    this.held = at;
    if ($("hand").value === "view") this.view = [this.view[0] + dx, Math.max(-1.5, Math.min(1.5, this.view[1] + dy))];
    else if (this.chosen === null) this.base = hamilton(hamilton(turning(0, 0, 1, dx), turning(1, 0, 0, dy)), this.base);
    this.draw();
  }

  // Over a finite field a click takes the nearest unit.
  choose(event) {
    if (!this.prime) return;
    const box = $("view").getBoundingClientRect(), at = [event.clientX - box.left, event.clientY - box.top];
    const far = this.points.map((x) => { const there = this.moved(x, this.turn), [u, v] = this.seen(there); return there[0] < FAR ? Infinity : Math.hypot(u - at[0], v - at[1]); });
    const nearest = far.indexOf(Math.min(...far));
    if (far[nearest] <= 30) this.take(nearest);
  }

  // Where a unit quaternion is seen: x, y in pixels, depth from −1 to 1.
  seen([w, x, y, z]) {
    const s = 1 / Math.max(1 + w, 0.04), [a, b] = this.view, [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
    const right = s * (ca * x + sa * y), back = s * (-sa * x + ca * y), up = s * z;
    return [this.width / 2 + this.size * right, this.height / 2 - this.size * (cb * up - sb * back), Math.tanh(-(cb * back + sb * up))];
  }

  draw() {
    const view = $("view"), ratio = window.devicePixelRatio || 1, style = getComputedStyle(document.documentElement);
    [this.width, this.height] = [view.clientWidth, view.clientHeight];
    [view.width, view.height] = [this.width * ratio, this.height * ratio];
    this.size = Math.min(this.width, this.height) / 5;
    const c = view.getContext("2d"), p = this.turn, dark = matchMedia("(prefers-color-scheme: dark)").matches;
    c.scale(ratio, ratio);
    c.lineCap = c.lineJoin = "round";
    const strokes = [];
    // Pieces of nearly one depth: where two pieces end, their smoothed edges lie upon each other, and that shows as a bead.
    const stroke = (line, hue) => {
      let piece = [];
      const end = (next) => {
        if (piece.length > 1) strokes.push([(piece[0][2] + piece.at(-1)[2]) / 2, piece, hue]);
        piece = next;
      };
      for (const x of line) {
        const at = this.seen(x), last = piece.at(-1);
        if (x[0] < FAR) end([]);
        else if (last && Math.hypot(at[0] - last[0], at[1] - last[1]) > 4 * this.size) end([at]);
        else if (piece.push(at) && Math.abs(at[2] - piece[0][2]) > 0.12) end([at]);
      }
      end([]);
    };
    if (!this.prime)
      for (const { line, hue } of this.circles) stroke(line.map((x) => this.moved(x, p)), hue);
    const points = this.points.map((x) => this.moved(x, p));
    for (const [m, n] of this.edges) stroke([points[m], points[n]], 210);
    strokes.sort((a, b) => a[0] - b[0]);
    for (const [depth, piece, hue] of strokes) {
      // Circles are opaque, paler with distance: of what shines through, the ends of the pieces would show as well.
      const near = (depth + 1) / 2, seen = 0.35 + 0.65 * near;
      c.strokeStyle = this.prime ? `hsl(${hue} 25% ${dark ? 62 : 45}% / ${this.prime === 5 ? 0.1 + 0.36 * near : 0.35 + 0.6 * near})`
        : `hsl(${hue} ${75 * seen}% ${dark ? 12 + 50 * seen : 91 - 46 * seen}%)`;
      c.lineWidth = (this.prime ? 0.8 : 1.6) + (depth + 1) * 0.7;
      c.beginPath();
      for (const [u, v] of piece) c.lineTo(u, v);
      c.stroke();
    }
    c.font = "12px system-ui, sans-serif";
    points.forEach((x, n) => {
      if (x[0] < FAR) return;
      const [u, v, depth] = this.seen(x), taken = n === this.chosen;
      c.fillStyle = taken ? "#d55e00" : style.getPropertyValue("--accent");
      c.beginPath();
      c.arc(u, v, (taken ? 6 : 3.5) + depth, 0, 7);
      c.fill();
      c.fillStyle = style.getPropertyValue("--ink");
      if (this.prime === 3 || taken) c.fillText(this.names[n].join(" "), u + 8, v - 6);
    });
    this.tell(p);
  }

  tell(p) {
    const angle = (Math.acos(Math.max(-1, Math.min(1, p[0]))) * 180) / Math.PI, full = Math.hypot(p[0] + 1, ...p.slice(1)) < 0.02, side = $("side").value;
    $("number").textContent = `p = ${["", "i", "j", "k"].map((unit, n) => `${p[n] < -5e-4 ? "−" : n ? "+" : ""} ${Math.abs(p[n]).toFixed(3)}${unit}`).join(" ")}`;
    $("turn").setAttribute("aria-valuetext", `${$("turn").value}°, ${$("number").textContent}`);
    if (this.chosen !== null)
      $("said").textContent = `g = (${this.names[this.chosen].join(", ")}) over GF(${this.prime}). At 360 the slider has brought every unit x to where ${{ left: "g·x", right: "x·g", both: "g·x·g⁻¹" }[side]} was: the ${this.points.length} units change places.`;
    else if (this.prime)
      $("said").textContent = `The ${this.points.length} quaternions of norm 1 over GF(${this.prime}), joined where one is the other times a unit nearest to 1. Choose one.`;
    else
      $("said").textContent = full ? (side === "both" ? "p = −1, and yet space is as it was: p and −p are the same turn." : "p = −1: every x has gone to −x, the opposite point. Only two full turns bring it back.")
        : side === "both" ? "x ↦ p·x·p⁻¹ keeps 1, and turns space by twice the angle of p." : `x ↦ ${side === "left" ? "p·x" : "x·p"} moves every point along a great circle by ${angle.toFixed(0)}°, the angle of p; p·x·p⁻¹ turns space by twice as much.`;
  }
}

const seeing = new Seeing();
