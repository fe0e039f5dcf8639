"use strict";

// The worker of the live page: it holds a knot, and flows, searches and pulls it by the core in
// WebAssembly, while the page stays free to draw. It posts a picture when the page has drawn the
// last one. Or it holds a domain, and fills it, see filling_worker.js.

/* global CORE, createCore, fill, openDomain, restore */

const SECONDS_OF_SEARCH = 0.05, SECONDS_TO_NAME = 1;
const MILLISECONDS_BETWEEN_ROPELENGTHS = 500;

let core = null, curve = null, filling = null; // either a curve or a filling
let loading = null;      // the promise of the core, of which there is one
let number = 0;          // of the curve among those that were loaded
let isRunning = false, isWaiting = false, hasChanged = false, isDrawn = true;
let target = null;       // of the held node, until it is reached or refused
let isRefused = false;   // the last pull
let hasPulled = false;   // the held node
let isNamed = false;     // what no motion changes
let thicknessRequest = 0; // the last one that was heard
let ropelength = {value: 0, time: 0};

const isBusy = () => curve && (isRunning || curve.isSearching() || target !== null);

// --- What the page asks for

const actions = {
  load({input, number: ofInput}) {
    const loaded = input.domain ? openDomain(input.domain, ofInput) : make(input);
    for (const former of [curve, filling]) if (former) former.delete();
    [curve, filling] = input.domain ? [null, loaded] : [loaded, null];
    number = ofInput;
    isRunning = isNamed = isRefused = false;
    target = null;
  },
  fill,
  restore,
  save({file}) { postMessage({kind: "file", file, content: (curve || filling).file(file)}); },
  drawn() { isDrawn = true; },
};

const actionsOnCurves = {
  toggle() {
    if (curve.isSearching()) return stopSearch();
    if (!isRunning) curve.remember();
    isRunning = !isRunning;
  },
  step() {
    if (curve.isSearching()) return; // a search replays its changes on the curve that it began with
    curve.remember();
    isRunning = false;
    curve.step();
  },
  search({seed}) {
    if (curve.isSearching()) return;
    curve.remember();
    isRunning = false;
    curve.release();
    curve.beginSearch(seed);
  },
  hold({point}) {
    if (curve.isSearching()) return;
    hasPulled = false;
    curve.hold(...point);
  },
  pull({point}) {
    if (curve.heldNode() < 0) return;
    if (!hasPulled) curve.remember(); // a touch alone is nothing to undo
    hasPulled = true;
    target = point;
  },
  release() {
    target = null;
    isRefused = false;
    curve.release();
  },
  thickness({factor, request}) {
    thicknessRequest = request;
    if (!curve.isSearching()) curve.setThicknessFactor(factor);
  },
  undo() {
    isRunning = false;
    target = null;
    curve.undo();
  },
};

function make({name, content, braid, torus, unknot}) {
  if (braid) return core.closedBraid(braid, 100 + 15 * braid.split(" ").length);
  if (torus) return core.torusKnot(...torus, 150);
  if (unknot) return core.hardUnknot(...unknot);
  return core.file(name, content);
}

// --- Work

function work() {
  if (curve.isSearching()) {
    if (curve.search(SECONDS_OF_SEARCH)) return;
    isNamed = false; // fewer edges may give a name
    note("Search finished. The simpler curve is certified to be the same knot.");
    return;
  }
  if (target !== null) pull();
  if (!isRunning || curve.step()) return;
  isRunning = false;
  note("The curve is tight.");
}

function stopSearch() {
  curve.endSearch();
  isNamed = false;
  note("Search stopped. The curve so far is certified to be the same knot.");
}

function pull() {
  const share = curve.pull(...target);
  isRefused = share < 1;
  if (share === 0 || distanceToTarget() < 1e-4) target = null;
}

function distanceToTarget() {
  const node = 3 * curve.heldNode(), {coordinates} = curve.picture();
  return Math.hypot(...target.map((x, k) => x - coordinates[node + k]));
}

function note(text) { postMessage({kind: "note", text}); }

// Shows the curve, and names it when there is time.
function show() {
  hasChanged = true;
  if (!isDrawn) return;
  hasChanged = isDrawn = false;
  const picture = curve.picture();
  postMessage({
    kind: "picture", number, ...picture, thicknessRequest, isRunning, isRefused, isSearching: curve.isSearching(),
    held: curve.heldNode(), canUndo: curve.canUndo(), length: curve.length(),
    ropelength: currentRopelength(), isProved: curve.isProvedTrivial(),
  }, [picture.coordinates.buffer]);
}

function currentRopelength() {
  if (curve.isSearching()) return NaN; // that of what is shown is not worth its time
  if (!isBusy() || Date.now() - ropelength.time > MILLISECONDS_BETWEEN_ROPELENGTHS)
    ropelength = {value: curve.ropelength(), time: Date.now()};
  return ropelength.value;
}

function name() {
  isNamed = true;
  postMessage({kind: "identity", number, ...curve.identity(SECONDS_TO_NAME)});
}

// --- The loop, which lets messages in between

function attempt(task) {
  try {
    task();
  } catch (error) {
    isRunning = false;
    target = null;
    postMessage({kind: "problem", text: typeof error === "number" ? core.sentence(error) : error.message});
  }
}

function wait() {
  if (isWaiting || !curve) return;
  if (!isBusy() && isNamed && !(hasChanged && isDrawn)) return;
  isWaiting = true;
  setTimeout(() => {
    isWaiting = false;
    attempt(() => {
      if (isBusy()) work();
      else if (!isNamed) name();
      show();
    });
    wait();
  });
}

async function loadCore() {
  const compressed = await (await fetch("data:application/gzip;base64," + CORE)).blob();
  const core = new Response(compressed.stream().pipeThrough(new DecompressionStream("gzip")));
  return createCore({wasmBinary: await core.arrayBuffer()});
}

self.onmessage = async ({data}) => {
  loading = loading || loadCore();
  try {
    core = await loading;
  } catch (error) {
    postMessage({kind: "failure", text: error.message});
    return;
  }
  attempt(() => {
    const action = actions[data.action] || (curve && actionsOnCurves[data.action]);
    if (action) action(data);
    if (curve && (data.action !== "drawn" || hasChanged)) show();
  });
  wait();
};
