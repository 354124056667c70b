// Two courses' sites that a package meets in tests, in Node and in a page: one that holds every limit of SCORM 1.2, and
// the worst one that its rules allow.

const kScore = /^(100|\d{1,2})(\.\d{1,2})?$/;
const kRules = {
  "cmi.suspend_data": (value) => value.length <= 4096,
  "cmi.core.lesson_status": (value) => /^(passed|completed|failed|incomplete|browsed|not attempted)$/.test(value),
  "cmi.core.score.raw": (value) => kScore.test(value) && Number(value) <= 100,
  "cmi.core.score.min": (value) => kScore.test(value),
  "cmi.core.score.max": (value) => kScore.test(value),
  "cmi.core.session_time": (value) => /^\d{4}:[0-5]\d:[0-5]\d$/.test(value),
  "cmi.core.exit": (value) => /^(time-out|suspend|logout|)$/.test(value),
};

/** An API that notes in `broken` whatever SCORM 1.2 does not allow, and refuses it. api: another one, which it asks. */
export function strict(api, broken) {
  let session = "before";
  const refuse = (what) => (broken.push(what), "false");
  const when = (wanted, name, call) => (session === wanted ? call() : refuse(`${name} ${session} the session`));
  return {
    LMSInitialize: () => when("before", "LMSInitialize", () => ((session = "in"), api.LMSInitialize(""))),
    LMSFinish: () => when("in", "LMSFinish", () => ((session = "after"), api.LMSFinish(""))),
    LMSCommit: () => when("in", "LMSCommit", () => api.LMSCommit("")),
    LMSGetValue: (name) => when("in", "LMSGetValue", () => api.LMSGetValue(name)),
    LMSSetValue: (name, value) => when("in", "LMSSetValue", () =>
      typeof value === "string" && kRules[name]?.(value) ? api.LMSSetValue(name, value) : refuse(`${name} = ${value}`)),
    LMSGetLastError: () => api.LMSGetLastError(),
    LMSGetErrorString: (code) => api.LMSGetErrorString(code),
    LMSGetDiagnostic: (code) => api.LMSGetDiagnostic(code),
  };
}

/** It answers "true" to everything, sends only what differs from what it believes was sent, believes so before it
 *  sends, loses every third request, and can log out while nobody looks. server: what has arrived there. */
export class WorstSite {
  requests = 0;
  logged_out = false;
  constructor(/** @type {Record<string, string>} */ server) {
    this.server = server;
  }
  /** A new session. */
  open() {
    const values = { "cmi.core.lesson_status": "not attempted", "cmi.core.lesson_mode": "normal", ...this.server };
    const believed = { ...values };
    const send = () => {
      const differs = Object.entries(values).filter(([name, value]) => believed[name] !== value);
      Object.assign(believed, values);
      if (differs.length > 0 && ++this.requests % 3 !== 0 && !this.logged_out)
        Object.assign(this.server, Object.fromEntries(differs));
      return "true";
    };
    return {
      LMSInitialize: () => "true",
      LMSFinish: send,
      LMSCommit: send,
      LMSGetValue: (name) => values[name] ?? "",
      LMSSetValue: (name, value) => ((values[name] = value), "true"),
      LMSGetLastError: () => "0",
      LMSGetErrorString: () => "",
      LMSGetDiagnostic: () => "",
    };
  }
}
