// The manual and the shells' completions have every command and option that the help has; the shells offer them.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { dirname } from "node:path";
import { test } from "node:test";
import { folder, good, program, write } from "./support.mjs";

/** What a help lists: its options' names, and its commands. */
function listed(help) {
  const section = (title) => help.split(`\n${title}:\n`)[1]?.split("\n\n")[0].split("\n") ?? [];
  const options = section("Options").flatMap((line) => /^ {2}(-\S+)/.exec(line)?.[1].split(",") ?? []);
  return { options, commands: section("Subcommands").map((line) => /^ {2}(\S+)/.exec(line)?.[1]).filter(Boolean) };
}

/** [call, options, commands] of snug and of all commands below it. */
function every(call = []) {
  const { options, commands } = listed(good([...call, "--help"]));
  return [{ call, options, commands }, ...commands.flatMap((name) => every([...call, name]))];
}
const all = every();

const scripts = Object.fromEntries(["bash", "zsh", "fish"].map((shell) => [shell, good(["completions", shell])]));
for (const [shell, text] of Object.entries(scripts)) write(`snug.${shell}`, text);

function run(shell, ...args) {
  const env = { ...process.env, HOME: folder, PATH: `${dirname(program)}:${process.env.PATH}` };
  const { stdout, stderr, status } = spawnSync(shell, args, { cwd: folder, encoding: "utf8", env });
  assert.deepEqual([stderr, status], ["", 0]);
  return stdout;
}

/** How each shell is made to say what it offers after `snug CALL WORD`. */
const scripts_asking = {
  bash: (call, word) => `. ./snug.bash; COMP_WORDS=(snug ${call} '${word}'); COMP_CWORD=$((\${#COMP_WORDS[@]} - 1))
    _snug; printf '%s\\n' "\${COMPREPLY[@]}"`,
  zsh: (call, word) => `_describe() { print -rl -- \${(P)2%%:*} }; _files() {}; compadd() { print -rl -- \${(P)2} }
    _arguments() { print -rl -- \${\${@%%\\[*}%=}; for place in $@; do
      [[ $place != ('*:id: '*|\${words[CURRENT-1]}(|=)\\[*': _snug_'*) ]] || \${=place##*: }; done }
    words=(snug ${call} '${word}'); CURRENT=$#words; . ./snug.zsh`,
  fish: (call, word) => `source snug.fish; complete -C 'snug ${call} ${word}'`,
};
const alone = { bash: ["--norc"], zsh: ["-f"], fish: ["--no-config"] };
const offered = (shell, call, word) =>
  run(shell, ...alone[shell], "-c", scripts_asking[shell](call, word)).split("\n").map((line) => line.split("\t")[0]);

test("help lists the commands there are", () => {
  const calls = all.map(({ call }) => call.join(" "));
  for (const call of ["", "fit", "lesson check", "exercise make", "grade", "help"]) assert.ok(calls.includes(call), call);
  assert.ok(!calls.includes("completions"));
});

test("the manual has every command with every option", () => {
  const sections = good(["man"]).replaceAll("\\-", "-").replace(/\\f[BIP]/g, "").split("\n.SS ");
  for (const { call, options } of all) {
    const title = `snug ${call.join(" ")}`;
    const section = call.length === 0 ? sections[0] : sections.find((text) => `${text.split("\n")[0]} `.startsWith(`${title} `));
    assert.ok(section, title);
    for (const option of options)
      assert.match(section, new RegExp(`^\\.TP\\n.*${option}([ ,]|$)`, "m"), `${title} ${option}`);
  }
});

test("the manual says which files and variables are read, and what opens first", () => {
  const page = good(["man"]).replaceAll("\\-", "-");
  const section = (title) => page.split(`\n.SH ${title}\n`)[1].split("\n.SH ")[0];
  for (const file of ["course.json", "snug.toml"]) assert.ok(section("FILES").includes(file), file);
  for (const name of ["SNUG_THEME", "NO_COLOR", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_CONFIG_DIRS"])
    assert.match(section("ENVIRONMENT"), new RegExp(`^\\.B .*${name}`, "m"));
  for (const text of [page, good(["help"])]) assert.match(text, /by default the course's page, or the lesson last\s+open\./);
});

for (const shell of Object.keys(scripts))
  test(`${shell} offers every command and option where it belongs`, () => {
    for (const { call, options, commands } of all) {
      const dashed = offered(shell, call.join(" "), "-");
      for (const option of options) // fish keeps those of one letter for after the long ones
        assert.ok(dashed.includes(option) || (shell === "fish" && option.length === 2), `${call} ${option}`);
      const bare = commands.length > 0 ? offered(shell, call.join(" "), "") : [];
      for (const command of commands) assert.ok(bare.includes(command), `${call} ${command}`);
    }
    if (shell !== "zsh") assert.deepEqual(offered(shell, "fit --volume", "k").filter(Boolean), ["kdop"]);
  });

/** What can be named where: a call, what is typed of the name, some of what is offered, and what is not. */
const named = [
  ["render", "", ["sphere-ritter", "own-mesh"], "be-ritter"],
  ["lesson play", "sphere-", ["sphere-ritter"], "collision"],
  ["exercise make", "", ["be-ritter", "write:overlap-kdop"], "sphere-ritter"],
  ["exercise print", "", ["collision", "be-ritter"], "sphere-ritter"],
  ["demo check", "", ["collision"], "be-ritter"],
  ["lab new", "", ["overlap"], "collision"],
  ["fit --case", "", ["needle"], "sphere-ritter"],
  ["", "sphere-", ["sphere-ritter"], "be-ritter"],
  ["--lesson", "", ["sphere-ritter"], "be-ritter"],
  ["help", "", ["fit", "lesson"], "check"],
  ["help lesson", "", ["check", "play"], "fit"],
  ["fit --algorithm", "", ["welzl", "dito"], "sphere"],
  ["fit --volume obb --algorithm", "", ["dito", "exact"], "welzl"],
  ["fit --volume=obb --algorithm", "", ["dito", "exact"], "welzl"],
];
for (const shell of Object.keys(scripts))
  test(`${shell} offers lessons, exercises and what else has an id, where it can be named`, () => {
    for (const [call, typed, some, not] of named) {
      const ids = offered(shell, call, typed);
      for (const id of some) assert.ok(ids.includes(id), `${call}: ${id} is not in ${ids}`);
      assert.ok(!ids.includes(not), `${call}: ${not}`);
    }
    assert.ok(!offered(shell, "", "").includes("sphere-ritter"), "beside the commands, once a letter is there");
    if (shell !== "bash") assert.ok(offered(shell, "package", "set:").includes("set:collision"));
  });

test("a value is offered after its option's equals sign", () => {
  const asking = (breaks, ...words) => run("bash", "--norc", "-c", `. ./snug.bash; COMP_WORDBREAKS='${breaks}'; COMP_WORDS=(snug fit ${words.join(" ")})
    COMP_CWORD=$((\${#COMP_WORDS[@]} - 1)); _snug; printf '%s\n' "\${COMPREPLY[@]}"`).trimEnd().split("\n");
  assert.deepEqual(asking(" =", "--volume", "=", "o"), ["obb"]);
  assert.ok(asking(" =", "--volume", "=").includes("sphere"));
  assert.deepEqual(asking(" =", "--volume", "=", "obb", "--algorithm", "=", "di"), ["dito"]);
  assert.deepEqual(asking(" ", "--volume=o"), ["--volume=obb"]);
  assert.deepEqual(asking(" ", "--volume=obb", "--algorithm", "di"), ["dito"]);
  assert.deepEqual(offered("fish", "fit", "--volume=o").filter(Boolean), ["--volume=obb"]);
  assert.match(scripts.zsh, /'--volume=\[[^\]]*\]:value:\(/);
});

test("bash takes a colon for a word of its own, and completes what stands around it", () => {
  const asking = (...words) => run("bash", "--norc", "-c", `. ./snug.bash; COMP_WORDS=(snug package ${words.join(" ")})
    COMP_CWORD=$((\${#COMP_WORDS[@]} - 1)); _snug; printf '%s\n' "\${COMPREPLY[@]}"`);
  assert.match(asking("set", ":", "coll"), /^collision\n$/);
  assert.match(asking("set", ":"), /^collision$/m);
  assert.match(asking("set"), /^set:collision$/m);
});
