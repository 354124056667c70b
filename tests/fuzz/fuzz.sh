#!/usr/bin/env bash
# fuzz.sh NAME [SECONDS]: fuzzes what tests/fuzz/NAME.cpp checks, from the kept corpus, for a minute or for so long. What
# it learns stays in build/fuzz/found/NAME; an input that fails is kept beside that folder, and its name is told.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[[ -x build/fuzz/tests/fuzz_$1 ]] || { cmake --preset fuzz && cmake --build --preset fuzz; }
name=$1
found=build/fuzz/found/$name
mkdir -p "$found"
kept=(tests/corpus/fuzz/"$name")
case $name in # files that other tests read as well
    read_points) kept+=(tests/corpus/points) ;;
    read_lesson) kept+=(lessons/examples tests/corpus/lessons) ;;
esac
folders=()
for folder in "${kept[@]}"; do [[ ! -d $folder ]] || folders+=("$folder"); done
exec "build/fuzz/tests/fuzz_$name" -max_total_time="${2:-60}" -seed=1 -timeout=30 -rss_limit_mb=3000 \
    -malloc_limit_mb=1000 -verbosity=0 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$name-" \
    "$found" "${folders[@]}"
