import { start, stop, visit, state, handles, still, until } from "./support.mjs";
const scale = Number(process.argv[2] ?? 1), which = process.argv[3] ?? "2d";
await start();
const afters=[]; const t = { after: (f) => afters.push(f), diagnostic: console.log };
const init = `Object.defineProperty(window, "devicePixelRatio", { get: () => ${scale} });`;
const page = await visit(t, which === "bunny" ? "?lesson=sphere-pca&from=bunny" : "?lesson=sphere-ritter", { init: init });
if (which === "1000") {
  const points = Array.from({ length: 1000 }, (_, i) => `${Math.cos(i * 2.399963) * Math.sqrt(i / 1000)} ${Math.sin(i * 2.399963) * Math.sqrt(i / 1000)}`);
  await page.locator("#points input[type=file]").setInputFiles({ name: "thousand.xyz", mimeType: "text/plain", buffer: Buffer.from(points.join("\n")) });
  await until(page, (now) => now.size === 1000);
}
await still(page);
const box = await page.locator("#stage").boundingBox();
const middle = [box.x + box.width / 2, box.y + box.height / 2];
const near = (a) => Math.hypot(a.x - middle[0], a.y - middle[1]);
const h = (await handles(page)).reduce((a, b) => (near(b) < near(a) ? b : a));
await page.mouse.move(h.x, h.y); await page.mouse.down();
const r = await page.evaluate(([x, y]) => new Promise((done) => {
    const stage = document.getElementById("stage");
    const begin = performance.now(); window.snug.frameTimes().length = 0; let raf = 0;
    const move = () => { raf++;
      const turn = (performance.now() - begin) / 300;
      stage.dispatchEvent(new PointerEvent("pointermove", { pointerId: 1, pointerType: "mouse", buttons: 1, bubbles: true, clientX: x + 60 * Math.sin(turn), clientY: y + 60 * (1 - Math.cos(turn)) }));
      if (performance.now() - begin < 3000) requestAnimationFrame(move); else done({ raf: raf / 3, canvas: [document.querySelector("canvas").width, document.querySelector("canvas").height], n: window.snug.frameTimes().length / 3, cost: window.snug.frameTimes().map((f) => f.cost).sort((a, b) => a - b)[Math.floor(window.snug.frameTimes().length / 2)] });
    }; move(); }), [h.x, h.y]);
console.log(which, "scale", scale, JSON.stringify(r));
await page.mouse.up();
await stop();
process.exit(0);
