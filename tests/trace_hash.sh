#!/usr/bin/env bash
# The same lesson gives the same trace, bit for bit, on this machine and in WebAssembly.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

native=$(build/release/snug trace-hash)
wasm=$(node --no-experimental-fetch build/wasm/tests/snug_trace_hash.js build/wasm/assets/meshes lessons/*.toml)
[[ -n $native ]] || { echo "no lesson has a trace"; exit 1; }
diff <(echo "$native") <(echo "$wasm") && echo "$native"
