// The list of motions: those that are not free first, as the page has them.
import { byId, said } from './page.js';
import { Scrolled } from './scrolled.js';
import { number } from './words.js';

export class MotionList extends Scrolled {
  constructor({ scene }, onChoose) {
    super(byId('list'), byId('rows'), { height: 92, more: 6 });
    this.motions = scene.motions;
    this.inAll = scene.motions_in_all;
    this.onChoose = onChoose;
    this.chosen = -1;
    this.only = byId('blocked');
    this.blocked = this.motions.filter(({ blocked }) => blocked).length;
    this.only.parentElement.hidden = this.blocked === 0 || this.blocked === this.motions.length;
    this.only.addEventListener('change', () => this.sift());
    this.box.addEventListener('click', ({ target }) => {
      const line = target.closest('[data-at]');
      if (line) {
        this.chooseAt(Number(line.dataset.at));
      }
    });
    this.sift();
  }

  sift() {
    this.order = [...this.motions.keys()].filter((k) => this.motions[k].blocked || !this.only.checked);
    byId('count').textContent = countOfMotions(this.motions.length, this.inAll, this.blocked);
    this.resize();
  }

  get size() { return this.order.length; }

  chosenAt() { return this.order.indexOf(this.chosen); }

  chooseAt(at) { this.onChoose(this.order[at]); }

  mark(k) {
    this.chosen = k;
    this.reveal();
  }

  line(at, top) {
    const motion = this.motions[this.order[at]];
    const line = said('div', '', `line motion${motion.blocked ? ' lasts' : ''}`);
    line.id = `line-${at}`;
    line.dataset.at = at;
    line.setAttribute('role', 'treeitem');
    line.setAttribute('aria-level', 1);
    line.setAttribute('aria-selected', this.order[at] === this.chosen);
    line.setAttribute('aria-posinset', at + 1);
    line.setAttribute('aria-setsize', this.size);
    line.style.top = `${top}px`;
    const bar = document.createElement('i');
    bar.style.left = `${100 * motion.moment}%`;
    bar.style.right = 0;
    bar.hidden = !motion.blocked;
    const when = said('span', '', 'when');
    when.append(bar);
    line.append(said('b', `Motion ${number(motion.number)}: ${motion.verdict}`, 'who'), said('span', motion.words, 'what'), when);
    return line;
  }
}

// "9 motions, 4 of them not free", or of how many motions this page has some.
export function countOfMotions(here, inAll, blocked) {
  const which = here < inAll ? `${number(here)} of ${number(inAll)} motions` : `${number(here)} motions`;
  return `${which}, ${blocked === 0 ? 'all of them free' : `${number(blocked)} of them not free`}`;
}
