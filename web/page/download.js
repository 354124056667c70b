// Downloads files and shows true progress: sizes.json, made at build time, has each file's unpacked size, which the
// headers of a compressed transfer lack.

export class Downloads {
  #sizes = null;
  #expected = new Map();
  #arrived = new Map();
  #show;
  #kept = new Map(); // promises by path, so that no file is fetched twice

  constructor(show) {
    this.#show = show;
    this.#sizes = fetch("sizes.json").then((answer) => (answer.ok ? answer.json() : {}), () => ({}));
  }

  #report() {
    let expected = 0;
    let arrived = 0;
    for (const [path, size] of this.#expected) {
      expected += size;
      arrived += Math.min(size, this.#arrived.get(path) ?? 0);
    }
    if (expected > 0) this.#show(arrived / expected);
  }

  /** The file as a Response that reports progress while it arrives. Throws if it does not arrive. */
  async answer(path, type) {
    const [sizes, answer] = await Promise.all([this.#sizes, fetch(path)]);
    if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
    this.#expected.set(path, sizes[path] ?? 0);
    this.#arrived.set(path, 0);
    const count = new TransformStream({
      transform: (chunk, to) => {
        this.#arrived.set(path, this.#arrived.get(path) + chunk.byteLength);
        this.#report();
        to.enqueue(chunk);
      },
    });
    return new Response(answer.body.pipeThrough(count), { headers: { "Content-Type": type } });
  }

  bytes(path) {
    return this.#once(path, async () => new Uint8Array(await (await this.answer(path, "application/octet-stream")).arrayBuffer()));
  }

  text(path) {
    return this.#once(path, async () => (await this.answer(path, "text/plain; charset=utf-8")).text());
  }

  /** The file is fetched again when it is next asked for. */
  forget(path) {
    this.#kept.delete(path);
  }

  #once(path, bring) {
    if (!this.#kept.has(path)) this.#kept.set(path, bring());
    const coming = this.#kept.get(path);
    coming.catch(() => this.#kept.delete(path)); // so that it can be tried again
    return coming;
  }
}
