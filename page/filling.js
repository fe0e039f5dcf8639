// A filling: the domain that the page shows, and the curve that grows in it. A thickness, in units of
// the domain's diagonal, is that in its middle.

let domain = null; // null while a knot is shown
let grown = null;  // the last picture of the curve, or null
let kept = null;   // the last state of the run, or null
let isFilling = false;

const exponential = (name) => Math.pow(2, element(name).valueAsNumber);

// The slider of the bend radius is in units of the least thickness.
function settings() {
  const thickness = exponential("filling-thickness"), ratio = exponential("ratio");
  const least = (2 * thickness * Math.min(1, ratio)) / (1 + ratio);
  return {thickness, bendRadius: element("bend").valueAsNumber * least, ratio};
}

function showSettings() {
  const {thickness, bendRadius, ratio} = settings(), round = (x) => (x * domain.unit).toPrecision(3);
  element("filling-thickness-value").textContent = round(Math.max(thickness, bendRadius));
  element("bend-value").textContent = bendRadius > 0 ? round(bendRadius) : "none";
  element("ratio-value").textContent = ratio === 1 ? "none" : `1 : ${Number(ratio.toPrecision(2))}`;
}

// As the core has it: from end to end of the longest side of the domain's box, and nowhere less than
// the bend radius.
function thicknessAt(p) {
  const {thickness, bendRadius, ratio} = grown.settings, {low, side, axis} = domain;
  const t = Math.min(Math.max((p[axis] - low[axis]) / side, 0), 1);
  return Math.max((2 * thickness * (1 - t + t * ratio)) / (1 + ratio), bendRadius);
}

function showDomain(data) {
  const [low, high] = corners(data.points), sides = high.map((x, k) => x - low[k]);
  const side = Math.max(...sides);
  domain = {...data, low, side, axis: sides.indexOf(side)};
  picture = null;
  say("");
  setMode("filling");
  showChoice(data.number);
  scene.addDomain(data.points, data.triangles);
  scene.showDomain(element("glass").valueAsNumber);
  view.follow(data.points, true);
  marks.show(null);
  forgetGrown();
  showSettings();
}

function leaveDomain() {
  if (!domain) return;
  domain = null;
  say("");
  setMode("knot");
  scene.removeDomain();
  forgetGrown();
}

function forgetGrown() {
  grown = kept = null;
  scene.showCurve([], new Float32Array(), null);
  showResult({status: "–"});
  allowSaving(!domain);
}

// --- Growing

function toggleFilling() {
  isFilling ? stopFilling() : fill();
}

function fill() {
  setFilling(true);
  say("");
  forgetGrown();
  ask("fill", {settings: settings()});
}

// The core hears nothing while it fills: a new one goes on from the last state.
function stopFilling() {
  startWorker();
  setFilling(false);
  showResult({status: "stopped"});
  element("fill").disabled = kept !== null; // until the curve is restored
  ask("restore", {file: domain.file, ...kept});
}

function setFilling(isOn) {
  isFilling = isOn;
  element("fill").disabled = false;
  element("fill").textContent = isOn ? "\u25A0 Stop" : "\u25B6 Fill";
}

// Draws before the next picture of the screen what came last.
function showGrowth(data) {
  const isWaiting = grown !== null && grown.isWaiting;
  grown = {...data, isWaiting: true};
  element("filling-nodes").textContent = data.coordinates.length / 3;
  element("strands").textContent = data.strands.length;
  if (!isWaiting) requestAnimationFrame(showGrown);
}

function showGrown() {
  if (!grown) return;
  grown.isWaiting = false;
  const share = 0.5 * exponential("tube");
  scene.showCurve(Array.from(grown.strands, (n, c) => [n, 1, c]), grown.coordinates,
    (p) => share * thicknessAt(p));
}

function showProgress({stage, fraction, iterations}) {
  const isFlowing = stage === "flowing", percent = Math.round(100 * fraction);
  element("status").textContent = isFlowing ? `flowing, iteration ${iterations}` : `${stage}, ${percent} %`;
}

function showFilled({result, ...last}) {
  setFilling(false);
  showGrowth(last);
  showResult(result);
  allowSaving(true);
  say(outcome(result));
}

function outcome({status, reason, withinThickness}) {
  if (status === "interrupted") return "Stopped: the curve so far can be saved.";
  return reason || `Filled: ${(100 * withinThickness).toFixed(0)} % of the inside is nearer to the curve than the thickness.`;
}

function showResult({status, withinThickness, length, bendRadius, strandDistance}) {
  const round = (x) => (Number.isFinite(x) ? x.toPrecision(4) : "–");
  element("status").textContent = status;
  element("within").textContent = withinThickness === undefined ? "–" : `${(100 * withinThickness).toFixed(1)} %`;
  element("filling-length").textContent = round(length);
  element("bend-radius").textContent = round(bendRadius);
  element("strand-distance").textContent = round(strandDistance);
  if (!grown) element("filling-nodes").textContent = element("strands").textContent = "–";
}

function listenToFilling() {
  element("fill").addEventListener("click", toggleFilling);
  element("glass").addEventListener("input", () => scene.showDomain(element("glass").valueAsNumber));
  for (const name of ["filling-thickness", "bend", "ratio"])
    element(name).addEventListener("input", () => {
      showSettings();
      if (grown) say(`Press ${isFilling ? "Stop and then " : ""}Fill to use these settings.`);
    });
}
