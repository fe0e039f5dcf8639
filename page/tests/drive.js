"use strict";

// Drives the core of the live page in node, for its tests:
//   node drive.js CORE steps IN.obj N OUT.obj
//   node drive.js CORE fill IN.off SHARE RATIO FOLDER  fills a domain; the thickness is this share
//                                                      of its diagonal
//   node drive.js CORE pull FOLDER    pulls a ring of the Hopf link at the other one
//   node drive.js CORE play FOLDER    flows, pulls, searches and undoes, in turn
// The last three write start.obj, curve.obj and curve.cert to the folder, and what they saw as JSON.

const fs = require("fs");
const path = require("path");

function save(curve, folder) {
  for (const name of ["start.obj", "curve.obj", "curve.cert"])
    fs.writeFileSync(path.join(folder, name), curve.file(name));
}

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

  fill(core, input, share, ratio, folder) {
    const filling = core.domain("input.off", fs.readFileSync(input, "utf8"));
    const asked = filling.unit() * Number(share), stages = new Set(), nodes = [];
    filling.fill({thickness: Number(share), bendRadius: 0, ratio: Number(ratio)}, {
      show: () => nodes.push(filling.picture().coordinates.length / 3),
      report: (stage) => stages.add(stage),
      isStateDue: () => false,
    });
    save(filling, folder);
    return {asked, stages: [...stages], nodes, ...filling.result()};
  },

  // Through the other ring, and far out on its other side.
  pull(core, folder) {
    const curve = core.torusKnot(2, 2, 100), seen = {before: curve.linkingNumber(0, 1)};
    const picture = curve.picture(), near = Array.from(picture.coordinates.slice(0, 3));
    const far = near.map((x, k) => x + 4 * (middle(picture, 1)[k] - x));
    const shares = [];
    curve.hold(...near);
    for (let k = 0; k < 200; ++k) shares.push(curve.pull(...far));
    const end = curve.picture().coordinates.slice(3 * curve.heldNode(), 3 * curve.heldNode() + 3);
    curve.release();
    save(curve, folder);
    return {...seen, after: curve.linkingNumber(0, 1), refused: shares.filter((x) => x === 0).length,
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
    curve.changeThickness(0.8);
    steps(20);
    save(curve, folder);
    return {lengths, before: core.closedBraid("1 1 1 2 -1 2", 150).identity(60), after: curve.identity(60)};
  },
};

async function main([core, command, ...parameters]) {
  process.stdout.write(JSON.stringify(commands[command](await require(core)(), ...parameters)));
}

main(process.argv.slice(2));
