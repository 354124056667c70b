// In the settings: the whole page is kept on this device, for use without a network (web/sw.js). Nobody's device is
// filled unasked. In a frame, and in a package, there is none of it: a sandboxed frame throws at the very question.
import { button, by_id, element, set_text } from "./dom.js";

const kOffers = "Snug can be kept on this device, to work without a network: 6 MB.";
const kWorks = "Works offline now.";

/** The worker of this page, if there is one. */
const own = () => navigator.serviceWorker.getRegistration("./");

const can_be_kept = () =>
  parent === window && isSecureContext && document.querySelector('meta[name="snug-names"]') === null &&
  "serviceWorker" in navigator;

/** Until every file is here, and the worker is ready to give them. Throws if one does not arrive.
 *  @param {ServiceWorkerRegistration} registration */
const kept = ({ installing, waiting, active }) => new Promise((resolve, reject) => {
  const worker = installing ?? waiting ?? active;
  if (!worker || worker.state === "activated") return resolve(null);
  worker.addEventListener("statechange", () => {
    if (worker.state === "activated") resolve(null);
    if (worker.state === "redundant") reject(new Error("not every file arrived"));
  });
});

/** @param {HTMLElement} says @param {HTMLElement} press */
async function show(says, press) {
  const works = Boolean((await own())?.active);
  set_text(says, works ? kWorks : kOffers);
  set_text(press, works ? "Keep it no longer" : "Make it work offline");
}

async function keep(/** @type {HTMLElement} */ says) {
  set_text(says, "Fetching every file");
  await kept(await navigator.serviceWorker.register("sw.js"));
}

async function keep_no_longer() {
  const registration = await own();
  await registration?.unregister();
  const names = (await caches.keys()).filter((name) => name.startsWith(`snug ${registration?.scope} `));
  await Promise.all(names.map((name) => caches.delete(name)));
}

let shown = false;

/** Shows it in the settings' panel. */
export async function show_offline() {
  if (shown || !can_be_kept()) return;
  shown = true;
  const says = element("p", { class: "offline-says", role: "status" });
  const press = button("", async () => {
    try {
      await ((await own())?.active ? keep_no_longer() : keep(says));
      await show(says, press);
    } catch {
      set_text(says, "It could not be kept: not every file arrived. Check the connection, then try again.");
    }
  });
  by_id("erase").after(says, press);
  await show(says, press);
}
