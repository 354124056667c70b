#!/usr/bin/env bash
# fuzz_all.sh MINUTES [NAMES...]: fuzzes each target (of tests/fuzz, or those named) for so many minutes, one after the
# other, keeps what it learnt in tests/corpus/fuzz, and writes the table of tests/RESULTS.md. Exit status 1: an input
# failed; it is in build/fuzz/found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
minutes=$1 names=("${@:2}") results=tests/RESULTS.md rows=build/fuzz/rows failed=0
((${#names[@]})) || for file in tests/fuzz/*.cpp; do names+=("$(basename "$file" .cpp)"); done
mkdir -p build/logs "$rows"

row() { # name status
    local log=build/logs/fuzz-$1.log runs input outcome=nothing
    runs=$(grep -oP 'stat::number_of_executed_units: \K\d+' "$log") || runs="?"
    if (($2 != 0)); then
        input=$(grep -oP 'Test unit written to \K\S+' "$log" | tail -n 1) || true
        outcome=${input:-"it ended with status $2"}
    fi
    printf '| %s | %s | %s | %s | %s |\n' "$1" "$(find "tests/corpus/fuzz/$1" -type f | wc -l)" "$runs" "$minutes" "$outcome"
}

for name in "${names[@]}"; do
    status=0
    nice -n 15 tests/fuzz/fuzz.sh "$name" "$((minutes * 60))" 2>"build/logs/fuzz-$name.log" >&2 || status=$?
    nice -n 15 tests/fuzz/keep.sh "$name"
    row "$name" "$status" | tee "$rows/$name"
    ((status == 0)) || failed=1
done

{
    printf '# Fuzzing\n\n`./run test --fuzz` wrote this: each target of tests/fuzz, built with the address and undefined-'
    printf 'behaviour sanitizers and led by libFuzzer, on one core that may have had other work. The inputs that it '
    printf 'kept, in tests/corpus/fuzz, are where the next run begins, and `./run test --sanitize` as well (all but `read_lines`).\n\n'
    printf '| target | inputs kept | runs | minutes | found |\n|---|--:|--:|--:|---|\n'
    cat "$rows"/*
    printf '\n'
} >build/fuzz/table.md
awk -v table=build/fuzz/table.md '
    /^# Fuzzing/ { while ((getline line < table) > 0) print line; left_out = 1; next }
    /^# / { left_out = 0 }
    !left_out' "$results" >build/fuzz/results.md
mv build/fuzz/results.md "$results"
exit "$failed"
