# Sourced by ./run test: builds what the tests need, lets CTest run them, adds up what their suites count.
passed=0
failed=0
tried_again=0 # suites that passed only then

# What a suite's log counts, as doctest or node say it: passed and failed; nothing where it is neither's.
counted() { # log
    local figures
    figures=$(grep -aoP 'test cases: *\d+ \| *\K\d+ passed \| *\d+(?= failed)' "$1" | tail -n 1) || true
    [[ -z $figures ]] || { tr -dc '0-9 ' <<<"${figures//|/ }"; return; }
    figure() { grep -aoP "^# $1 \K\d+" "$2" | tail -n 1; }
    grep -qaP '^# pass \d' "$1" || return 0
    echo "$(figure pass "$1") $(($(figure fail "$1") + $(figure cancelled "$1")))"
}

# A suite that ended badly has one failure at least, and so has one that ran nothing.
add_suite() { # log-name status-in-CTest's-words
    local ok bad log=build/logs/$1.log
    [[ -e $log ]] || : >"$log"
    read -r ok bad <<<"$(counted "$log")"
    if [[ -z $ok ]]; then ok=0 bad=0; [[ $2 != run ]] || ok=1; fi
    ((bad > 0 || (ok > 0 && $([[ $2 == run ]] && echo 1 || echo 0)))) || bad=1
    passed=$((passed + ok)) failed=$((failed + bad))
    ((bad == 0)) || { say "$1: $ok passed, $bad failed"; why "$1"; }
}

# What a suite's outcome depends on: every file of this clone, the programs that were built, the packages.
digest() { # preset
    { git ls-files -co --exclude-standard -z | xargs -0 sha256sum
        find "build/$1" \( -path '*/site/*' -o -type f -executable \) -not -path '*/CMakeFiles/*' -type f -print0 | sort -z |
            xargs -0 sha256sum
        stat -c %Y /var/lib/dpkg/status
    } 2>&1 | sha256sum | cut -d ' ' -f 1
}

outcomes() { # CTest's results: a line "suite run" or "suite fail" of each
    grep -oP '<testcase name="\K[^"]+"[^>]* status="[a-z]+' "$1" | sed 's/".*"/ /'
}

# A window or a page that shares two cores with other suites may answer too late. One that failed beside them is run once
# more, alone; both outcomes are told, and the first log is kept. No suite that needs no screen has a second try, nor one
# that was alone already; and where more than three failed, it is no accident.
readonly most_tried_again=3
again_alone() { # preset suite
    local suite=(ctest --test-dir "build/$1" -R "^${2//./[.]}\$" -L '^(desktop|browser)$' -LE '^alone$' --no-tests=error)
    "${suite[@]}" -N | grep -q '^Total Tests: 1$' || return
    say "$2 failed beside other suites:"
    cp "build/logs/$1-$2.log" "build/logs/$1-$2-beside.log"
    why "$1-$2-beside"
    SNUG_DIGEST= "${suite[@]}" --timeout 900 &>/dev/null </dev/null || return
    say "$2 passed when it was run again, alone."
    tried_again=$((tried_again + 1))
}

suites() { # preset, options of CTest: it writes a line for each suite as it ends
    local results=$PWD/build/logs/ctest-$1.xml suite kept
    rm -f "$results"
    unset SNUG_DIGEST
    if [[ -z ${CI:-}${again:-} ]] && git rev-parse --git-dir &>/dev/null; then export SNUG_DIGEST=$(digest "$1"); fi
    kept=$(ctest --test-dir "build/$1" "${@:2}" -N | grep -oP 'Test +#\d+: \K\S+' |
        sed "s|.*|build/logs/$1-&.passed|" | xargs grep -lsFx "${SNUG_DIGEST:-run all}" | wc -l) || true
    ((kept == 0)) || say "$kept suites have not changed since they passed: their counts stand (--again runs all)."
    ctest --test-dir "build/$1" "${@:2}" -j3 --output-junit "$results" 2>&1 | grep -aE '^ *[0-9]+/[0-9]+ Test' || true
    [[ -s $results ]] || { failed=$((failed + 1)); return; }
    local status lost
    lost=$(outcomes "$results" | grep -vc ' run$') || true
    while read -r suite status; do
        if [[ $status != run ]] && ((lost <= most_tried_again)) && again_alone "$1" "$suite"; then status=run; fi
        add_suite "$1-$suite" "$status"
    done < <(outcomes "$results")
    say "$1: $passed passed so far, $failed failed (minute $((SECONDS / 60)))"
}

built() { # preset targets...: whether it could be built; if not, that is a failure
    say "Building $1 (minute $((SECONDS / 60)))"
    build "$@" && return
    failed=$((failed + 1))
    return 1
}

if [[ tests/browser/package-lock.json -nt tests/browser/node_modules/.package-lock.json ]]; then
    quietly npm-browser npm --prefix tests/browser ci ||
        stop "npm could not fetch the test packages: connect to a network, then run this again."
    touch tests/browser/node_modules/.package-lock.json
fi
# The core's tests are compiled once for this machine: with the sanitizers where those are asked for.
if [[ ${sanitize:-} ]]; then
    if built release snug_app_tests snug_install; then suites release -E '^core[.]'; fi
    if built sanitize snug_tests snug_fuzz; then suites sanitize; fi
elif built release snug_tests snug_app_tests snug_install; then
    suites release
fi
if built wasm all; then suites wasm; fi

((tried_again == 0)) || say "$tried_again suites passed only when they were run again, alone."
say "$passed passed, $failed failed"
((failed == 0))
