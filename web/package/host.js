// What the module takes from its host: a clock and its environment. It has no files, and nothing to print to.
const NO_SUCH_FILE = -44;

export function hostImports(memory, variables) {
  const entries = Object.entries(variables).map(([name, value]) => `${name}=${value}\0`);
  const encoder = new TextEncoder();
  const view = () => new DataView(memory().buffer);
  const refuse = () => NO_SUCH_FILE;
  return {
    wasi_snapshot_preview1: {
      environ_sizes_get(count, bytes) {
        view().setUint32(count, entries.length, true);
        view().setUint32(bytes, encoder.encode(entries.join('')).length, true);
        return 0;
      },
      environ_get(addresses, bytes) {
        for (const [k, entry] of entries.entries()) {
          const encoded = encoder.encode(entry);
          view().setUint32(addresses + 4 * k, bytes, true);
          new Uint8Array(memory().buffer).set(encoded, bytes);
          bytes += encoded.length;
        }
        return 0;
      },
      clock_time_get(_clock, _precision, time) {
        view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      proc_exit(status) {
        throw new WebAssembly.RuntimeError(`the module ended itself with status ${status}`);
      },
    },
    env: {
      emscripten_notify_memory_growth() {},
      __syscall_stat64: refuse,
      __syscall_getcwd: refuse,
      __syscall_readlink: refuse,
    },
  };
}
