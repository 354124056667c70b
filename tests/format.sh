#!/bin/sh
# Every C++ file is formatted as .clang-format says, and no index is cast that converts by itself; prints what is not so.
# For any POSIX shell.
set -eu
cd "$(dirname "$0")/.."
files=$(git ls-files '*.cpp' '*.hpp' '*.h')
printf '%s\n' "$files" | xargs -n 40 -P 2 clang-format-14 --dry-run -Werror
# Enumerations need the cast in a subscript; no variable of theirs has a name of one letter, and none is counted with.
! git grep -nE -e '\[static_cast<std::size_t>\(([a-z]|[a-z_.>-]+ [-+] [a-z0-9]+)\)\]' \
  -e '\[static_cast<std::size_t>\([a-z_.]+\) [-+*/%]' -e 'std::array<.*, static_cast<std::size_t>' -- '*.cpp' '*.hpp'
