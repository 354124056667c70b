#!/bin/sh
# Every C++ file is formatted as .clang-format says; prints those that are not. For any POSIX shell.
set -eu
cd "$(dirname "$0")/.."
files=$(git ls-files '*.cpp' '*.hpp' '*.h')
printf '%s\n' "$files" | xargs -n 40 -P 2 clang-format-14 --dry-run -Werror
