#!/usr/bin/env bash
# Every C++ file is formatted as .clang-format says; prints those that are not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
git ls-files -z '*.cpp' '*.hpp' '*.h' | xargs -0 -n 40 -P 2 clang-format-14 --dry-run -Werror
