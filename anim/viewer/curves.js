// One small plot a quantity, with a line at the time shown; a click or drag there goes to that time.
const MOST = 2000; // points of a line: more than there are columns to draw it in

// The values as pairs (frame, value); of many, the least and the greatest of each stretch.
function thinned(values) {
  const pairs = values.map((value, n) => [n, value]), size = Math.ceil(values.length / MOST);
  if (size < 2) return pairs;
  const out = [];
  for (let k = 0; k < pairs.length; k += 2 * size) {
    const part = pairs.slice(k, k + 2 * size).sort((a, b) => a[1] - b[1]);
    out.push(...[part[0], part[part.length - 1]].sort((a, b) => a[0] - b[0]));
  }
  return out;
}

class Curve {
  constructor(place, curve, player) {
    Object.assign(this, curve);
    this.canvas = place.appendChild(document.createElement("canvas"));
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", `${this.name} over time`);
    this.line = thinned(this.values);
    this.low = this.line.reduce((low, [, value]) => Math.min(low, value), Infinity);
    this.high = this.line.reduce((high, [, value]) => Math.max(high, value), -Infinity);
    if (this.high - this.low < 1e-6 * Math.max(Math.abs(this.high), 1e-12)) {
      const margin = Math.max(Math.abs(this.high), 1e-6) / 10;
      [this.low, this.high] = [this.low - margin, this.high + margin];
    }
    const seek = (event) => {
      if (!event.buttons) return;
      const box = this.canvas.getBoundingClientRect(), part = (event.clientX - box.left - 8) / (box.width - 16);
      player.seek(Math.round(part * (this.values.length - 1)));
    };
    this.canvas.addEventListener("pointerdown", seek);
    this.canvas.addEventListener("pointermove", seek);
  }

  draw(frame, ink, accent) {
    const ratio = window.devicePixelRatio || 1, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    [this.canvas.width, this.canvas.height] = [width * ratio, height * ratio];
    const c = this.canvas.getContext("2d"), last = this.values.length - 1, k = Math.min(Math.round(frame), last);
    const x = (n) => 8 + ((width - 16) * n) / Math.max(last, 1);
    const y = (value) => height - 10 - ((height - 38) * (value - this.low)) / (this.high - this.low);
    c.scale(ratio, ratio);
    c.fillStyle = ink;
    c.font = "12px system-ui, sans-serif";
    c.fillText(`${this.name}  ${Number(this.values[k]).toPrecision(4)} ${this.unit}`, 8, 17);
    c.strokeStyle = accent;
    c.lineWidth = 1.5;
    c.beginPath();
    for (const [n, value] of this.line) c.lineTo(x(n), y(value));
    c.stroke();
    c.strokeStyle = ink;
    c.lineWidth = 1;
    c.beginPath();
    c.moveTo(x(k), 24);
    c.lineTo(x(k), height - 4);
    c.stroke();
    c.beginPath();
    c.arc(x(k), y(this.values[k]), 3, 0, 7);
    c.fill();
  }
}
