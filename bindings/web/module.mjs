// SPDX-License-Identifier: Apache-2.0
// fairway.wasm from JavaScript, in a Worker of a page or in Node.js. module.d.mts has the types.

const errno_success = 0;
const errno_bad_file = 8;

/** What the C library asks of its host: a clock, and somewhere for last words. There are no files. */
function host(memory_of, say) {
  const write = (file, vectors, count, written) => {
    const view = new DataView(memory_of().buffer);
    const bytes = [];
    for (let i = 0; i < count; ++i) {
      const at = view.getUint32(vectors + 8 * i, true);
      bytes.push(...new Uint8Array(memory_of().buffer, at, view.getUint32(vectors + 8 * i + 4, true)));
    }
    view.setUint32(written, bytes.length, true);
    say(new TextDecoder().decode(new Uint8Array(bytes)));
    return errno_success;
  };
  const clock = (which, precision, at) => {
    new DataView(memory_of().buffer).setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true);
    return errno_success;
  };
  const known = { fd_write: write, clock_time_get: clock };
  return new Proxy(known, { get: (calls, name) => calls[name] ?? (() => errno_bad_file), has: () => true });
}

const hash_text = (hash) => BigInt.asUintN(64, hash).toString(16).padStart(16, '0');

export class Simulator {
  #exports;
  #last_words = '';

  constructor(compiled, unzstd) {
    const calls = host(() => this.#exports.memory, (text) => { this.#last_words += text; });
    const imports = { fairway: { unzstd: (out, capacity, frame, size) => this.#unpack(unzstd, out, capacity, frame, size) } };
    for (const { module, name } of WebAssembly.Module.imports(compiled)) if (module !== 'fairway') (imports[module] ??= {})[name] = calls[name];
    this.#exports = new WebAssembly.Instance(compiled, imports).exports;
    this.#exports._initialize();
  }

  #unpack(unzstd, out, capacity, frame, size) {
    try {
      const bytes = unzstd(new Uint8Array(this.#exports.memory.buffer, frame, size).slice());
      if (bytes.length <= capacity) new Uint8Array(this.#exports.memory.buffer).set(bytes, out);
      return bytes.length;
    } catch {
      return -1;  // more than any capacity
    }
  }

  #bytes() {
    const { memory, text, text_size } = this.#exports;
    return new Uint8Array(memory.buffer, text(), text_size());
  }

  #text() {
    return new TextDecoder().decode(this.#bytes());
  }

  #checked(result) {
    if (result < 0) throw new Error(this.#text());
    return result;
  }

  #json(result) {
    this.#checked(result);
    return JSON.parse(this.#text());
  }

  #say(text) {
    this.#give(new TextEncoder().encode(text));
  }

  #give(bytes) {
    const at = this.#exports.room(bytes.length);
    new Uint8Array(this.#exports.memory.buffer).set(bytes, at);
  }

  load(order) {
    this.#say(JSON.stringify(order));
    this.#checked(this.#exports.load());
  }

  load_recording(bytes, file) {
    const name = new TextEncoder().encode(file);
    const both = new Uint8Array(bytes.length + name.length);
    both.set(bytes);
    both.set(name, bytes.length);
    this.#give(both);
    this.#checked(this.#exports.load_recording(name.length));
  }

  recording() {
    this.#checked(this.#exports.recording());
    return this.#bytes().slice();
  }

  /** Throws where no run has begun. */
  #begun() {
    return this.#checked(this.#exports.done());
  }

  run(steps) { return this.#checked(this.#exports.run(steps)); }
  get done() { return this.#begun() === 1; }
  get time_s() { this.#begun(); return this.#exports.time(); }
  get hash() { this.#begun(); return hash_text(this.#exports.run_hash()); }
  get memory_bytes() { return this.#exports.memory.buffer.byteLength; }
  get last_words() { return this.#last_words; }

  document() { return this.#json(this.#exports.document()); }
  layout() { return this.#json(this.#exports.layout()); }
  part(first, generation) {
    const answer = this.#json(this.#exports.part(first, generation));
    const { memory, bytes, bytes_size } = this.#exports;
    if (answer.part !== null) answer.part.data = new Uint8Array(memory.buffer, bytes(), bytes_size()).slice();
    return answer;
  }
  outcome() { return this.#json(this.#exports.outcome()); }
  names() { return this.#json(this.#exports.names()); }

  explanation(vehicle, time_s) {
    this.#say(vehicle);
    return this.#json(this.#exports.explain(time_s));
  }

  describe(name) {
    this.#say(name);
    return this.#json(this.#exports.describe());
  }

  think(vehicles) {
    this.#say(JSON.stringify(vehicles));
    this.#checked(this.#exports.think());
  }

  hashes() {
    this.#begun();
    const { memory, hashes, hash_count } = this.#exports;
    return Array.from(new BigUint64Array(memory.buffer, hashes(), hash_count()), hash_text);
  }
}
