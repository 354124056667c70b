#!/usr/bin/env bash
# suite.sh NAME command...: a suite as CTest runs it. What it prints stays in build/logs/NAME.log as well. Where
# SNUG_DIGEST is set, a suite that passed with the same digest is not run again, and its log stays.
set -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build/logs
log=build/logs/$1.log stamp=build/logs/$1.passed
if [[ ${SNUG_DIGEST:-} && -e $log && $(cat "$stamp" 2>/dev/null) == "$SNUG_DIGEST" ]]; then
    echo "unchanged since it passed"
    exit
fi
rm -f "$stamp"
"${@:2}" </dev/null 2>&1 | tee "$log" || exit
[[ -z ${SNUG_DIGEST:-} ]] || echo "$SNUG_DIGEST" >"$stamp"
