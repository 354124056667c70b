// WebKitGTK's MiniBrowser, driven by WebDriver (https://www.w3.org/TR/webdriver2/). It needs a screen and a session
// bus.
import { spawn } from "node:child_process";
import { createServer } from "node:net";
import { existsSync, readdirSync } from "node:fs";

const kPatience = 60_000; // milliseconds
const kReply = 4_000; // until a reply is given up for lost
const kArrival = 15_000; // and one to what loads or moves something

/** Debian keeps it in a folder named after the machine. */
function mini_browser() {
  const places = readdirSync("/usr/lib").map((folder) => `/usr/lib/${folder}/webkit2gtk-4.1/MiniBrowser`);
  const found = process.env.SNUG_WEBKIT ?? places.find((place) => existsSync(place));
  if (!found)
    throw new Error(
      "there is no MiniBrowser of webkit2gtk-4.1: install libwebkit2gtk-4.1-0, or name it in SNUG_WEBKIT",
    );
  return found;
}

const free_port = () => new Promise((resolve) => {
  const server = createServer().listen(0, "127.0.0.1", () => {
    const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
    server.close(() => resolve(port));
  });
});

async function listening(url) {
  for (const until = Date.now() + kPatience; ; await new Promise((later) => setTimeout(later, 100))) {
    if ((await fetch(`${url}/status`).catch(() => null))?.ok) return;
    if (Date.now() > until) throw new Error("WebKitWebDriver does not start");
  }
}

export async function launch(width, height) {
  const binary = mini_browser();
  const port = await free_port();
  // The browser's sandbox needs a user who is not root.
  const root = process.getuid() === 0 ? { WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1" } : {};
  const child = spawn("WebKitWebDriver", [`--port=${port}`, "--host=127.0.0.1"], {
    stdio: "ignore",
    env: { ...process.env, ...root },
  });
  child.on("error", (error) => console.error(error.message));
  const ended = new Promise((resolve) => child.on("exit", resolve).on("error", resolve));
  const driver = `http://127.0.0.1:${port}`;
  await listening(driver);
  const send = async (method, path, body, patience = kPatience) => {
    const answer = await fetch(`${driver}/session${path}`, {
      method,
      body: body && JSON.stringify(body),
      signal: AbortSignal.timeout(patience),
    });
    const { value } = await answer.json();
    if (!answer.ok) throw new Error(`${value.error}: ${value.message}`);
    return value;
  };
  const { sessionId } = await send("POST", "", {
    capabilities: {
      alwaysMatch: {
        pageLoadStrategy: "eager",
        timeouts: { script: kPatience },
        "webkitgtk:browserOptions": { binary, args: ["--automation"] },
      },
    },
  });
  const of_session = (method, path, ...rest) => send(method, `/${sessionId}${path}`, ...rest);
  // The driver loses a reply now and then where the page's address changes meanwhile. A question is then asked again:
  // the page keeps what it found and does not do it twice. An action is not repeated: the test sees what it did.
  const again = async (ask) => {
    for (const late = Date.now() + 2 * kPatience; ;) {
      try {
        return await ask();
      } catch (cause) {
        if (cause.name !== "TimeoutError" || Date.now() > late) throw cause;
      }
    }
  };
  const act = (path, body) => of_session("POST", path, body, kArrival).catch((cause) => {
    if (cause.name !== "TimeoutError") throw cause;
  });
  let asked = 0;
  const evaluate = async (expression) => {
    const id = ++asked;
    const script = `const done = arguments[arguments.length - 1], found = (window.found ??= {});
      found[${id}] ??= (async () => JSON.stringify(await (${expression})) ?? "null")()
        .then((value) => ({ value }), (error) => ({ error: String(error) }));
      found[${id}].then(done);`;
    try {
      const { value, error } = await again(() => of_session("POST", "/execute/async", { script, args: [] }, kReply));
      if (error) throw new Error(error);
      return JSON.parse(value);
    } catch (cause) {
      throw new Error(`${cause.message}, in the page: ${expression}`);
    }
  };
  // The window has bars of its own: it grows until the page has the size.
  const [inner, rect] = [await evaluate("[innerWidth, innerHeight]"), await of_session("GET", "/window/rect")];
  await of_session("POST", "/window/rect", {
    width: rect.width + width - inner[0],
    height: rect.height + height - inner[1],
  });
  return {
    open: (url) => act("/url", { url }),
    evaluate,
    perform: (actions) => act("/actions", { actions }),
    screenshot: async () => {
      const picture = await again(() => of_session("GET", "/screenshot", undefined, kArrival));
      return Buffer.from(picture, "base64");
    },
    async close() {
      await of_session("DELETE", "").catch(() => {}); // it may be gone before it answers
      child.kill();
      await ended;
    },
  };
}
