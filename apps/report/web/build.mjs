// Bundles the sources into dist/report.js. Run by `npm ci && npm run build`; `node build.mjs FOLDER`
// writes elsewhere. The same sources give the same bytes.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, 'dist');

const bridge = '../../../web/package';

// All that decides what the bundle is, in a fixed order: name and content of each file.
function hashOfSources() {
  const names = ['build.mjs', 'package-lock.json', 'package.json',
    ...readdirSync(join(here, 'src')).sort().map((name) => `src/${name}`),
    ...['errors.js', 'host.js', 'module.js'].map((name) => `${bridge}/${name}`)];
  const hash = createHash('sha256');
  for (const name of names) {
    hash.update(`${name}\0`).update(readFileSync(join(here, name))).update('\0');
  }
  return hash.digest('hex');
}

const three = JSON.parse(readFileSync(join(here, 'node_modules/three/package.json'), 'utf8'));
const banner = `/* The script of soms' report pages: apps/report/web/src with three.js ${three.version} `
  + '(MIT, see LICENSE.three).\n   Made by: npm ci && npm run build. '
  + `Sources: sha256 ${hashOfSources()} */`;

const shared = {
  absWorkingDir: here, bundle: true, minify: true, format: 'iife', target: ['es2022'], charset: 'ascii', legalComments: 'inline',
};

// The script of the worker, as a text that `import WORKER from 'live-worker'` gives.
const worker = await build({
  ...shared, entryPoints: ['src/live_worker.js'], write: false, logOverride: { 'empty-import-meta': 'silent' }, // its URL is never used
});
const carried = {
  name: 'live-worker',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^live-worker$/ }, ({ path }) => ({ path, namespace: 'carried' }));
    onLoad({ filter: /.*/, namespace: 'carried' }, () => ({ contents: worker.outputFiles[0].text, loader: 'text' }));
  },
};

mkdirSync(folder, { recursive: true });
await build({
  ...shared, entryPoints: ['src/main.js'], outfile: join(folder, 'report.js'), plugins: [carried], banner: { js: banner },
});
writeFileSync(join(folder, 'LICENSE.three'),
  readFileSync(join(here, 'node_modules/three/LICENSE')));
