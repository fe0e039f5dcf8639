"use strict";

// Drives the core of the live page in node, for its tests:
//   node drive.js CORE steps IN.obj N OUT.obj
//   node drive.js CORE search IN.obj SEED OUT.obj
//   node drive.js CORE rate P Q NODES N                makes N steps of a torus knot
//   node drive.js CORE fill IN.off SHARE BEND RATIO FOLDER  fills a domain; the thickness is this
//                                     share of its diagonal, and BEND bends in units of it
//   node drive.js CORE pull FOLDER    pulls a ring of the Hopf link at the other one
//   node drive.js CORE play FOLDER    flows, pulls, searches and undoes, in turn
//   node drive.js CORE stop FOLDER    stops a search, and undoes and repeats it
// The last four write start.obj, curve.obj and curve.cert to the folder, and what they saw as JSON.

const fs = require("fs");
const path = require("path");

function save(curve, folder) {
  for (const name of ["start.obj", "curve.obj", "curve.cert"])
    fs.writeFileSync(path.join(folder, name), curve.file(name));
}

const numberOfNodes = (curve) => curve.picture().coordinates.length / 3;

// The mean of every node of a component.
function middle({coordinates, strands}, component) {
  const first = strands.slice(0, component).reduce((a, n) => a + n, 0), sum = [0, 0, 0];
  for (let v = first; v < first + strands[component]; ++v)
    for (let k = 0; k < 3; ++k) sum[k] += coordinates[3 * v + k] / strands[component];
  return sum;
}

const commands = {
  steps(core, input, n, output) {
    const curve = core.file("input.obj", fs.readFileSync(input, "utf8"));
    for (let k = 0; k < Number(n); ++k) curve.step();
    fs.writeFileSync(output, curve.file("curve.obj"));
    return {};
  },

  search(core, input, seed, output) {
    const curve = core.file("input.obj", fs.readFileSync(input, "utf8"));
    curve.beginSearch(Number(seed));
    while (curve.search(1));
    fs.writeFileSync(output, curve.file("curve.obj"));
    return {};
  },

  // By the processor's time, for other programs may be running.
  rate(core, p, q, nodes, n) {
    const curve = core.torusKnot(Number(p), Number(q), Number(nodes)), start = process.cpuUsage();
    for (let k = 0; k < Number(n); ++k) curve.step();
    const {user, system} = process.cpuUsage(start);
    return {nodes: numberOfNodes(curve), stepsPerSecond: (1e6 * Number(n)) / (user + system)};
  },

  fill(core, input, share, bend, ratio, folder) {
    const filling = core.domain("input.off", fs.readFileSync(input, "utf8"));
    const thickness = Number(share), bendRadius = thickness * Number(bend), stages = new Set(), nodes = [];
    filling.fill({thickness, bendRadius, ratio: Number(ratio)}, {
      show: () => nodes.push(filling.picture().coordinates.length / 3),
      report: (stage) => stages.add(stage),
      isStateDue: () => false,
    });
    save(filling, folder);
    const asked = [thickness, bendRadius].map((length) => filling.unit() * length);
    return {asked, stages: [...stages], nodes, ...filling.result()};
  },

  // Through the other ring, and far out on its other side.
  pull(core, folder) {
    const curve = core.torusKnot(2, 2, 100);
    const picture = curve.picture(), near = Array.from(picture.coordinates.slice(0, 3));
    const far = near.map((x, k) => x + 4 * (middle(picture, 1)[k] - x));
    const shares = [];
    curve.hold(...near);
    for (let k = 0; k < 200; ++k) shares.push(curve.pull(...far));
    const end = curve.picture().coordinates.slice(3 * curve.heldNode(), 3 * curve.heldNode() + 3);
    curve.release();
    save(curve, folder);
    return {refused: shares.filter((x) => x === 0).length,
      gone: Math.hypot(...near.map((x, k) => x - end[k])), asked: Math.hypot(...near.map((x, k) => x - far[k]))};
  },

  play(core, folder) {
    const curve = core.closedBraid("1 1 1 2 -1 2", 150), lengths = [curve.length()];
    const steps = (n) => { for (let k = 0; k < n; ++k) curve.step(); };
    curve.remember();
    steps(5);
    lengths.push(curve.length());
    curve.undo();
    lengths.push(curve.length());
    steps(5);
    lengths.push(curve.length());
    curve.hold(...curve.picture().coordinates.slice(0, 3));
    for (let k = 0; k < 10; ++k) curve.pull(0.5, 0.5, 0.5);
    curve.release();
    curve.beginSearch(1);
    while (curve.search(1));
    curve.setThicknessFactor(0.8);
    steps(20);
    save(curve, folder);
    return {lengths, before: core.closedBraid("1 1 1 2 -1 2", 150).identity(60), after: curve.identity(60)};
  },

  stop(core, folder) {
    const curve = core.hardUnknot(100, 2000, 3), nodes = () => numberOfNodes(curve);
    const seen = {before: nodes()};
    curve.remember();
    curve.beginSearch(1);
    curve.search(0);
    seen.found = nodes();
    curve.endSearch();
    seen.adopted = nodes();
    curve.undo();
    seen.undone = nodes();
    curve.beginSearch(1);
    curve.search(0);
    curve.endSearch();
    save(curve, folder);
    return seen;
  },
};

async function main([core, command, ...parameters]) {
  process.stdout.write(JSON.stringify(commands[command](await require(core)(), ...parameters)));
}

main(process.argv.slice(2));
