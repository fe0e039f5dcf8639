"use strict";

// Draws curves as tubes, with three.js: for the film, and for the live page.

const THREE = (() => {
const module = {exports: {}}, exports = module.exports;
/* three.js */
;
return module.exports;
})();

const element = (id) => document.getElementById(id);

// --- Tubes

const sum = (a, b, s) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const n = Math.hypot(...a) || 1; return [a[0] / n, a[1] / n, a[2] / n]; };

// A vector orthogonal to a unit vector: what is left of another one, if that is not parallel.
function orthogonal(tangent, wanted) {
  const rest = sum(wanted, tangent, -dot(wanted, tangent));
  if (Math.hypot(...rest) > 1e-6) return unit(rest);
  return orthogonal(tangent, Math.abs(tangent[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0]);
}

// A vector that is orthogonal to the axis, a unit vector, turned around it.
function turned(vector, axis, angle) {
  return sum(vector.map((x) => Math.cos(angle) * x), cross(axis, vector), Math.sin(angle));
}

// Tangents and normals at the points of a strand; the normals turn as little as possible, and those
// of a closed strand a little more, so that the last one fits the first.
function frames(points, isClosed) {
  const n = points.length;
  const neighbor = (i) => points[isClosed ? (i + n) % n : Math.min(Math.max(i, 0), n - 1)];
  const tangents = points.map((_, i) => unit(sum(neighbor(i + 1), neighbor(i - 1), -1)));
  const normals = [orthogonal(tangents[0], [0, 0, 1])];
  for (let i = 1; i < n; ++i) normals.push(orthogonal(tangents[i], normals[i - 1]));
  let twist = 0;
  if (isClosed) {
    const last = orthogonal(tangents[0], normals[n - 1]);
    twist = Math.atan2(dot(cross(last, normals[0]), tangents[0]), dot(last, normals[0]));
  }
  return tangents.map((tangent, i) => ({tangent, normal: turned(normals[i], tangent, (twist * i) / n)}));
}

// Twice as many points, those between by the four-point scheme of Dyn, Levin and Gregory (1987); or,
// beside a corner of more than 45 degrees, in the middle. It changes the picture only: tubes around
// the 150 nodes of a tight knot have visible facets.
function rounded(points, isClosed) {
  const n = points.length;
  const edge = (i) => sum(points[(i + 1) % n], points[i], -1);
  const isGentle = (i) => (isClosed || (i > 0 && i < n - 1)) &&
    dot(unit(edge((i + n - 1) % n)), unit(edge(i % n))) > Math.SQRT1_2;
  return points.flatMap((p, i) => {
    if (!isClosed && i === n - 1) return [p];
    const middle = sum(p, edge(i), 0.5);
    if (!isGentle(i) || !isGentle((i + 1) % n)) return [p, middle];
    const outer = sum(points[(i + n - 1) % n], points[(i + 2) % n], 1);
    return [p, sum(sum(middle, middle, 1 / 8), outer, -1 / 16)];
  });
}

// The triangles of tubes, as they grow strand by strand. The radius is a function of the point.
class Tubes {
  constructor(radius, sides) {
    Object.assign(this, {radius, sides, positions: [], normals: [], triangles: []});
    const angles = Array.from({length: sides}, (_, k) => (2 * Math.PI * k) / sides);
    this.circle = angles.map((angle) => [Math.cos(angle), Math.sin(angle)]);
  }

  add(points, isClosed) {
    const rings = frames(points, isClosed).map((frame, i) => this.addRing(points[i], frame));
    for (let i = 0; i + 1 < rings.length; ++i) this.join(rings[i], rings[i + 1]);
    if (isClosed) return this.join(rings[rings.length - 1], rings[0]);
    const last = points.length - 1;
    this.addCap(points[0], points[1], rings[0], true);
    this.addCap(points[last], points[last - 1], rings[last], false);
  }

  addVertex(p, normal) {
    this.positions.push(...p);
    this.normals.push(...normal);
    return this.positions.length / 3 - 1;
  }

  addRing(p, {tangent, normal}) {
    const first = this.positions.length / 3, radius = this.radius(p), across = cross(tangent, normal);
    for (const [c, s] of this.circle) {
      const [x, y, z] = normal.map((a, k) => c * a + s * across[k]);
      this.positions.push(p[0] + radius * x, p[1] + radius * y, p[2] + radius * z);
      this.normals.push(x, y, z);
    }
    return first;
  }

  join(a, b) {
    for (let k = 0; k < this.sides; ++k) {
      const next = (k + 1) % this.sides;
      this.triangles.push(a + k, a + next, b + k, b + k, a + next, b + next);
    }
  }

  addCap(end, inner, ring, isFirst) {
    const out = unit(sum(end, inner, -1));
    const tip = this.addVertex(sum(end, out, this.radius(end) / 2), out);
    for (let k = 0; k < this.sides; ++k) {
      const edge = [ring + k, ring + (k + 1) % this.sides];
      this.triangles.push(tip, ...(isFirst ? edge.reverse() : edge));
    }
  }

  geometry() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(this.positions), 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(new Float32Array(this.normals), 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(this.triangles), 1));
    return geometry;
  }
}

// The geometries of a curve, one per color. A strand is [number of points, 1 if closed or else 0,
// component]; the coordinates are those of all strands, one after the other.
function geometries(strands, coordinates, radius, numberOfColors) {
  const few = 1000, many = 20000, numberOfPoints = coordinates.length / 3;
  const sides = numberOfPoints > many ? 6 : 12;
  const tubes = Array.from({length: numberOfColors}, () => new Tubes(radius, sides));
  let first = 0;
  for (const [n, isClosed, component] of strands) {
    const point = (i) => Array.from(coordinates.subarray(3 * (first + i), 3 * (first + i + 1)));
    let points = Array.from({length: n}, (_, i) => point(i));
    for (let k = numberOfPoints; k < few; k *= 2) points = rounded(points, isClosed === 1);
    tubes[component % tubes.length].add(points, isClosed === 1);
    first += n;
  }
  return tubes.map((tube) => tube.geometry());
}

// --- The scene

// The curve, one color per component, in a surface of glass if there is one.
class Scene {
  constructor(canvas, colors) {
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, alpha: true});
    this.renderer.setClearColor(0, 0);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    this.azimuth = 0.4;
    this.elevation = 0.3;
    this.distance = 1.95; // in units of the size
    this.center = new THREE.Vector3();
    this.size = 1;
    this.addLights();
    this.meshes = colors.map((color) => {
      const material = new THREE.MeshPhongMaterial({color, shininess: 50, specular: 0x444444});
      return this.add(new THREE.BufferGeometry(), material);
    });
    this.domain = null;
  }

  // Looks at the middle of a box, from a distance that suits its size.
  lookAt(low, high) {
    this.center = new THREE.Vector3(...low).add(new THREE.Vector3(...high)).multiplyScalar(0.5);
    this.size = new THREE.Vector3(...high).distanceTo(new THREE.Vector3(...low)) || 1;
    this.draw();
  }

  add(geometry, material) {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    return mesh;
  }

  // The light comes over the viewer's shoulder. Since release 155 lights are measured otherwise.
  addLights() {
    const strength = parseInt(THREE.REVISION, 10) < 155 ? 1 : Math.PI;
    this.scene.add(new THREE.AmbientLight(0xffffff, 0.45 * strength));
    const light = new THREE.DirectionalLight(0xffffff, 0.65 * strength);
    light.position.set(-0.45, 0.6, 0.66);
    this.camera.add(light);
    this.camera.add(light.target);
    this.scene.add(this.camera);
  }

  addDomain(points, triangles) {
    this.removeDomain();
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    geometry.computeVertexNormals();
    const glass = {color: 0x6c84a0, transparent: true, depthWrite: false, side: THREE.DoubleSide};
    this.domain = this.add(geometry, new THREE.MeshPhongMaterial(glass));
  }

  removeDomain() {
    if (!this.domain) return;
    this.scene.remove(this.domain);
    this.domain.geometry.dispose();
    this.domain.material.dispose();
    this.domain = null;
    this.draw();
  }

  showCurve(strands, coordinates, radius) {
    geometries(strands, coordinates, radius, this.meshes.length).forEach((geometry, k) => {
      this.meshes[k].geometry.dispose();
      this.meshes[k].geometry = geometry;
    });
    this.draw();
  }

  showDomain(opacity) {
    if (!this.domain) return;
    this.domain.visible = opacity > 0;
    this.domain.material.opacity = opacity;
    this.draw();
  }

  turn(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(Math.max(this.elevation + up, -1.5), 1.5);
    this.draw();
  }

  zoom(factor) {
    this.distance = Math.min(Math.max(this.distance * factor, 0.05), 20);
    this.draw();
  }

  // Draws once before the next picture of the screen, whatever changed in between.
  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.render();
    });
  }

  render() {
    const {clientWidth: width, clientHeight: height} = this.canvas;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.near = 0.01 * this.size;
    this.camera.far = 100 * this.size;
    this.camera.updateProjectionMatrix();
    const distance = this.distance * this.size, across = distance * Math.cos(this.elevation);
    this.camera.position.copy(this.center).add(new THREE.Vector3(across * Math.sin(this.azimuth),
      distance * Math.sin(this.elevation), across * Math.cos(this.azimuth)));
    this.camera.lookAt(this.center);
    this.renderer.render(this.scene, this.camera);
  }
}

// One finger or the mouse turns, two fingers or the wheel zoom.
function listenToPointers(scene) {
  const canvas = scene.canvas, pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size === 2 ? spread() : 0;
    pointers.set(event.pointerId, event);
    if (pointers.size === 2) scene.zoom(before / Math.max(spread(), 1));
    else scene.turn((event.clientX - last.clientX) / 150, (event.clientY - last.clientY) / 150);
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    scene.zoom(Math.exp(event.deltaY / 800));
  }, {passive: false});
}

// Arrow keys turn, or do something else with shift.
function listenToArrows(scene, actionWithShift) {
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  scene.canvas.addEventListener("keydown", (event) => {
    const arrow = arrows[event.key];
    if (!arrow) return;
    if (event.shiftKey && actionWithShift) actionWithShift(...arrow);
    else scene.turn(0.1 * arrow[0], 0.1 * arrow[1]);
    event.preventDefault();
  });
}
