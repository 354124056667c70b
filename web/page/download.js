// Downloads files and shows true progress: sizes.json, made at build time, has each file's unpacked size, which the
// headers of a compressed transfer lack.

export class Downloads {
  /** @type {Promise<Record<string, number>>} */
  #sizes;
  #expected = /** @type {Map<string, number>} */ (new Map());
  #arrived = /** @type {Map<string, number>} */ (new Map());
  #show;
  #kept = /** @type {Map<string, Promise<any>>} */ (new Map()); // by path, so that no file is fetched twice

  constructor(/** @type {(share: number) => void} */ show) {
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

  /** The file as a Response that reports progress while it arrives. Throws if it does not arrive.
   *  @param {string} path @param {string} type */
  async answer(path, type) {
    const answer = await fetch(window.snug.at(path));
    if (!answer.ok || !answer.body) throw new Error(`${path}: ${answer.status}`);
    this.#sizes.then((sizes) => this.#expected.set(path, sizes[path] ?? 0)); // nothing waits for the bar
    this.#arrived.set(path, 0);
    const count = new TransformStream({
      transform: (chunk, to) => {
        this.#arrived.set(path, (this.#arrived.get(path) ?? 0) + chunk.byteLength);
        this.#report();
        to.enqueue(chunk);
      },
    });
    return new Response(answer.body.pipeThrough(count), { headers: { "Content-Type": type } });
  }

  /** Whether the program that has arrived is that of the page: the site may have been updated in between. */
  async of_one_build() {
    const sizes = /** @type {Record<string, any>} */ (await this.#sizes);
    const own = document.querySelector('meta[name="snug-build"]')?.getAttribute("content");
    return !sizes.build || (sizes.build === own && sizes["snug.wasm"] === this.#arrived.get("snug.wasm"));
  }

  bytes(/** @type {string} */ path) {
    return this.#once(path, async () => {
      const answer = await this.answer(path, "application/octet-stream");
      return new Uint8Array(await answer.arrayBuffer());
    });
  }

  text(/** @type {string} */ path) {
    return this.#once(path, async () => (await this.answer(path, "text/plain; charset=utf-8")).text());
  }

  /** The file is fetched again when it is next asked for. */
  forget(/** @type {string} */ path) {
    this.#kept.delete(path);
  }

  /** @template What @param {string} path @param {() => Promise<What>} bring @returns {Promise<What>} */
  #once(path, bring) {
    const coming = this.#kept.get(path) ?? bring();
    this.#kept.set(path, coming);
    coming.catch(() => this.#kept.delete(path)); // so that it can be tried again
    return coming;
  }
}
