// The page itself: it shows the pictures that the worker posts, and tells it what the user does.

const COLORS = ["#d83a34", "#2f6fbf", "#2e9e5b", "#c9881f", "#8a4fb5", "#3aa6b0"];

const NO_CORE = "The page does not work in this browser: ";

let worker = null;
const scene = openScene();
const drawing = new Drawing(element("drawing"));
const view = new View(), marks = new Hand_marks();

let number = 0; // of the curve or domain that was loaded last, unless it was refused
let thicknessRequest = 0; // the number of times that this core was asked for a thickness

const ask = (action, values = {}) => worker.postMessage({action, ...values});

function say(text, kind = "") {
  element("message").textContent = text;
  element("message").className = kind;
}

// Without WebGL there is nothing to show, but the reason.
function openScene() {
  try {
    return new Scene(element("scene"), COLORS);
  } catch (error) {
    document.querySelector("main").hidden = true;
    say("The page needs WebGL, which this browser does not have or has switched off.", "refused");
    throw error;
  }
}

// "knot", "filling" or "drawing", each of which has controls of its own
function setMode(mode) {
  document.body.dataset.mode = mode;
  const isFilled = mode === "filling";
  element("save-start").title = isFilled ? "The circles that the curve grew from" : "The curve as it was loaded";
}

// --- Input and output

function loadChoice() {
  const [label, ...name] = element("knot").value.split("/");
  load(offered[label][name.join("/")], element("knot").value);
}

function load(input, choice) {
  if (isFilling) stopFilling();
  if (drawing.isOn) endDrawing();
  say("");
  chosen[++number] = choice;
  ask("load", {input, number});
}

async function openFile(file) {
  if (!file) return;
  const known = [".polylines.txt", ".off"].find((end) => file.name.toLowerCase().endsWith(end));
  const content = await file.text().catch(() => null);
  if (content === null) return say(`${file.name} cannot be read.`, "refused"); // a folder, for instance
  loadFile("input" + (known || ".obj"), content);
}

// A file with faces is one of a surface.
function loadFile(name, content) {
  const isSurface = name.endsWith(".off") || /^f\s/m.test(content);
  load(isSurface ? {domain: {name, content}} : {name, content}, ownChoice.value);
}

// Begins a drawing or, if there is one, ends it: its curve is seen as it was drawn.
function draw() {
  if (!drawing.isOn) return beginDrawing();
  const content = drawing.obj();
  endDrawing();
  if (!content) return;
  scene.azimuth = scene.elevation = 0;
  loadFile("drawing.obj", content);
}

function beginDrawing() {
  drawing.begin();
  setMode("drawing");
  element("draw").textContent = "Done";
  say("Draw a closed curve, or several. Click a crossing to exchange over and under. Then press Done.");
}

function endDrawing() {
  drawing.setOn(false);
  element("draw").textContent = "Draw";
  setMode(domain ? "filling" : "knot");
  say("");
}

function download(file, blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = file;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

const savedFiles = {"save-curve": "curve.obj", "save-start": "start.obj", "save-certificate": "curve.cert"};

function allowSaving(isAllowed) {
  for (const button of Object.keys(savedFiles)) element(button).disabled = !isAllowed;
}

function savePicture() {
  scene.render(); // a canvas keeps its picture until the next event only
  scene.canvas.toBlob((blob) => download("curve.png", blob));
}

// --- Controls

function toggle() {
  say("");
  ask("toggle");
}

function search() {
  letGo();
  say("");
  ask("search", {seed: Math.floor(Math.random() * 2 ** 31)});
}

function step() {
  say("");
  ask("step");
}

function undo() {
  letGo();
  say("");
  ask("undo");
}

function setThickness() {
  ask("thickness", {factor: exponential("thickness"), request: ++thicknessRequest});
}

// Keys press the buttons, unless these are disabled. A key that is held down presses Space once.
const click = (name) => () => element(name).click();
const keys = {
  always: {
    " ": (event) => event.repeat || element(domain ? "fill" : "run").click(),
    "+": () => scene.zoom(1 / 1.1),
    "-": () => scene.zoom(1.1),
  },
  ofKnots: {".": click("step"), s: click("search"), z: click("undo"), n: holdNext, escape: letGo},
};

// With caps lock, too. Other combinations than Ctrl+Z are the browser's.
function actionOf({key, altKey, ctrlKey, metaKey, shiftKey}) {
  const name = key.toLowerCase(), isUndo = name === "z" && !shiftKey;
  if (altKey || ((ctrlKey || metaKey) && !isUndo)) return null;
  return keys.always[name] || (picture && keys.ofKnots[name]);
}

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (drawing.isOn) return event.key === "Escape" && endDrawing();
    const {tagName} = event.target, isTaken = tagName === "SELECT" || (tagName === "BUTTON" && event.key === " ");
    const action = actionOf(event);
    if (isTaken || !action) return;
    action(event);
    event.preventDefault();
  });
}

function listenToControls() {
  element("knot").addEventListener("change", loadChoice);
  element("open").addEventListener("click", () => element("file").click());
  element("draw").addEventListener("click", draw);
  element("file").addEventListener("change", (event) => {
    openFile(event.target.files[0]);
    event.target.value = ""; // or the same file could not be opened again
  });
  element("run").addEventListener("click", toggle);
  element("step").addEventListener("click", step);
  element("search").addEventListener("click", search);
  element("undo").addEventListener("click", undo);
  element("tube").addEventListener("input", () => (picture ? showCurve() : showGrown()));
  element("thickness").addEventListener("input", setThickness);
  for (const [button, file] of Object.entries(savedFiles))
    element(button).addEventListener("click", () => ask("save", {file}));
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
  domain: showDomain,
  progress: showProgress,
  growth: showGrowth,
  state: (data) => kept = data,
  filled: showFilled,
  note: ({text}) => say(text),
  problem: ({text}) => {
    say(text, "refused");
    if (isFilling) showResult({status: "refused"});
    setFilling(false);
  },
  failure: ({text}) => say(NO_CORE + text, "refused"),
  file: ({file, content}) => download(file, new Blob([content])),
};

// Starts a core, instead of the one there was.
function startWorker() {
  if (worker) worker.onmessage = null;
  if (worker) worker.terminate();
  worker = new Worker(URL.createObjectURL(
    new Blob([element("worker").textContent], {type: "text/javascript"})));
  worker.onmessage = ({data}) => answers[data.kind](data);
  worker.onerror = ({message}) => say(NO_CORE + message, "refused");
  thicknessRequest = 0;
}

setMode("knot");
startWorker();
addChoices();
listenToControls();
listenToFilling();
listenToHand();
listenToPointers(scene);
listenToArrows(scene, pullBy);
listenToKeys();
new ResizeObserver(() => scene.draw()).observe(scene.canvas);
loadChoice();
say("This tangle is unknotted: Search unties it. Or pull at it.");
