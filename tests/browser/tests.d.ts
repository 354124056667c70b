// What the tests assume of the page, for tsc, which reads no page.

interface Window {
  [put_there_by_a_test: string]: any;
}

interface Element {
  blur(): void; // of what has the focus
}

interface Document {
  getElementById(id: "canvas"): HTMLCanvasElement;
}

/** How a page is opened: as Playwright's newContext does, and as support.mjs says. */
type Opened = import("playwright-core").BrowserContextOptions & {
  init?: string | (() => unknown);
  wait?: boolean;
  may_complain?: RegExp;
  newcomer?: boolean;
};
