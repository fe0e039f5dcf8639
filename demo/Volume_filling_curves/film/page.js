// Plays the film that is in the element "film"; Film.h of the program vfc says what it holds.

const film = JSON.parse(document.getElementById("film").textContent);

function numbers(base64, ArrayType) {
  return new ArrayType(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)).buffer);
}

// --- The controls

class Player {
  constructor(scene) {
    this.scene = scene;
    this.index = 0;
    this.timer = null; // while it plays
    // a dozen seconds in all, but neither a slide show nor a flicker
    this.framesPerSecond = Math.min(Math.max(film.frames.length / 12, 4), 30);
  }

  show(index) {
    this.index = Math.min(Math.max(index, 0), film.frames.length - 1);
    const frame = film.frames[this.index];
    element("frame").value = this.index;
    element("iteration").textContent = frame.iteration;
    element("length").textContent = frame.length.toPrecision(5);
    element("nodes").textContent = frame.nodes;
    const radius = film.tube * Math.pow(2, element("tube").value);
    this.scene.showCurve(frame.strands, numbers(frame.points, Float32Array), () => radius);
  }

  play() {
    const last = film.frames.length - 1;
    if (this.index === last) this.show(0);
    this.timer = setInterval(() => {
      this.show(this.index + 1);
      if (this.index === last) this.pause();
    }, 1000 / this.framesPerSecond);
    this.showButton();
  }

  pause() {
    clearInterval(this.timer);
    this.timer = null;
    this.showButton();
  }

  toggle() { this.timer === null ? this.play() : this.pause(); }

  step(frames) {
    this.pause();
    this.show(this.index + frames);
  }

  showButton() {
    const isPlaying = this.timer !== null;
    element("play").textContent = isPlaying ? "\u275A\u275A" : "\u25B6";
    element("play").setAttribute("aria-label", isPlaying ? "Pause" : "Play");
  }
}

function listenToKeys(scene, player) {
  const factor = 1.1;
  const actions = {
    " ": () => player.toggle(), ",": () => player.step(-1), ".": () => player.step(1),
    "+": () => scene.zoom(1 / factor), "-": () => scene.zoom(factor),
  };
  document.addEventListener("keydown", (event) => {
    if (!actions[event.key] || event.ctrlKey || event.metaKey) return;
    if (event.key === " " && event.target === element("play")) return; // which is pressed then
    actions[event.key]();
    event.preventDefault();
  });
}

function start() {
  document.title = "Film of " + film.title;
  const scene = new Scene(element("scene"), film.colors), player = new Player(scene);
  scene.lookAt(film.low, film.high);
  if (film.surface) {
    scene.addDomain(numbers(film.surface.points, Float32Array),
      numbers(film.surface.triangles, Uint32Array));
  }
  element("frame").max = film.frames.length - 1;
  element("frame").addEventListener("input", (event) => player.step(event.target.valueAsNumber - player.index));
  element("play").addEventListener("click", () => player.toggle());
  element("tube").addEventListener("input", () => player.show(player.index));
  element("domain").addEventListener("input", (event) => scene.showDomain(event.target.valueAsNumber));
  element("domain-label").hidden = !film.surface;
  listenToPointers(scene);
  listenToArrows(scene);
  listenToKeys(scene, player);
  new ResizeObserver(() => scene.draw()).observe(scene.canvas);
  scene.showDomain(element("domain").valueAsNumber);
  player.show(0);
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) player.play();
}

try {
  start();
} catch (error) {
  element("problem").textContent = "The film cannot be shown: " + error.message;
  element("problem").hidden = false;
  throw error;
}
