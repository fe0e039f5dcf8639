// The hand, which pulls a knot at a node, with the pointer or with keys.

// What the hand holds and where it pulls to: a ball at the node, and a line to the pointer.
class Hand_marks {
  constructor() {
    const color = {color: 0xffffff};
    this.ball = scene.add(new THREE.SphereGeometry(1, 24, 12), new THREE.MeshBasicMaterial(color));
    this.line = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial(color));
    this.line.frustumCulled = false;
    scene.scene.add(this.line);
    this.show(null);
  }

  show(node, target, isRefused, radius) {
    this.ball.visible = this.line.visible = node !== null;
    if (!node) return;
    this.ball.position.set(...node);
    this.ball.scale.setScalar(1.4 * radius);
    this.line.geometry.setFromPoints([node, target || node].map((p) => new THREE.Vector3(...p)));
    for (const mark of [this.ball, this.line]) mark.material.color.set(isRefused ? 0xff0000 : 0x808890);
  }
}

const hand = {isHolding: false, target: null};

// The point below the pointer that is as far from the viewer as a node.
function below(event, node) {
  const box = scene.canvas.getBoundingClientRect();
  const depth = new THREE.Vector3(...node).project(scene.camera).z;
  return new THREE.Vector3(2 * (event.clientX - box.left) / box.width - 1,
    1 - 2 * (event.clientY - box.top) / box.height, depth).unproject(scene.camera).toArray();
}

// The node below the pointer that is nearest to the viewer, or null.
function nodeBelow(event) {
  if (!picture) return null;
  const box = scene.canvas.getBoundingClientRect();
  const reach = event.pointerType === "touch" ? 24 : 12; // pixels
  let best = null, nearest = Infinity;
  for (let v = 0; v < picture.coordinates.length / 3; ++v) {
    const p = new THREE.Vector3(...nodeOf(v)).project(scene.camera);
    const x = box.left + (p.x + 1) / 2 * box.width, y = box.top + (1 - p.y) / 2 * box.height;
    if (Math.hypot(x - event.clientX, y - event.clientY) > reach || p.z >= nearest) continue;
    nearest = p.z;
    best = nodeOf(v);
  }
  return best;
}

function hold(node) {
  hand.isHolding = true;
  hand.node = hand.target = node;
  ask("hold", {point: node});
}

function pull(target) {
  hand.target = target;
  ask("pull", {point: target});
}

function letGo() {
  if (!hand.isHolding) return;
  hand.isHolding = false;
  hand.target = null;
  ask("release");
}

// Before the listeners of the scene, which turn it.
function listenToHand() {
  const canvas = scene.canvas;
  let pointer = null;
  canvas.addEventListener("pointerdown", (event) => {
    const node = pointer === null ? nodeBelow(event) : null;
    if (!node || picture.isSearching) return;
    canvas.setPointerCapture(event.pointerId);
    pointer = event.pointerId;
    letGo();
    hold(node);
    event.stopImmediatePropagation();
  });
  canvas.addEventListener("pointermove", (event) => {
    if (event.pointerId === pointer) pull(below(event, hand.node));
    else canvas.style.cursor = nodeBelow(event) ? "pointer" : "";
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => {
      if (event.pointerId !== pointer) return;
      pointer = null;
      letGo();
    });
}

// With keys: the next node, and a pull in the plane of the screen.
function holdNext() {
  const step = 10, n = picture.coordinates.length / 3, last = picture.held;
  letGo();
  hold(nodeOf((Math.max(last, 0) + step) % n));
}

function pullBy(right, up) {
  if (!picture || picture.held < 0) return;
  const length = 2 * picture.thickness, elements = scene.camera.matrixWorld.elements;
  pull(nodeOf(picture.held).map((x, k) => x + length * (right * elements[k] + up * elements[4 + k])));
}
