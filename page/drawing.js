// A knot or link that is drawn with the pointer: each stroke is a closed curve. Crossings alternate
// along a stroke at first; a click on one exchanges over and under.

const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

// Where the segments ab and cd cross inside, as their parameters there, or null.
function crossing(a, b, c, d) {
  const u = [b[0] - a[0], b[1] - a[1]], v = [d[0] - c[0], d[1] - c[1]], w = [c[0] - a[0], c[1] - a[1]];
  const area = u[0] * v[1] - u[1] * v[0];
  const s = (w[0] * v[1] - w[1] * v[0]) / area, t = (w[0] * u[1] - w[1] * u[0]) / area;
  return s > 0 && s < 1 && t > 0 && t < 1 ? [s, t] : null;
}

class Drawing {
  // The picture is an SVG element, which covers the scene.
  constructor(svg) {
    this.svg = svg;
    this.isOn = false;
    this.listen();
    this.clear();
  }

  clear() {
    this.strokes = [];
    this.stroke = null; // under the pointer
    this.crossings = [];
    this.show();
  }

  begin() {
    this.clear();
    this.setOn(true);
  }

  setOn(isOn) {
    this.isOn = isOn;
    this.svg.toggleAttribute("hidden", !isOn);
  }

  listen() {
    const at = (event) => {
      const box = this.svg.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    this.svg.addEventListener("pointerdown", (event) => {
      const reach = event.pointerType === "touch" ? 24 : 14; // pixels
      const p = at(event), hit = this.crossings.find(({point}) => distance(point, p) < reach);
      if (hit) hit.isFirstOver = !hit.isFirstOver;
      else if (!this.stroke) this.stroke = [p];
      this.svg.setPointerCapture(event.pointerId);
      this.show();
    });
    this.svg.addEventListener("pointermove", (event) => {
      const step = 8; // pixels
      if (!this.stroke || distance(this.stroke[this.stroke.length - 1], at(event)) < step) return;
      this.stroke.push(at(event));
      this.show();
    });
    for (const end of ["pointerup", "pointercancel"])
      this.svg.addEventListener(end, () => this.close());
  }

  close() {
    const least = 8; // points, fewer are a slip
    if (this.stroke && this.stroke.length >= least) this.strokes.push(this.stroke);
    this.stroke = null;
    this.findCrossings();
    this.show();
  }

  // All edges: stroke, index, ends.
  edges() {
    return this.strokes.flatMap((points, stroke) => points.map((a, i) =>
      ({stroke, i, a, b: points[(i + 1) % points.length]})));
  }

  findCrossings() {
    const former = this.crossings, edges = this.edges();
    this.crossings = [];
    for (let m = 0; m < edges.length; ++m)
      for (let n = m + 1; n < edges.length; ++n) {
        const e = edges[m], f = edges[n], found = crossing(e.a, e.b, f.a, f.b);
        if (!found) continue;
        const point = e.a.map((x, k) => x + found[0] * (e.b[k] - x));
        this.crossings.push({point, first: {...e, s: found[0]}, second: {...f, s: found[1]}});
      }
    this.alternate();
    for (const c of this.crossings) {
      const same = former.find(({point}) => distance(point, c.point) < 1e-6);
      if (same) c.isFirstOver = same.isFirstOver;
    }
  }

  // The passages of a stroke through crossings, in order.
  passages(stroke) {
    const all = this.crossings.flatMap((c) => [{c, at: c.first, isFirst: true}, {c, at: c.second, isFirst: false}]);
    return all.filter(({at}) => at.stroke === stroke).sort((p, q) => p.at.i + p.at.s - q.at.i - q.at.s);
  }

  alternate() {
    this.strokes.forEach((_, stroke) => this.passages(stroke).forEach(({c, isFirst}, k) => {
      if (c.isFirstOver === undefined) c.isFirstOver = isFirst === (k % 2 === 0);
    }));
  }

  show() {
    const color = (stroke) => COLORS[stroke % COLORS.length];
    const line = (points, stroke, end) =>
      `<path d="M${points.map((p) => p.map((x) => x.toFixed(1)).join()).join("L")}${end}" stroke="${color(stroke)}"/>`;
    const bridge = ({point, first, second, isFirstOver}) => {
      const {a, b, stroke} = isFirstOver ? first : second, n = distance(a, b), radius = 11;
      const ends = [-1, 1].map((sign) => point.map((x, k) => x + sign * radius * (b[k] - a[k]) / n));
      return `<circle cx="${point[0]}" cy="${point[1]}" r="${radius}"/>` + line(ends, stroke, "");
    };
    this.svg.innerHTML = this.strokes.map((points, stroke) => line(points, stroke, "Z")).join("") +
      (this.stroke ? line(this.stroke, this.strokes.length, "") : "") +
      this.crossings.map(bridge).join("");
  }

  // The curve in space, as an OBJ file: the strokes in a plane, and a node above and one below it at
  // each crossing. Empty if there is no stroke.
  obj() {
    const height = 12; // pixels
    let vertices = "", lines = "", count = 0;
    this.strokes.forEach((points, stroke) => {
      const nodes = points.map(([x, y], i) => ({at: i, x, y, z: 0}));
      for (const {c, at, isFirst} of this.passages(stroke))
        nodes.push({at: at.i + at.s, x: c.point[0], y: c.point[1], z: c.isFirstOver === isFirst ? height : -height});
      nodes.sort((p, q) => p.at - q.at);
      for (const {x, y, z} of nodes) vertices += `v ${x} ${-y} ${z}\n`;
      lines += `l ${nodes.map((_, k) => count + k + 1).join(" ")} ${count + 1}\n`;
      count += nodes.length;
    });
    return vertices + lines;
  }
}
