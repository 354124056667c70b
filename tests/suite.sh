#!/usr/bin/env bash
# suite.sh NAME command...: a suite as CTest runs it. What it prints stays in build/logs/NAME.log as well.
set -o pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build/logs
"${@:2}" </dev/null 2>&1 | tee "build/logs/$1.log"
