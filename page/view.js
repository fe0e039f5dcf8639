// The box that is looked at: it follows the curve, which shrinks, but not at once.

function corners(coordinates) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  coordinates.forEach((x, k) => {
    low[k % 3] = Math.min(low[k % 3], x);
    high[k % 3] = Math.max(high[k % 3], x);
  });
  return [low, high];
}

class View {
  constructor() { this.box = this.wanted = null; }

  follow(coordinates, isSudden) {
    this.wanted = corners(coordinates).flat();
    if (isSudden || this.hasGrown()) this.box = this.wanted;
    this.move();
  }

  // What a search has straightened out, or what undo brings back, would surround the viewer.
  hasGrown() {
    const size = (box) => Math.hypot(...[0, 1, 2].map((k) => box[3 + k] - box[k]));
    return size(this.wanted) > 1.5 * size(this.box);
  }

  // Nearer to the wanted box with each picture of the screen.
  move() {
    if (this.isMoving) return;
    this.box = this.box.map((x, k) => x + 0.08 * (this.wanted[k] - x));
    scene.lookAt(this.box.slice(0, 3), this.box.slice(3));
    const rest = Math.hypot(...this.box.map((x, k) => x - this.wanted[k]));
    if (rest < 1e-3 * scene.size) return;
    this.isMoving = true;
    requestAnimationFrame(() => {
      this.isMoving = false;
      this.move();
    });
  }
}
