// The knots and domains to choose from.

// A tube around a trefoil, in which a curve has a long way to go; without caps, as an OFF file.
function knottedTube() {
  const n = 120, radius = 0.5, sides = 16, tube = new Tubes(() => radius, sides);
  const trefoil = Array.from({length: n}, (_, i) => {
    const t = (2 * Math.PI * i) / n;
    return [Math.sin(t) + 2 * Math.sin(2 * t), Math.cos(t) - 2 * Math.cos(2 * t), 1.3 * Math.sin(3 * t)];
  });
  tube.add(trefoil, true);
  return offFile(tube.positions, tube.triangles);
}

// A plate with a hole in the middle: two squares, one in the other, twice.
function frame() {
  const square = (half, z) => [-half, -half, z, half, -half, z, half, half, z, -half, half, z];
  const positions = [square(1, -0.3), square(0.4, -0.3), square(1, 0.3), square(0.4, 0.3)].flat();
  const quads = [];
  for (let a = 0; a < 4; ++a) {
    const b = (a + 1) % 4;
    quads.push([a, b, 8 + b, 8 + a], [4 + b, 4 + a, 12 + a, 12 + b], [b, a, 4 + a, 4 + b], [8 + a, 8 + b, 12 + b, 12 + a]);
  }
  return offFile(positions, quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]));
}

function offFile(positions, triangles) {
  const rows = (numbers, head) => numbers.reduce((text, x, k) => text + (k % 3 ? " " : "\n" + head) + x, "");
  return `OFF\n${positions.length / 3} ${triangles.length / 3} 0${rows(positions, "")}${rows(triangles, "3 ")}\n`;
}

function choices() {
  const {primeKnots, hardUnknot, torus} = JSON.parse(element("knots").textContent);
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
  const file = (content) => ({domain: {name: "domain.off", content}});
  const domains = {
    "Torus": file(torus), "Frame": file(frame()), "Knotted tube": file(knottedTube()),
  };
  return {Unknots: unknots, Links: links, "Torus knots": torusKnots, "Domains to fill": domains, "Prime knots": knots};
}

const ownChoice = new Option("Your curve", ""); // what was opened or drawn
ownChoice.hidden = true;

let offered = {};
const chosen = []; // the value of the list for each number that was loaded

function addChoices() {
  offered = choices();
  for (const [label, group] of Object.entries(offered)) {
    const options = document.createElement("optgroup");
    options.label = label;
    for (const name of Object.keys(group)) options.append(new Option(name, label + "/" + name));
    element("knot").append(options);
  }
  element("knot").append(ownChoice); // the first one is selected
}

// The list names what is shown, and nothing that was refused.
function showChoice(ofLoaded) { element("knot").value = chosen[ofLoaded]; }
