#!/usr/bin/env bash
# The same lesson gives the same trace, bit for bit, on this machine and in WebAssembly; and the same decisions in an
# exercise the same mark.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

native=$(build/release/snug trace-hash)
mapfile -t files < <(printf '%s\n' lessons/*.toml | grep -v '/course\.toml$')
wasm=$(node --no-experimental-fetch build/wasm/tests/snug_trace_hash.js build/wasm/assets/meshes "${files[@]}")
[[ -n $native ]] || { echo "no lesson has a trace"; exit 1; }
diff <(sort <<<"$native") <(sort <<<"$wasm") && echo "$native"

case=(--no-skip --test-case="the marks of every exercise*")
tests=build/release/tests/snug_tests # ./run test --sanitize builds the other one alone
[[ $tests -nt build/sanitize/tests/snug_tests ]] || tests=build/sanitize/tests/snug_tests
native=$("$tests" "${case[@]}" | grep "^marks ")
wasm=$(node --no-experimental-fetch build/wasm/tests/snug_tests.js "${case[@]}" | grep "^marks ")
diff <(echo "$native") <(echo "$wasm") && echo "$native"
