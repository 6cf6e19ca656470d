// A body that the reader moves: where it is, what it touches there, and how near it is. Answers are those of soms for the
// exact triangles and the pose that the page shows.
import * as THREE from 'three';
import WORKER from 'live-worker';
import { LiveData, whyNot } from './live_data.js';
import { Hand } from './live_hand.js';
import { LiveView } from './live_view.js';
import { byId } from './page.js';
import { argumentFrom, argumentOf, moved, poseOf, roundedPlace, roundedTurn, shiftOf, turnOf } from './pose.js';
import { liveAnswer, liveOthers, liveWhere } from './words.js';

const HOME = '0 0 0'; // what --pose is where it is left out

// Questions one at a time: of those that wait, the latest is the one that counts.
class Answers {
  constructor(module, models, onAnswer) {
    this.onAnswer = onAnswer;
    this.worker = new Worker(URL.createObjectURL(new Blob([WORKER], { type: 'text/javascript' })));
    this.worker.onmessage = ({ data }) => this.take(data);
    this.worker.onerror = (event) => this.take({ trouble: event.message || 'the worker ended' });
    this.worker.postMessage({ module, models });
    this.open = null; // what the worker is at
    this.next = null; // what comes after it
  }

  ask(question) {
    this.next = question;
    this.send();
  }

  send() {
    if (!this.open && this.next) {
      this.open = this.next;
      this.next = null;
      this.worker.postMessage(this.open);
    }
  }

  take(data) {
    const question = this.open;
    this.open = null;
    this.onAnswer(question, data);
    this.send();
  }
}

export class Live {
  constructor(all, view) {
    this.all = all;
    this.view = view;
    this.active = false;
    this.answer = null; // of the pose that is shown; null until it is there
    const why = whyNot(all);
    if (why) {
      this.refuse(why);
      return;
    }
    byId('move').hidden = false;
    byId('move-keys').hidden = false;
    byId('move').addEventListener('click', () => this.toggle());
    byId('reset').addEventListener('click', () => this.reset());
    addEventListener('beforeprint', () => this.active && this.toggle()); // pictures on paper are those of the report
    this.hand = new Hand(view, this);
    view.canvas.addEventListener('keydown', (event) => {
      if (event.key.toLowerCase() === 'm' && !byId('move').disabled && !event.ctrlKey && !event.metaKey && !event.altKey) {
        this.toggle();
      }
    });
  }

  refuse(why) {
    if (this.active) {
      this.toggle();
    }
    byId('move').hidden = byId('move').disabled = true;
    byId('no-live').hidden = false;
    byId('no-live').textContent = `Bodies cannot be moved on this page: ${why}.`;
  }

  // What is needed to answer, made when the first body is moved. False where it cannot be made.
  prepare() {
    if (!this.answers) {
      try {
        this.data = new LiveData(this.all);
        this.answers = new Answers(this.data.module, this.data.models, (question, found) => this.show(question, found));
        this.drawn = new LiveView(this.view);
      } catch (error) {
        this.refuse(error.message);
        return false;
      }
    }
    return true;
  }

  toggle() {
    if (!this.prepare()) {
      return;
    }
    this.active = !this.active;
    this.hand.active = this.active;
    byId('move').setAttribute('aria-pressed', this.active);
    byId('move').textContent = this.active ? 'Stop moving' : 'Move a body';
    byId('reset').hidden = byId('live').hidden = !this.active;
    byId('look').classList.toggle('moving', this.active);
    if (this.active) {
      this.held = this.chosen() ?? this.held ?? this.all.scene.bodies.moves.indexOf(1);
      this.reset();
    } else {
      this.drawn.show(new Float32Array(0), null);
      this.view.setMoved(null);
    }
  }

  body() { return this.held; }

  // Another body is moved from here on; the one before returns.
  hold(body) {
    if (body !== this.held) {
      this.held = body;
      this.reset();
    }
  }

  // Back to where the report has the body at the step that is shown.
  reset() {
    this.recorded = this.data.exact(this.held, this.view.step);
    if (this.recorded) {
      this.pose = [...this.recorded];
    } else {
      const { place, turn } = this.view.bodies.recorded(this.held, this.view.step);
      this.pose = this.data.poseDrawn(this.held, place, roundedTurn(turn));
    }
    this.begin = this.pose;
    this.argument = argumentOf(this.pose);
    this.by = new THREE.Vector3();
    this.turned = new THREE.Quaternion();
    this.place();
  }

  // The report shows another step.
  setStep() {
    if (this.active) {
      this.reset();
    }
  }

  // A row, contact or gap was chosen: its body is the one that is moved.
  follow() {
    if (this.active) {
      this.held = this.chosen() ?? this.held;
      this.reset();
    }
  }

  // The first body that moves of what is chosen.
  chosen() {
    return this.view.chosenBodies.find((body) => this.all.scene.bodies.moves[body]);
  }

  shift(by) {
    this.by.add(by);
    this.move();
  }

  // Around the middle of its model.
  turn(axis, angle) {
    this.turned.premultiply(new THREE.Quaternion().setFromAxisAngle(axis, angle)).normalize();
    this.move();
  }

  // The pose from how far it was moved and turned in all: nothing adds up, and few digits say it.
  move() {
    const { scale, size } = this.all.scene;
    const middle = this.data.middle(this.held);
    const turn = roundedTurn(this.turned.clone().multiply(new THREE.Quaternion(...turnOf(this.begin))).toArray());
    const center = moved(this.begin, middle);
    const offset = moved(poseOf(turn, [0, 0, 0]), middle);
    const isTurned = Math.abs(this.turned.w) !== 1;
    const by = this.by.toArray();
    const t = shiftOf(this.begin).map((value, axis) => {
      const exact = (isTurned ? center[axis] - offset[axis] : value) + by[axis] / scale;
      return exact === value ? value : roundedPlace(exact, size / scale);
    });
    this.pose = poseOf(turn, t);
    this.argument = argumentFrom(t, turn);
    this.place();
  }

  isRecorded() { return this.pose.every((value, k) => value === this.begin[k]); }

  // Draws the body at its pose, and asks what it touches there.
  place() {
    const { model, moves } = this.all.scene.bodies;
    this.view.setMoved({ body: this.held, place: this.data.onPage(moved(this.pose, this.data.middle(this.held))), turn: turnOf(this.pose) });
    const others = [];
    let left = 0; // movers whose exact poses the page has not
    model.forEach((number, body) => {
      const pose = body === this.held ? null : this.data.exact(body, this.view.step);
      if (pose) {
        others.push({ body, model: number, pose });
      }
      left += moves[body] && body !== this.held && !pose ? 1 : 0;
    });
    left += this.all.scene.bodies.all - model.length;
    this.answer = null;
    byId('live').classList.add('waiting');
    const { text, unsaid } = this.options();
    byId('live-where').textContent = liveWhere(this.all, this.held, this.isRecorded(), Boolean(this.recorded), unsaid);
    byId('live-pose').textContent = text;
    byId('live-others').textContent = liveOthers(this.all, others.length, left);
    byId('reset').disabled = this.isRecorded();
    const mover = { body: this.held, model: model[this.held], pose: Float64Array.from(this.pose) };
    // The ball of the drawn body, whose corners are rounded, is made a little larger.
    const known = this.data.known(this.held, this.pose, 0.5001 * this.view.bodies.sizeOf(this.held) / this.all.scene.scale);
    if (others.length > 0 && known > 0) {
      this.answers.ask({ mover, others, left, known });
    } else {
      this.show({ mover, left, known }, { touched: [], lines: [], gap: null });
    }
  }

  // Options of `soms overlap` for what is shown: of both poses where there are two bodies. `unsaid` is a body that stays at a
  // pose which no option has the digits of; -1 if none does.
  options() {
    const pair = this.all.scene.bodies.model.length === 2;
    const mine = this.argument === null ? '' : `--pose${pair && this.held === 1 ? '-b' : ''} "${this.argument}"`;
    const pose = pair ? this.data.exact(1 - this.held, this.view.step) : null;
    const other = pose && argumentOf(pose);
    return {
      text: [mine, ...(other && other !== HOME ? [`--pose${this.held === 0 ? '-b' : ''} "${other}"`] : [])].join(' ').trim(),
      unsaid: pose && other === null ? 1 - this.held : -1,
    };
  }

  show(question, found) {
    if (found.trouble) {
      this.refuse(found.trouble);
      return;
    }
    const isCurrent = question.mover.pose.every((value, k) => value === this.pose[k]);
    if (!this.active || question.mover.body !== this.held || (this.answer && !isCurrent)) {
      return;
    }
    // What is nearer than the rest of the scene, which is not here, is the nearest of all.
    const gap = found.gap && found.gap.upper <= question.known ? found.gap : null;
    const { origin, scale } = this.all.scene;
    const lines = Float32Array.from(found.lines, (value, k) => (value - origin[k % 3]) * scale);
    this.drawn.show(lines, gap && { points: gap.points.map((at) => this.data.onPage(at)), length: gap.lower });
    byId('live-answer').textContent = liveAnswer(this.all, this.held, { ...found, gap }, question);
    if (isCurrent) {
      byId('live').classList.remove('waiting');
      this.answer = { ...found, gap, known: question.known, lines: found.lines.length / 6 };
    }
  }
}
