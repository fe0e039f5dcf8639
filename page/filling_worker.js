// Fills a domain, and posts what can be seen of it. The core hears no message until it has finished.

/* global core, filling:writable */

const MILLISECONDS_BETWEEN_PICTURES = 50, MILLISECONDS_BETWEEN_REPORTS = 100;
const MILLISECONDS_BETWEEN_STATES = 1000;

function openDomain(file, number) {
  const opened = core.domain(file.name, file.content);
  postMessage({kind: "domain", number, file, unit: opened.unit(), ...opened.domain()});
  return opened;
}

// A function that returns whether it last returned true at least so long ago.
function every(milliseconds) {
  let last = -Infinity;
  return () => {
    const isDue = Date.now() - last >= milliseconds;
    if (isDue) last = Date.now();
    return isDue;
  };
}

function fill({settings}) {
  const isPictureDue = every(MILLISECONDS_BETWEEN_PICTURES), isReportDue = every(MILLISECONDS_BETWEEN_REPORTS);
  filling.fill(settings, {
    show() { if (isPictureDue()) postMessage({kind: "growth", settings, ...filling.picture()}); },
    report(stage, fraction, iterations) {
      if (isReportDue()) postMessage({kind: "progress", stage, fraction, iterations});
    },
    isStateDue: every(MILLISECONDS_BETWEEN_STATES),
    keep(state) { postMessage({kind: "state", settings, state}, [state.buffer]); },
  });
  postFilled(settings);
}

// Has a filling that was stopped as it was in its last state, if there is one. The core is new.
function restore({file, settings, state}) {
  filling = core.domain(file.name, file.content);
  if (!state) return;
  filling.restore(settings, state);
  postFilled(settings);
}

function postFilled(settings) {
  postMessage({kind: "filled", settings, ...filling.picture(), result: filling.result()});
}
