// Fills a domain, and posts what can be seen of it. The core hears no message until it has finished.

/* global core, filling:writable, number:writable */

const MILLISECONDS_BETWEEN_PICTURES = 50, MILLISECONDS_BETWEEN_REPORTS = 100;

function openDomain(file, number) {
  const opened = core.domain(file.name, file.content);
  postMessage({kind: "domain", number, file, unit: opened.unit(), ...opened.domain()});
  return opened;
}

// A function that does nothing if it was called a short time ago.
function seldom(milliseconds, action) {
  let last = -Infinity;
  return (...values) => {
    if (Date.now() - last < milliseconds) return;
    last = Date.now();
    action(...values);
  };
}

// A core that is new, since the last filling was stopped, has no domain.
function fill({file, number, thickness, bendRadius, ratio}) {
  filling = filling || core.domain(file.name, file.content);
  const settings = {thickness, ratio};
  const show = () => postMessage({kind: "growth", number, settings, ...filling.picture()});
  const report = (stage, fraction, iterations) => postMessage({kind: "progress", stage, fraction, iterations});
  filling.fill(thickness, bendRadius, ratio, seldom(MILLISECONDS_BETWEEN_PICTURES, show),
    seldom(MILLISECONDS_BETWEEN_REPORTS, report));
  const result = filling.result();
  postMessage({kind: "filled", number, settings, ...filling.picture(), result});
}
