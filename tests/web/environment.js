// Before a program of emscripten runs in node: SOMS_ISA is that of the host.
Module.preRun = () => {
  if (process.env.SOMS_ISA) {
    ENV.SOMS_ISA = process.env.SOMS_ISA;
  }
};
