#!/usr/bin/env bash
# fuzz.sh NAME [SECONDS [PRESET]]: fuzzes what tests/fuzz/NAME.cpp checks, from the kept corpus, for a minute or for so
# long. An input that fails is kept in build/fuzz, and its name is told. PRESET: fuzz, where Clang's libFuzzer watches
# which way the code goes and what it learns stays in build/fuzz/found/NAME; or sanitize, which changes the corpus blindly.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
name=$(basename "$1" .cpp) seconds=${2:-60} preset=${3:-fuzz}
program=build/$preset/tests/fuzz_$name
[[ -x $program ]] || { cmake --preset "$preset" && cmake --build "build/$preset" --target "fuzz_$name"; }
found=build/fuzz/found/$name
mkdir -p "$found"
kept=(tests/corpus/fuzz/"$name")
case $name in # files that other tests read as well
    read_points) kept+=(tests/corpus/points) ;;
    read_lesson) kept+=(lessons/examples tests/corpus/lessons) ;;
esac
folders=()
for folder in "${kept[@]}"; do [[ ! -d $folder ]] || folders+=("$folder"); done
exec 2> >(grep -av '^snug: /proc/self/fd' >&2) # what the command line says of each file
if [[ $preset == sanitize ]]; then
    exec "$program" "$seconds" "build/fuzz/found/$name-failed" "${folders[@]}" >/dev/null
fi
exec "$program" -max_total_time="$seconds" -seed=1 -timeout=30 -rss_limit_mb=3000 -close_fd_mask=1 \
    -malloc_limit_mb=1000 -verbosity=0 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$name-" \
    "$found" "${folders[@]}"
