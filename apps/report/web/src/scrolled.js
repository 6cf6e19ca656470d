// Lines of a list that is searched and sorted: only those that are seen are drawn, so that 100,000 are as quick
// as ten.
const TALLEST = 8e6; // pixels; browsers draw no element that is much taller

// A list has `size`, `line(at, top)`, which makes the element of a line, `chosenAt()`, -1 where none is chosen, and
// `chooseAt(at, by)`.
export class Scrolled {
  // `height` of a line in pixels, as in the page's style; `more` lines are drawn beyond each end.
  constructor(box, lines, { height, more, head }) {
    Object.assign(this, { box, lines, height, more, head });
    box.addEventListener('scroll', () => this.draw());
    box.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(box);
  }

  resize() {
    this.lines.style.height = `${Math.min(TALLEST, this.height * this.size)}px`;
    this.draw();
  }

  room() { return Math.max(this.height, this.box.clientHeight - (this.head?.offsetHeight ?? 0)); }

  // How many pixels of all lines a pixel of the scroll bar stands for: several, where lines are taller than a
  // browser can scroll.
  scale() {
    const all = this.height * this.size;
    return all <= TALLEST ? 1 : (all - this.room()) / (TALLEST - this.room());
  }

  draw() {
    const above = this.box.scrollTop * this.scale();
    const shift = this.box.scrollTop - above;
    const first = Math.max(0, Math.floor(above / this.height) - this.more);
    const last = Math.min(this.size, Math.ceil((above + this.box.clientHeight) / this.height) + this.more);
    const lines = [];
    for (let at = first; at < last; ++at) {
      lines.push(this.line(at, this.height * at + shift));
    }
    this.lines.replaceChildren(...lines);
    const seen = this.lines.querySelector('[aria-selected="true"]');
    if (seen) {
      this.box.setAttribute('aria-activedescendant', seen.id);
    } else {
      this.box.removeAttribute('aria-activedescendant');
    }
  }

  // Brings the chosen line into sight; a search may have left it out.
  reveal() {
    const top = this.height * this.chosenAt();
    const above = this.box.scrollTop * this.scale();
    if (top >= 0 && (top < above || top + this.height > above + this.room())) {
      this.box.scrollTop = Math.max(0, top - this.room() / 3) / this.scale();
    }
    this.draw();
  }

  // Chooses the line `by` lines further on.
  neighbor(by) {
    if (this.size > 0) {
      const at = this.chosenAt();
      const wanted = at < 0 ? (by > 0 ? 0 : this.size - 1) : at + by;
      this.chooseAt(Math.min(this.size - 1, Math.max(0, wanted)), by);
    }
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.room() / this.height) - 1);
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -this.size, End: this.size };
    if (event.target === this.box && event.key in steps) {
      event.preventDefault();
      this.neighbor(steps[event.key]);
    }
  }
}
