const $ = (id) => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
for (const show of data.shows) for (const name of ["quaternions", "places"]) if (show[name]) show[name] = new Float32Array(bytes(show[name]));
for (const curve of data.curves) curve.values = Array.from(new Float32Array(bytes(curve.values)));
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

class Player {
  constructor() {
    this.frames = Math.max(...data.shows.map((show) => show.quaternions.length / 4));
    this.frame = 0;
    this.speed = 1;
    this.alone = -1; // the index of the one top shown, or −1 for all
    this.playing = false;
    this.stale = true;
    this.before = null;
    this.look();
    $("frame").max = this.frames - 1;
    for (const speed of SPEEDS) $("speed").add(new Option(`${speed}×`, speed, speed === 1, speed === 1));
    this.curves = data.curves.map((curve) => new Curve($("curves"), curve, this));
    $("curves").hidden = !this.curves.length;
    this.labels = data.shows.map((show) => {
      const label = $("labels").appendChild(document.createElement("span"));
      label.textContent = show.label;
      return label;
    });
    this.open();
    this.live = Boolean(data.simulation);
    if (this.live) this.simulator = new Simulator(this, data.simulation);
    this.mode(this.live);
    this.listen();
    if (!this.simulator?.still && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.toggle();
    requestAnimationFrame((now) => this.tick(now));
  }

  // The camera as the page was made with.
  look() {
    this.camera = { ...data.camera };
    this.stale = true;
  }

  open() {
    this.gl = $("view").getContext("webgl", { antialias: true, alpha: false });
    if (this.gl) this.scene = new Scene(this.gl, data.model, data.shows, this.paper());
    else this.say("This page draws with WebGL, which this browser does not have or has switched off. Another browser, or hardware acceleration in its settings, will show the top.");
  }

  // The live top, or the film of what was computed before.
  mode(live) {
    this.live = live;
    document.body.classList.toggle("live", live);
    $("curves").hidden = live || !this.curves.length;
    if (!this.simulator) return;
    $("controls").hidden = $("readings").hidden = !live;
    $("mode").textContent = live ? (data.shows.length > 1 ? `${data.shows.length} films` : "film") : "live";
    for (const [, label] of this.simulator.labels) label.hidden = true;
    this.scene?.shape(live ? widened(data.model.profile, this.simulator.set.width) : data.model.profile);
    this.stale = true;
  }

  say(text) {
    $("message").textContent = text;
    $("message").hidden = !text;
  }

  paper() {
    const probe = document.createElement("canvas").getContext("2d");
    probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--paper").trim();
    probe.fillRect(0, 0, 1, 1);
    return [...probe.getImageData(0, 0, 1, 1).data.slice(0, 3)].map((x) => x / 255);
  }

  toggle() {
    this.playing = !this.playing;
    this.before = null;
    $("play").textContent = this.playing ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", this.playing ? "pause" : "play");
  }

  seek(frame) {
    if (this.playing) this.toggle();
    this.frame = Math.max(0, Math.min(this.frames - 1, frame));
    this.stale = true;
  }

  setSpeed(speed) {
    this.speed = speed;
    $("speed").value = speed;
  }

  orbit(dx, dy) {
    this.camera.azimuth -= dx;
    this.camera.elevation = Math.max(-0.2, Math.min(1.55, this.camera.elevation + dy));
    this.stale = true;
  }

  zoom(factor) {
    this.camera.distance = Math.max(4, Math.min(40, this.camera.distance * factor));
    this.stale = true;
  }

  tick(now) {
    if (this.playing) {
      const seconds = Math.min(0.25, (now - (this.before ?? now)) / 1000); // a sleeping tab does not jump
      if (this.live) this.simulator.advance(seconds * this.speed);
      else this.frame = (this.frame + seconds * data.fps * this.speed) % this.frames;
      this.before = now;
    }
    if (this.playing || this.stale) this.draw();
    requestAnimationFrame((next) => this.tick(next));
  }

  draw() {
    this.stale = false;
    if (this.scene) this.paint();
    if (this.live) return this.simulator.tell();
    const whole = Math.floor(this.frame);
    $("frame").value = whole;
    if (!this.playing) $("frame").setAttribute("aria-valuetext", `${(whole / data.fps).toFixed(2)} seconds`);
    $("time").innerHTML = `${(whole / data.fps).toFixed(2)} s<span class="long"> · frame ${whole} of ${this.frames}</span>`;
    const style = getComputedStyle(document.documentElement);
    for (const curve of this.curves) curve.draw(this.frame, style.getPropertyValue("--ink"), style.getPropertyValue("--accent"));
  }

  paint() {
    const view = $("view"), ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(view.clientWidth * ratio)), height = Math.max(1, Math.round(view.clientHeight * ratio));
    if (view.width !== width || view.height !== height) [view.width, view.height] = [width, height];
    if (this.live) {
      this.labels.forEach((label) => (label.hidden = true));
      this.scene.clear(width, height);
      return this.simulator.paint([0, 0, width, height], ratio);
    }
    const shown = this.alone < 0 ? data.shows.map((_, n) => n) : [this.alone];
    const columns = this.columns(shown.length, width / height), rows = Math.ceil(shown.length / columns);
    const w = Math.floor(width / columns), h = Math.floor(height / rows);
    this.labels.forEach((label) => (label.hidden = true));
    this.scene.clear(width, height);
    shown.forEach((n, place) => {
      const column = place % columns, row = Math.floor(place / columns), show = data.shows[n];
      const frame = Math.min(this.frame, show.quaternions.length / 4 - 1);
      this.scene.draw(n, show, frame, this.camera, [column * w, height - (row + 1) * h, w, h]);
      Object.assign(this.labels[n].style, { left: `${(column * w) / ratio}px`, top: `${(row * h) / ratio}px`, maxWidth: `${w / ratio}px` });
      this.labels[n].hidden = false;
    });
  }

  // As many columns as leave the largest squares.
  columns(count, aspect) {
    const size = (n) => Math.min(aspect / n, 1 / Math.ceil(count / n));
    return Array.from({ length: count }, (_, n) => n + 1).reduce((best, n) => (size(n) > size(best) + 1e-9 ? n : best), 1);
  }

  listen() {
    const view = $("view"), touches = new Map();
    let pulling = null; // where the hand took hold of the live top
    const place = (e) => {
      const { left, top, width, height } = view.getBoundingClientRect();
      return [[(2 * (e.clientX - left)) / width - 1, 1 - (2 * (e.clientY - top)) / height], width / height];
    };
    const release = () => {
      if (pulling) this.simulator.release();
      pulling = null;
    };
    const apart = () => { const [p, q] = [...touches.values()]; return Math.hypot(p.x - q.x, p.y - q.y); };
    view.addEventListener("pointerdown", (e) => { 
      touches.set(e.pointerId, e);
      view.setPointerCapture(e.pointerId);
      release();
      if (this.live && this.scene && touches.size === 1 && this.simulator.holds(...place(e))) pulling = place(e)[0];
    });
    view.addEventListener("pointermove", (e) => {
      const last = touches.get(e.pointerId);
      if (!last) return;
      const gap = touches.size === 2 ? apart() : 0;
      touches.set(e.pointerId, e);
      if (pulling) this.simulator.pull(pulling, ...place(e));
      else if (gap) this.zoom(gap / Math.max(apart(), 1));
      else if (touches.size === 1) this.orbit((e.clientX - last.clientX) / 120, (e.clientY - last.clientY) / 120);
    });
    for (const end of ["pointerup", "pointercancel"]) view.addEventListener(end, (e) => { touches.delete(e.pointerId); release(); });
    view.addEventListener("wheel", (e) => { e.preventDefault(); this.zoom(Math.exp(e.deltaY / 800)); }, { passive: false });
    view.addEventListener("dblclick", () => this.look());
    view.addEventListener("webglcontextlost", (e) => { e.preventDefault(); this.scene = null; this.say("The graphics are unavailable for a moment."); });
    view.addEventListener("webglcontextrestored", () => { this.say(""); this.open(); this.mode(this.live); this.stale = true; });
    $("play").addEventListener("click", () => this.toggle());
    $("frame").addEventListener("input", (e) => this.seek(Number(e.target.value)));
    $("speed").addEventListener("change", (e) => this.setSpeed(Number(e.target.value)));
    $("reset").addEventListener("click", () => this.look());
    if (this.simulator) $("mode").addEventListener("click", () => this.mode(!this.live));
    $("keys").addEventListener("click", () => ($("help").hidden = !$("help").hidden));
    document.addEventListener("keydown", (e) => this.key(e));
    new ResizeObserver(() => (this.stale = true)).observe(view);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      if (this.scene) this.scene.paper = this.paper();
      this.stale = true;
    });
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
    if (event.key === " " && event.target.tagName === "BUTTON") return; // it clicks the button
    if (event.target.type === "range" && event.target.id !== "frame" && /^(Arrow|Home|End|Page)/.test(event.key)) return; // a slider's own
    if (event.key === " " && event.target.type === "checkbox") return;
    const step = event.shiftKey ? 10 : 1, speed = SPEEDS.indexOf(this.speed), whole = Math.floor(this.frame);
    const actions = {
      " ": () => this.toggle(),
      ArrowLeft: () => this.seek(whole - step),
      ArrowRight: () => this.seek(whole + step),
      ArrowUp: () => this.setSpeed(SPEEDS[Math.min(speed + 1, SPEEDS.length - 1)]),
      ArrowDown: () => this.setSpeed(SPEEDS[Math.max(speed - 1, 0)]),
      Home: () => this.seek(0),
      End: () => this.seek(this.frames - 1),
      "+": () => this.zoom(1 / 1.15),
      "=": () => this.zoom(1 / 1.15),
      "-": () => this.zoom(1.15),
      a: () => this.orbit(0.1, 0),
      d: () => this.orbit(-0.1, 0),
      w: () => this.orbit(0, 0.1),
      s: () => this.orbit(0, -0.1),
      r: () => this.look(),
      "?": () => $("keys").click(),
      Escape: () => ($("help").hidden = true),
      ...(this.live && {
        ArrowLeft: () => {},
        ArrowRight: () => { this.simulator.advance(0.02); this.stale = true; },
        Home: () => this.simulator.launch(false),
        End: () => {},
        p: () => this.simulator.push(),
        l: () => this.simulator.launch(true),
      }),
      ...(this.simulator && { m: () => this.mode(!this.live) }),
    };
    const alone = /^[0-9]$/.test(event.key) && Number(event.key) <= data.shows.length ? Number(event.key) - 1 : null;
    if (alone !== null) [this.alone, this.stale] = [alone, true];
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
  }
}

const player = new Player();
