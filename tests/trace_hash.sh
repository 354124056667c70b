#!/usr/bin/env bash
# The same lesson gives the same trace, bit for bit, on this machine and in WebAssembly.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

native=$(build/release/snug trace-hash)
mapfile -t files < <(printf '%s\n' lessons/*.toml | grep -v '/course\.toml$')
wasm=$(node --no-experimental-fetch build/wasm/tests/snug_trace_hash.js build/wasm/assets/meshes "${files[@]}")
[[ -n $native ]] || { echo "no lesson has a trace"; exit 1; }
diff <(sort <<<"$native") <(sort <<<"$wasm") && echo "$native"
