// The manual and the shells' completions have every command and option that the help has; the shells offer them.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { folder, good, write } from "./support.mjs";

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
  const env = { ...process.env, HOME: folder };
  const { stdout, stderr, status } = spawnSync(shell, args, { cwd: folder, encoding: "utf8", env });
  assert.deepEqual([stderr, status], ["", 0]);
  return stdout;
}

/** How each shell is made to say what it offers after `snug CALL WORD`. */
const scripts_asking = {
  bash: (call, word) => `. ./snug.bash; COMP_WORDS=(snug ${call} '${word}'); COMP_CWORD=$((\${#COMP_WORDS[@]} - 1))
    _snug; printf '%s\\n' "\${COMPREPLY[@]}"`,
  zsh: (call, word) => `_describe() { print -rl -- \${(P)2%%:*} }; _arguments() { print -rl -- \${@%%\\[*} }
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
