// Before anything else is here. A classic script of its own: the page's policy allows none within the HTML.

// The course is there at once; a lesson waits for the program beneath the veil.
document.documentElement.dataset.view = new URLSearchParams(location.search).get("lesson") === null ? "course" : "lesson";

// For scripts and tests, from the first moment on; main.js fills it in.
window.snug = { ready: new Promise((resolve) => addEventListener("snug-ready", resolve, { once: true })), state: () => null, handles: () => [], frameTimes: () => [] };

// A page whose own files do not arrive must still say so. A script's error does not bubble: it is caught on its way down.
addEventListener("error", ({ target }) => {
  if (!(target instanceof HTMLScriptElement)) return;
  document.documentElement.dataset.view = "lesson";
  document.getElementById("veil-text").textContent =
    "Some of the page’s own files did not arrive. Check the connection, then try again.";
  document.getElementById("veil-bar").hidden = true;
  const again = document.getElementById("veil-retry");
  again.hidden = false;
  again.onclick = () => location.reload();
}, { capture: true });
