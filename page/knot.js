// The knot that the page shows, and what is known of it.

let picture = null; // the last one of a knot; null while a filling is shown
let shownNumber = 0;
let knottedness = "unknown"; // by the diagram of that knot

const nodeOf = (v) => Array.from(picture.coordinates.subarray(3 * v, 3 * v + 3));
const tubeRadius = () => 0.6 * picture.thickness * Math.pow(2, element("tube").valueAsNumber);

function showCurve() {
  const strands = Array.from(picture.strands, (n, c) => [n, 1, c]);
  scene.showCurve(strands, picture.coordinates, tubeRadius);
  marks.show(picture.held < 0 ? null : nodeOf(picture.held), hand.target, picture.isRefused, tubeRadius());
}

function showPicture(data) {
  requestAnimationFrame(() => ask("drawn"));
  leaveDomain();
  const isFirst = picture === null || picture.number !== data.number;
  const wasRefused = picture !== null && picture.isRefused;
  picture = data;
  showNumber(data.number);
  if (picture.held < 0) view.follow(picture.coordinates, isFirst || picture.isSearching);
  showCurve();
  const round = (x) => (Number.isFinite(x) ? Number(x.toPrecision(5)) : "–"); // without an exponent
  element("length").textContent = round(picture.length);
  element("ropelength").textContent = round(picture.ropelength);
  element("nodes").textContent = picture.coordinates.length / 3;
  showThickness();
  showProof();
  showButtons();
  element("scene").classList.toggle("refused", picture.isRefused);
  if (picture.isRefused) say("Refused: a strand is in the way.", "refused");
  else if (wasRefused) say(""); // but what is wrong with a file stays
}

// The slider is relative to the thickness that the core measured. It stays where the user has it until
// the core has heard of that.
function showThickness() {
  const slider = element("thickness"), {thickness, thicknessFactor, unit, isSearching} = picture;
  slider.disabled = isSearching;
  if (picture.thicknessRequest === thicknessRequest) slider.value = Math.log2(thicknessFactor);
  element("thickness-value").textContent = Number((thickness * unit).toPrecision(3));
}

function showButtons() {
  const {isRunning, isSearching, canUndo} = picture;
  element("run").textContent = isSearching ? "\u25A0 Stop" : isRunning ? "\u275A\u275A Pause" : "\u25B6 Run";
  element("step").disabled = element("search").disabled = isSearching;
  element("undo").disabled = !canUndo;
}

// Nothing is known yet of another curve.
function showNumber(ofCurve) {
  if (shownNumber === ofCurve) return;
  element("name").textContent = element("crossings").textContent = "…";
  knottedness = "unknown";
  shownNumber = ofCurve;
  showChoice(ofCurve);
}

function showIdentity({number: ofCurve, name, isProved, knottedness: found, crossings}) {
  showNumber(ofCurve);
  knottedness = found || "unknown";
  element("name").textContent = name ? name + (isProved ? " (proved)" : " (by polynomials)") : "no name known";
  element("crossings").textContent = crossings === undefined ? "–" : crossings;
  if (picture) showProof(); // it may come before the first picture
}

// The curve's shape can be a proof, and so can its diagram.
function showProof() {
  const byShape = picture.strands.length > 1 ? "trivial link" : "unknotted";
  element("proof").textContent = picture.isProved ? byShape : knottedness.replace("unknown", "–");
}
