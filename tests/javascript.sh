#!/bin/sh
# The page's JavaScript and its tests', as tsc checks their types and ESLint what it finds, each for itself. For any POSIX
# shell.
set -eu
cd "$(dirname "$0")/.."
tools=tests/browser/node_modules/.bin
$tools/tsc -p web/page
$tools/tsc -p tests/browser
$tools/eslint --config tests/browser/eslint.config.mjs web/page web/sw.js tests/browser tests/page
