#!/usr/bin/env bash
# keep.sh NAME: makes tests/corpus/fuzz/NAME anew of itself and of what fuzz.sh NAME has found: the inputs of at most
# 1 kB that together go each way through the code, the shortest 120 of them. Those that have a name keep it; what
# libFuzzer chose is named by its hash.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
name=$1 most=120
kept=tests/corpus/fuzz/$name found=build/fuzz/found/$name
mkdir -p "$kept" "$found"
chosen=$(mktemp -d)
trap 'rm -rf "$chosen"' EXIT
build/fuzz/tests/"fuzz_$name" -merge=1 -set_cover_merge=1 -use_counters=0 -max_len=1024 -close_fd_mask=3 -verbosity=0 \
    "$chosen" "$kept" "$found" 2>/dev/null
mapfile -t named < <(find "$kept" -type f -regextype posix-extended ! -regex '.*/[0-9a-f]{40}')
find "$kept" -type f -regextype posix-extended -regex '.*/[0-9a-f]{40}' -delete
((${#named[@]} == 0)) || for input in $(sha1sum "${named[@]}" | cut -d' ' -f1); do rm -f "$chosen/$input"; done
find "$chosen" -type f -printf '%s %p\n' | sort -n |
    awk -v most="$most" 'NR <= most { print $2 }' | xargs -r cp -t "$kept" # head would end before sort does
