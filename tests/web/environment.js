// Before a program of emscripten runs in node: SOMS_ISA is that of the host, whose files are in /host. The module is
// read from its file, as this emscripten takes a node that has fetch for a browser.
Module.wasmBinary = require('fs').readFileSync(__filename.replace(/\.js$/, '.wasm'));
Module.preRun = () => {
  FS.mkdir('/host');
  FS.mount(NODEFS, { root: '/' }, '/host');
  if (process.env.SOMS_ISA) {
    ENV.SOMS_ISA = process.env.SOMS_ISA;
  }
};
