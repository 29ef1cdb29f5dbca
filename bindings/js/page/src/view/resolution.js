const SLOW = 34; // milliseconds from one frame to the next
const FAST = 20;
const LOWEST = 0.5; // of the resolution
const SOON = 100; // milliseconds
const REST = 250; // milliseconds without a frame, after which one is drawn in full resolution

/** Lowers the resolution while something moves, if frames take too long. */
export class Resolution {
  /**
   * @param {import('three').WebGLRenderer} renderer
   * @param {() => void} draw
   */
  constructor(renderer, draw) {
    this.renderer = renderer;
    this.draw = draw;
    this.full = Math.min(devicePixelRatio, 2);
    this.factor = 1; // while something moves
    this.last = 0;
    this.isAtRest = false;
    this.renderer.setPixelRatio(this.full);
  }

  /**
   * Chooses the resolution of the next frame.
   * @param {number} asked when it was asked for: frames follow each other, if soon after the last one
   * @param {number} now
   */
  choose(asked, now) {
    clearTimeout(this.timer);
    const passed = now - this.last;
    const isNext = asked - this.last < SOON && !this.isAtRest;
    this.last = now;
    if (isNext) {
      if (passed > SLOW) this.factor = Math.max(LOWEST, 0.9 * this.factor);
      else if (passed < FAST) this.factor = Math.min(1, 1.02 * this.factor);
    }
    const ratio = this.full * (this.isAtRest ? 1 : this.factor);
    if (Math.abs(ratio - this.renderer.getPixelRatio()) > 0.04 * ratio) this.renderer.setPixelRatio(ratio);
    if (!this.isAtRest && this.factor < 1) this.timer = setTimeout(() => this.rest(), REST);
    this.isAtRest = false;
  }

  rest() {
    this.isAtRest = true;
    this.draw();
  }
}
