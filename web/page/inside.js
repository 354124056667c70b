// In a package that is one file the page's files are in it, packed: nothing is fetched (`snug package --single`).
(() => {
  const inside = (/** @type {string} */ path) => document.getElementById(`file:${path}`)?.textContent;
  const is_picture = (/** @type {string} */ path) => path.endsWith(".png");
  window.snug.at = (path) => (is_picture(path) ? `data:image/png;base64,${inside(path) ?? ""}` : path);
  window.fetch = async (path) => {
    const text = inside(String(path));
    if (!text) return new Response(null, { status: 404 });
    const bytes = Uint8Array.from(atob(text), (char) => char.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
  };
})();
