// Two bodies: one stands, the other one is moved by hand, and what they have in common is shown while it moves.
import { start } from 'soms/worker';
import { Answers } from './answers.js';
import { Camera } from './camera.js';
import { listen } from './files.js';
import { Hand } from './hand.js';
import { Picture } from './picture.js';
import { Placement } from './placement.js';
import { SAMPLES } from './samples.js';

const COLORS = { fixed: [0.72, 0.74, 0.78], moved: [0.36, 0.58, 0.92] };
const CONTACT = [0.85, 0.1, 0.05];
const GAP = [0.1, 0.55, 0.25];

const element = (id) => document.getElementById(id);
const bodies = {};  // by name: {shape, lower, upper, count}
const camera = new Camera();
let placement = null;
let last = null;    // the last answer
let times = [];     // of answers within the last second
let drawWanted = false;
let picture, remote, answers, hand;

function say(error) {
  element('error').textContent = error.message ?? String(error);
  element('error').hidden = false;
}

function redraw() {
  if (!drawWanted) {
    drawWanted = true;
    requestAnimationFrame(draw);
  }
}

function draw() {
  drawWanted = false;
  picture.draw(camera, { moved: placement?.pose() });
}

function show(answer) {
  last = answer;
  const now = performance.now();
  times = [...times.filter((time) => time > now - 1000), now];
  const touching = answer.count > 0;
  element('contact').textContent = touching ? `${answer.count.toLocaleString('en')} pairs of triangles touch` : 'Nothing touches';
  element('contact').classList.toggle('touching', touching);
  element('gap').textContent = touching ? 'Distance 0' : `Distance ${answer.gap.toPrecision(6)}`;
  element('speed').textContent = `answered in ${answer.milliseconds.toFixed(1)} ms, ${times.length} answers in the last second`;
  picture.putSegments(touching ? answer.segments : answer.line, touching ? CONTACT : GAP);
  redraw();
}

function question() {
  if (placement !== null) {
    element('pose').textContent = placement.text();
    answers.want(bodies.fixed.shape, bodies.moved.shape, placement.pose());
  }
  redraw();
}

/** The moved body begins beside the fixed one: their boxes overlap by a fifth of its width. */
function settle() {
  const { fixed, moved } = bodies;
  if (!fixed || !moved) {
    return;
  }
  const middle = ({ lower, upper }) => Array.from(lower, (x, k) => (x + upper[k]) / 2);
  const width = moved.upper[0] - moved.lower[0];
  const at = middle(fixed);
  at[0] = fixed.upper[0] + 0.3 * width;
  placement = new Placement(middle(moved), at);
  camera.fit([...fixed.lower], Array.from(fixed.upper, (x, k) => (k === 0 ? x + 0.8 * width : x)));
  question();
}

async function take(name, label, mesh) {
  const content = await mesh.read();
  const shape = await remote.shape(mesh);
  mesh.free();
  const box = await shape.bounds();
  const center = Array.from(box.lower, (x, k) => (x + box.upper[k]) / 2);
  bodies[name]?.shape.free();
  bodies[name] = { shape, ...box };
  picture.put(name, content, center, COLORS[name]);
  const notes = content.notes.length > 0 ? `; not read: ${content.notes.join('; ')}` : '';
  element(`${name}-facts`).textContent = `${label}, ${(content.triangles.length / 3).toLocaleString('en')} triangles${notes}`;
  settle();
}

async function takeFile(name, file) {
  element('error').hidden = true;
  try {
    await take(name, file.name, await remote.readMesh(await file.arrayBuffer(), file.name));
  } catch (error) {
    say(error);
  }
}

/** The point of the moved body that a ray sees; null where it sees none, or the fixed body before it. */
async function pick(ray) {
  if (placement === null) {
    return null;
  }
  const [moved, fixed] = await Promise.all([
    remote.closestHit({ shape: bodies.moved.shape, pose: placement.pose() }, ray),
    remote.closestHit(bodies.fixed.shape, ray)]);
  return moved.triangle !== null && moved.lower <= fixed.lower ? [...moved.point] : null;
}

async function begin() {
  picture = new Picture(element('picture'));
  remote = await start();
  answers = new Answers(remote, show, say);
  hand = new Hand(element('picture'), { camera, picture, placement: () => placement }, (ray) => pick(ray).catch(() => null),
           (moved) => (moved ? question() : redraw()));
  element('error').addEventListener('click', () => { element('error').hidden = true; });
  window.addEventListener('resize', redraw);
  listen(takeFile);
  for (const name of ['fixed', 'moved']) {
    await take(name, SAMPLES[name].name, await remote.mesh(SAMPLES[name].mesh()));
  }
}

/** For tests: the last answer and whether it is that for where the body is now; what a ray sees at a place; what is drawn. */
window.demo = {
  state: () => ({ ...last, settled: last !== null && placement !== null && String(last.pose) === String(placement.pose()) }),
  sees: async (x, y) => ((await pick(camera.ray(x, y, picture.aspect()))) === null ? null : 'moved'),
  holds: () => hand.holds(),
  pixels() {
    draw();
    return picture.pixels();
  },
};
begin().catch(say);
