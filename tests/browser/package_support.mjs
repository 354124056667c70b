// Packages, made by the program from the built page, and a host for them that serves no file whose ending it does not
// know.
import { execFileSync } from "node:child_process";
import { once } from "node:events";
import {
  appendFileSync, cpSync, existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync,
} from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

const kRoot = fileURLToPath(new URL("../../", import.meta.url));
export const kProgram = process.env.SNUG ?? join(kRoot, "build/release/snug");
export const kSite = process.env.SNUG_SITE ?? join(kRoot, "build/wasm/site");
// What servers of courses know.
const kTypes = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".css": "text/css",
  ".json": "application/json",
  ".txt": "text/plain",
  ".xml": "text/xml",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".bin": "application/octet-stream",
};

const kScormAgain = "node_modules/scorm-again/dist/esm/scorm12.js";
const kCourseSite = '<!doctype html><meta charset="utf-8"><title>A course</title><link rel="icon" href="data:,">' +
  '<script type="module" src="lms_page.js"></script><body>';

export const snug = (...args) => execFileSync(kProgram, args, { encoding: "utf8", maxBuffer: 2 ** 26 });

/** The model's decisions on an instance, as they are typed, or the numbers of choices. */
export function answers_of(id, seed, level = 0) {
  const { attempts: [attempt] } =
    JSON.parse(snug("exercise", "answer", id, "--seed", String(seed), "--level", String(level)));
  return attempt.decisions.map((text) => {
    const [, kind, rest] = /^(.)(.*)@/.exec(text);
    return kind === "c" ? Number(rest) : rest.split(".").map((point) => `P${point}`).join(", ");
  });
}

const models = new Map();
/** The attempt that the model makes. Of a function that is written it has the marks alone: a run would start Node. */
export function model_of(id, seed = 1) {
  const key = `${id} ${seed}`;
  const written = () => {
    const { hash, of } = JSON.parse(snug("exercise", "make", id));
    return { exercise: id, hash, seed: 1, decisions: ["w"], hints: 0, mark: of, of, seconds: 0 };
  };
  const decided = () => JSON.parse(snug("exercise", "answer", id, "--seed", String(seed))).attempts[0];
  if (!models.has(key)) models.set(key, id.startsWith("write:") ? written() : decided());
  return models.get(key);
}

/** What a device keeps of a student who had begun all of the set on geometry, before it is replaced. */
export function kept_before() {
  const quick = model_of("be-quickhull");
  const begun = { ...quick, decisions: quick.decisions.slice(0, 1), mark: 1 };
  const done = (id, at) => ({ tries: 1, best: model_of(id), now: null, at });
  return {
    "be-pivot": done("be-pivot", 1), "be-welzl": done("be-welzl", 1),
    "be-quickhull": { tries: 1, best: { ...quick, mark: 3 }, now: begun, at: 2 },
  };
}

/** A folder for the packages of a test file, removed with it. */
export function workshop() {
  const folder = mkdtempSync(join(tmpdir(), "snug-packages-"));
  const at = (name) => join(folder, name);
  return {
    at,
    /** The unpacked zip of something, in a folder of that name. */
    unpacked(what, name, site = kSite) {
      snug("package", what, "-o", at(`${name}.zip`), "--site", site);
      execFileSync("python3", ["-m", "zipfile", "-e", at(`${name}.zip`), at(name)]);
      return at(name);
    },
    /** A copy of the page, to be changed. */
    site_copy(name) {
      cpSync(kSite, at(name), { recursive: true });
      return at(name);
    },
    /** The set on geometry as its teacher has replaced it: without be-welzl, and with another be-quickhull. */
    replaced(name) {
      const copy = this.site_copy("site");
      const course = JSON.parse(readFileSync(join(copy, "course.json"), "utf8"));
      const set = course.sets.find(({ id }) => id === "geometry");
      set.exercises = set.exercises.filter(({ id }) => id !== "be-welzl");
      writeFileSync(join(copy, "course.json"), JSON.stringify(course));
      appendFileSync(join(copy, "lessons/exercises/be-quickhull.toml"), "\n# another text, another hash\n");
      this.unpacked("set:geometry", name, copy);
    },
    remove: () => rmSync(folder, { recursive: true }),
  };
}

/** A server for the packages of a workshop, each in its folder, and of courses' sites (lms_page.mjs). logged_out:
 *  whether it answers everything with a page to log in on. */
export async function serve_packages(folder) {
  const own = { "lms.html": kCourseSite };
  const files = {
    "lms_page.js": "lms_page.mjs",
    "page/lms.mjs": "../page/lms.mjs",
    [kScormAgain]: kScormAgain,
  };
  const host = { logged_out: false, texts: own, url: "", close: () => server.close() };
  const server = createServer((request, answer) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname).slice(1));
    const name = path === "" || path.endsWith("/") ? `${path}index.html` : path;
    const send = (type, bytes) =>
      answer.writeHead(200, { "Content-Type": type, "X-Content-Type-Options": "nosniff" }).end(bytes);
    if (host.logged_out) return send("text/html", "<!doctype html><title>Log in</title>");
    if (host.texts[name]) return send("text/html", host.texts[name]);
    if (files[name]) return send("text/javascript", readFileSync(new URL(files[name], import.meta.url)));
    const file = join(folder, name);
    const type = kTypes[extname(name)];
    if (!type || name.startsWith("..") || !existsSync(file) || !statSync(file).isFile())
      return answer.writeHead(404).end();
    send(type, readFileSync(file));
  });
  await once(server.listen(0, "127.0.0.1"), "listening");
  host.url = `http://127.0.0.1:${/** @type {import("node:net").AddressInfo} */ (server.address()).port}/`;
  return host;
}
