# Sourced by ./run test: builds what the tests need, runs each kind, adds up what they count.
passed=0
failed=0

count() { # title passed failed log-name
    passed=$((passed + $2)) failed=$((failed + $3))
    say "$1: $2 passed, $3 failed (minute $((SECONDS / 60)))"
    (($3 == 0)) || why "$4"
}

# A test that hangs is one that failed, not one that takes the others with it.
limited=(timeout --kill-after=10 1200)

# A program of doctest's, half of its test cases on each core, shuffled so that the halves take about as long. The last
# line of each says how many failed; its count of those that passed is that of both. No such line, or no test, is a failure.
doctest_suite() { # title log-name command...
    local half all size wrong ok=0 bad=0 pids=() shuffled=(--no-colors=1 --order-by=rand --rand-seed=1)
    all=$("${@:3}" --count | grep -aoP 'filters: \K\d+') || all=0
    local firsts=(1 $((all / 2 + 1))) lasts=($((all / 2)) "$all")
    for half in 0 1; do
        quietly "$2-$half" "${limited[@]}" "${@:3}" "${shuffled[@]}" --first="${firsts[half]}" --last="${lasts[half]}" &
        pids+=($!)
    done
    for half in 0 1; do
        local status=0
        wait "${pids[half]}" || status=$?
        wrong=$(grep -aoP 'test cases: *\d+ \| *\d+ passed \| *\K\d+(?= failed)' "build/logs/$2-$half.log" | tail -n 1) || true
        ((status == 0 || ${wrong:-0} > 0)) || wrong=1
        wrong=${wrong:-1} size=$((lasts[half] - firsts[half] + 1))
        bad=$((bad + wrong)) ok=$((ok + (size > wrong ? size - wrong : 0)))
        ((wrong == 0)) || why "$2-$half"
    done
    passed=$((passed + ok)) failed=$((failed + bad))
    say "$1: $ok passed, $bad failed (minute $((SECONDS / 60)))"
}

# Files for node's own test runner.
node_suite() { # title log-name files...
    local title=$1 log=$2 status=0 ok bad
    quietly "$log" "${limited[@]}" node --test --test-reporter=tap "${@:3}" || status=$?
    figure() { grep -aoP "^# $1 \K\d+" "build/logs/$log.log" | tail -n 1; }
    ok=$(figure pass) bad=$(($(figure fail) + $(figure cancelled)))
    ((bad > 0 || (status == 0 && ok > 0))) || bad=1
    count "$title" "${ok:-0}" "$bad" "$log"
}

# A command that is one test, by its exit status.
one_test() { # title log-name command...
    if quietly "$2" "${limited[@]}" "${@:3}"; then count "$1" 1 0 "$2"; else count "$1" 0 1 "$2"; fi
}

built() { # preset targets...: whether it could be built; if not, that is a failure
    say "Building $1 (minute $((SECONDS / 60)))"
    build "$@" && return
    failed=$((failed + 1))
    return 1
}

# It keeps its settings when no window is left, and has room for one at two pixels to one.
screen=(xvfb-run -a -s "-screen 0 2560x1600x24 -noreset")

if built release snug_tests snug_app_tests snug_desktop; then
    doctest_suite "core, native" core-native build/release/tests/snug_tests
    doctest_suite "app, native" app-native build/release/tests/snug_app_tests
    node_suite "command line" command-line tests/command/*.test.mjs
    for file in tests/desktop/*.test.sh; do
        one_test "$file" "desktop-$(basename "$file" .test.sh)" "${screen[@]}" bash "$file"
    done
fi

if built sanitize snug_tests; then
    doctest_suite "core, sanitized" core-sanitized build/sanitize/tests/snug_tests
fi

if built wasm all; then
    # Emscripten 3.1.6 mistakes Node for a browser when it finds fetch.
    doctest_suite "core, WebAssembly" core-wasm \
        node --no-experimental-fetch build/wasm/tests/snug_tests.js
    one_test "native and WebAssembly traces are equal" trace-hash tests/trace_hash.sh
    one_test "transfer within budget" transfer python3 web/size_report.py build/wasm/site
    if [[ tests/browser/package-lock.json -nt tests/browser/node_modules/.package-lock.json ]]; then
        quietly npm-browser npm --prefix tests/browser ci ||
            stop "npm could not fetch the test packages: connect to a network, then run this again."
        touch tests/browser/node_modules/.package-lock.json
    fi
    node_suite "browser" browser tests/browser/*.test.mjs
fi

say "$passed passed, $failed failed"
((failed == 0))
