// Firefox, driven by WebDriver BiDi (https://w3c.github.io/webdriver-bidi/). It needs a screen: headless it has no
// WebGL.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import WebSocket from "ws";

const kPatience = 60_000; // milliseconds, for an answer as for the start
// Nothing of the browser's own asks for anything; and a screen drawn by the processor counts as one.
const kPreferences = {
  "app.normandy.enabled": false,
  "browser.safebrowsing.malware.enabled": false,
  "browser.safebrowsing.phishing.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.homepage": "about:blank",
  "browser.startup.page": 0,
  "datareporting.policy.dataSubmissionEnabled": false,
  "extensions.update.enabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "services.settings.server": "data:,",
  "toolkit.telemetry.enabled": false,
  "webgl.force-enabled": true,
};

/** Where it listens, which it says on its standard error. */
const address_of = (child) => new Promise((resolve, reject) => {
  let said = "";
  const give_up = setTimeout(() => reject(new Error(`Firefox does not start: ${said}`)), kPatience);
  child.on("error", reject);
  child.on("exit", (code) => reject(new Error(`Firefox ended with ${code}: ${said}`)));
  child.stderr.on("data", (bytes) => {
    said += bytes;
    const found = /WebDriver BiDi listening on (ws:\S+)/.exec(said);
    if (!found) return;
    clearTimeout(give_up);
    resolve(found[1]);
  });
});

/** send(method, parameters) of a connection: the result, or the error thrown. */
async function connect(address) {
  const socket = new WebSocket(`${address}/session`);
  const waiting = new Map();
  let count = 0;
  socket.on("message", (bytes) => {
    const { id, result, error, message } = JSON.parse(bytes);
    const settle = waiting.get(id);
    if (!settle) return; // an event
    waiting.delete(id);
    if (error) settle.reject(new Error(`${error}: ${message}`));
    else settle.resolve(result);
  });
  await new Promise((resolve, reject) => socket.on("open", resolve).on("error", reject));
  const send = (method, params = {}) => new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`${method} was not answered`)), kPatience);
    const settled = (settle) => (value) => (clearTimeout(timer), settle(value));
    waiting.set(++count, { resolve: settled(resolve), reject: settled(reject) });
    socket.send(JSON.stringify({ id: count, method, params }));
  });
  return { send, close: () => socket.terminate() };
}

export async function launch(width, height) {
  const profile = mkdtempSync(join(tmpdir(), "snug-firefox-"));
  writeFileSync(
    join(profile, "user.js"),
    Object.entries(kPreferences)
      .map(([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`)
      .join(""),
  );
  const child = spawn(
    process.env.SNUG_FIREFOX ?? "firefox-esr",
    ["--profile", profile, "--no-remote", "--new-instance", "--remote-debugging-port", "0", "about:blank"],
    { stdio: ["ignore", "ignore", "pipe"] },
  );
  const ended = new Promise((resolve) => child.on("exit", resolve));
  const { send, close } = await connect(await address_of(child));
  await send("session.new", { capabilities: {} });
  const [{ context }] = (await send("browsingContext.getTree")).contexts;
  await send("browsingContext.setViewport", { context, viewport: { width, height } });
  return {
    open: (url) => send("browsingContext.navigate", { context, url, wait: "interactive" }),
    async evaluate(expression) {
      const { type, result, exceptionDetails } = await send("script.evaluate", {
        expression: `(async () => JSON.stringify(await (${expression})) ?? "null")()`,
        target: { context },
        awaitPromise: true,
      });
      if (type !== "success") throw new Error(exceptionDetails.text);
      return JSON.parse(result.value);
    },
    perform: (actions) => send("input.performActions", { context, actions }),
    screenshot: async () => Buffer.from((await send("browsingContext.captureScreenshot", { context })).data, "base64"),
    async close() {
      await send("browser.close").catch(() => child.kill()); // it may be gone before it answers
      close();
      await ended;
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
