// Two bodies: one stands, the other one is moved by hand, and what they have in common is shown while it moves.
import { start } from 'soms/worker';
import { Answers } from './answers.js';
import { Camera } from './camera.js';
import { listen } from './files.js';
import { Hand } from './hand.js';
import { Picture } from './picture.js';
import { Placement } from './placement.js';
import { SAMPLES } from './samples.js';

/** What is drawn in which color of colors.css. */
const COLORS = { sky: 'sky-low', rim: 'paper', fixed: 'body-b', moved: 'body-a', contact: 'contact', gap: 'nearest' };

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

function paint() {
  const style = getComputedStyle(document.documentElement);
  picture.paint(Object.fromEntries(Object.entries(COLORS).map(([what, name]) => {
    const hex = style.getPropertyValue(`--${name}`).trim();
    return [what, [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255)];
  })));
  redraw();
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
  element('contact').className = touching ? 'touching' : 'free';
  element('gap').textContent = touching ? 'Distance 0' : `Distance ${answer.gap.toPrecision(6)}`;
  const rate = times.length > 1 ? `, ${times.length} answers in the last second` : '';
  element('speed').textContent = `answered in ${answer.milliseconds.toFixed(1)} ms${rate}`;
  picture.putSegments(touching ? answer.segments : answer.line, touching ? 'contact' : 'gap');
  redraw();
}

function question() {
  if (placement !== null) {
    element('pose').textContent = placement.shortText();
    element('pose').title = placement.text();
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
  const lower = Array.from(fixed.lower, (x, k) => Math.min(x, at[k] - (moved.upper[k] - moved.lower[k]) / 2));
  const upper = Array.from(fixed.upper, (x, k) => Math.max(x, at[k] + (moved.upper[k] - moved.lower[k]) / 2));
  camera.fit(lower, upper, picture.aspect());
  question();
}

async function takeMesh(name, label, mesh) {
  const shape = await remote.shape(mesh);
  mesh.free();
  await take(name, label, shape);
}

async function take(name, label, shape) {
  const content = await shape.read();
  const box = await shape.bounds();
  const center = Array.from(box.lower, (x, k) => (x + box.upper[k]) / 2);
  bodies[name]?.shape.free();
  bodies[name] = { shape, ...box };
  picture.put(name, content, center);
  const notes = content.notes.length > 0 ? `; not read: ${content.notes.join('; ')}` : '';
  element(`${name}-facts`).textContent = `${label}, ${(content.triangles.length / 3).toLocaleString('en')} triangles${notes}`;
  settle();
}

async function takeFile(name, file) {
  element('error').hidden = true;
  try {
    const bytes = await file.arrayBuffer();
    if (/\.somst$/i.test(file.name)) {
      await take(name, file.name, await remote.openShape(bytes, { check: 'full' }));  // whoever made it
    } else {
      await takeMesh(name, file.name, await remote.readMesh(bytes, file.name));
    }
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
  element('copy').addEventListener('click', () => navigator.clipboard.writeText(placement.text()).catch(say));
  window.addEventListener('resize', redraw);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', paint);
  paint();
  listen(takeFile);
  for (const name of ['fixed', 'moved']) {
    await takeMesh(name, SAMPLES[name].name, await remote.mesh(SAMPLES[name].mesh()));
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
