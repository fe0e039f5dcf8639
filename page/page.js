// The page itself: it shows the pictures that the worker posts, and tells it what the user does.

const element = (id) => document.getElementById(id);
const COLORS = ["#d83a34", "#2f6fbf", "#2e9e5b", "#c9881f", "#8a4fb5", "#3aa6b0"];

const worker = new Worker(URL.createObjectURL(
  new Blob([element("worker").textContent], {type: "text/javascript"})));
const scene = new Scene(element("scene"), COLORS);
const drawing = new Drawing(element("drawing"));

let picture = null; // the last one
let number = 0;     // of the curve that was loaded last, unless it was refused
let shownNumber = 0;
let knottedness = "unknown"; // by the diagram of that curve
let thickness = 0;  // of the slider, when it was moved last

const ask = (action, values = {}) => worker.postMessage({action, ...values});

// --- The view

// The box that is looked at follows the curve, which shrinks, but not at once.
class View {
  constructor() { this.box = this.wanted = null; }

  follow(coordinates, isSudden) {
    const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
    coordinates.forEach((x, k) => {
      low[k % 3] = Math.min(low[k % 3], x);
      high[k % 3] = Math.max(high[k % 3], x);
    });
    this.wanted = [...low, ...high];
    if (isSudden) this.box = this.wanted;
    this.move();
  }

  // Nearer to the wanted box with each picture of the screen.
  move() {
    if (this.isMoving) return;
    this.box = this.box.map((x, k) => x + 0.08 * (this.wanted[k] - x));
    scene.lookAt(this.box.slice(0, 3), this.box.slice(3));
    const rest = Math.hypot(...this.box.map((x, k) => x - this.wanted[k]));
    if (rest < 1e-3 * scene.size) return;
    this.isMoving = true;
    requestAnimationFrame(() => {
      this.isMoving = false;
      this.move();
    });
  }
}

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

const view = new View(), marks = new Hand_marks();
const hand = {isHolding: false, target: null};

const nodeOf = (v) => Array.from(picture.coordinates.subarray(3 * v, 3 * v + 3));
const tubeRadius = () => 0.6 * picture.thickness * Math.pow(2, element("tube").valueAsNumber);

function showCurve() {
  const strands = Array.from(picture.strands, (n, c) => [n, 1, c]);
  scene.showCurve(strands, picture.coordinates, tubeRadius());
  marks.show(picture.held < 0 ? null : nodeOf(picture.held), hand.target, picture.isRefused, tubeRadius());
}

function showPicture(data) {
  requestAnimationFrame(() => ask("drawn"));
  const isFirst = picture === null || picture.number !== data.number;
  picture = data;
  showNumber(data.number);
  if (picture.held < 0) view.follow(picture.coordinates, isFirst || picture.isSearching);
  showCurve();
  const round = (x) => (Number.isFinite(x) ? x.toPrecision(5) : "–");
  element("length").textContent = round(picture.length);
  element("ropelength").textContent = round(picture.ropelength);
  element("nodes").textContent = picture.coordinates.length / 3;
  showProof();
  const isGoing = picture.isRunning || picture.isSearching;
  element("run").textContent = isGoing ? "\u275A\u275A Pause" : "\u25B6 Run";
  element("undo").disabled = !picture.canUndo;
  element("scene").classList.toggle("refused", picture.isRefused);
  if (picture.isRefused) say("Refused: a strand is in the way.", "refused");
  else if (element("message").className === "refused") say("");
}

function say(text, kind = "") {
  element("message").textContent = text;
  element("message").className = kind;
}

// Nothing is known yet of another curve.
function showNumber(ofCurve) {
  if (shownNumber === ofCurve) return;
  element("name").textContent = element("crossings").textContent = "…";
  knottedness = "unknown";
  shownNumber = ofCurve;
}

function showIdentity({number: ofCurve, name, isProved, knottedness: found, crossings}) {
  showNumber(ofCurve);
  knottedness = found || "unknown";
  element("name").textContent = name ? name + (isProved ? " (proved)" : " (by polynomials)") : "not found";
  element("crossings").textContent = crossings === undefined ? "–" : crossings;
  showProof();
}

// The curve's shape can be a proof, and so can its diagram.
function showProof() {
  const byShape = picture.strands.length > 1 ? "trivial link" : "unknotted";
  element("proof").textContent = picture.isProved ? byShape : knottedness.replace("unknown", "–");
}

// --- Curves, to choose and to save

function choices() {
  const {primeKnots, hardUnknot} = JSON.parse(element("knots").textContent);
  const links = {
    "Hopf link": {torus: [2, 2]}, "Solomon's knot": {torus: [2, 4]}, "Whitehead link": {braid: "1 1 -2 1 -2"},
    "Borromean rings": {braid: "1 -2 1 -2 1 -2"}, "T(3, 3)": {torus: [3, 3]},
  };
  const unknots = {
    "Hard unknot": {name: "hard_unknot.obj", content: hardUnknot},
    "Another tangle": {unknot: [100, 2000, 3]},
  };
  const torusKnots = {"T(2, 3)": {torus: [2, 3]}, "T(3, 4)": {torus: [3, 4]}, "T(3, 5)": {torus: [3, 5]}};
  const knots = Object.fromEntries(Object.entries(primeKnots).map(([name, braid]) => [name, {braid}]));
  return {Unknots: unknots, Links: links, "Torus knots": torusKnots, "Prime knots": knots};
}

const offered = choices();

function addChoices() {
  for (const [label, group] of Object.entries(offered)) {
    const options = document.createElement("optgroup");
    options.label = label;
    for (const name of Object.keys(group)) options.append(new Option(name, label + "/" + name));
    element("knot").append(options);
  }
}

function loadChoice() {
  const [label, ...name] = element("knot").value.split("/");
  load(offered[label][name.join("/")]);
}

function load(knot) {
  say("");
  element("thickness").value = thickness = 0;
  ask("load", {knot, number: ++number});
}

async function openFile(file) {
  if (!file) return;
  const extension = file.name.toLowerCase().endsWith(".polylines.txt") ? ".polylines.txt" : ".obj";
  loadFile("input" + extension, await file.text());
}

function loadFile(name, content) {
  element("knot").selectedIndex = -1;
  load({name, content});
}

// Begins a drawing or, if there is one, ends it: its curve is seen as it was drawn.
function draw() {
  const content = drawing.isOn ? drawing.obj() : "";
  if (content) {
    scene.azimuth = scene.elevation = 0;
    loadFile("drawing.obj", content);
  }
  drawing.isOn ? endDrawing() : drawing.begin();
  if (!drawing.isOn) return;
  element("draw").textContent = "Done";
  say("Draw a closed curve, or several. Click a crossing to exchange over and under.");
}

function endDrawing() {
  drawing.setOn(false);
  element("draw").textContent = "Draw";
  say("");
}

function download(file, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = file;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function savePicture() {
  scene.render(); // a canvas keeps its picture until the next event only
  scene.canvas.toBlob((blob) => download("curve.png", blob));
}

// --- The hand

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
  if (picture.held < 0) return;
  const length = 2 * picture.thickness, elements = scene.camera.matrixWorld.elements;
  pull(nodeOf(picture.held).map((x, k) => x + length * (right * elements[k] + up * elements[4 + k])));
}

// --- Controls

function toggle() {
  say("");
  ask(picture && (picture.isRunning || picture.isSearching) ? "pause" : "run");
}

function search() {
  letGo();
  say("");
  ask("search", {seed: Math.floor(Math.random() * 2 ** 31)});
}

function undo() {
  letGo();
  ask("undo");
}

function listenToKeys() {
  const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  scene.canvas.addEventListener("keydown", (event) => {
    const turn = turns[event.key];
    if (!turn || !picture) return;
    if (event.shiftKey) pullBy(...turn);
    else scene.turn(0.1 * turn[0], 0.1 * turn[1]);
    event.preventDefault();
  });
  const actions = {
    " ": toggle, ".": () => ask("step"), s: search, z: undo, n: holdNext, Escape: letGo,
    "+": () => scene.zoom(1 / 1.1), "-": () => scene.zoom(1.1),
  };
  document.addEventListener("keydown", (event) => {
    if (drawing.isOn) return event.key === "Escape" && endDrawing();
    const isTyping = ["SELECT", "BUTTON", "INPUT"].includes(event.target.tagName);
    if (isTyping || !picture || !actions[event.key] || event.ctrlKey || event.metaKey) return;
    actions[event.key]();
    event.preventDefault();
  });
}

function listenToControls() {
  element("knot").addEventListener("change", loadChoice);
  element("open").addEventListener("click", () => element("file").click());
  element("draw").addEventListener("click", draw);
  element("file").addEventListener("change", (event) => openFile(event.target.files[0]));
  element("run").addEventListener("click", toggle);
  element("step").addEventListener("click", () => ask("step"));
  element("search").addEventListener("click", search);
  element("undo").addEventListener("click", undo);
  element("tube").addEventListener("input", showCurve);
  element("thickness").addEventListener("input", (event) => {
    ask("thickness", {factor: Math.pow(2, event.target.valueAsNumber - thickness)});
    thickness = event.target.valueAsNumber;
  });
  element("save-curve").addEventListener("click", () => ask("save", {file: "curve.obj"}));
  element("save-start").addEventListener("click", () => ask("save", {file: "start.obj"}));
  element("save-certificate").addEventListener("click", () => ask("save", {file: "curve.cert"}));
  element("save-picture").addEventListener("click", savePicture);
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    openFile(event.dataTransfer.files[0]);
  });
}

const answers = {
  picture: showPicture,
  identity: showIdentity,
  note: ({text}) => say(text),
  problem: ({text}) => say(text, "refused"),
  file: ({file, content}) => download(file, new Blob([content])),
};

worker.onmessage = ({data}) => answers[data.kind](data);
worker.onerror = (event) => say("The page does not work in this browser: " + event.message, "refused");

addChoices();
listenToControls();
listenToHand();
listenToPointers(scene);
listenToKeys();
new ResizeObserver(() => scene.draw()).observe(scene.canvas);
loadChoice();
