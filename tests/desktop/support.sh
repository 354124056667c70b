# Sourced by the window's tests: opens it on the test's own display and reads its state file.
set -euo pipefail
snug=${SNUG:-build/release/snug}
work=$(mktemp -d)
export SNUG_STATE=$work/state.json XDG_STATE_HOME=$work # what is kept is the test's own
pid=
trap '[[ -z $pid ]] || kill "$pid" 2>/dev/null || true; rm -rf "$work"' EXIT

fail() { printf '%s\n' "$*" >&2; exit 1; }

# A value of the state file: node prints what the expression says of s.
state() { node -e 's = JSON.parse(require("fs").readFileSync(process.env.SNUG_STATE)); console.log(eval(process.argv[1]))' "$1"; }

# Waits until the expression is true of the state.
until_state() { # expression
    local i
    for i in $(seq 100); do
        [[ -s $SNUG_STATE && $(state "$1" 2>/dev/null) == true ]] && return
        sleep 0.1
    done
    fail "never came true: $1, the state is $(cut -c1-600 "$SNUG_STATE")"
}

# opened: what is true of the state once it is there, where that is not that something can be dragged.
open_window() { # arguments of snug...
    "$snug" "$@" &
    pid=$!
    until_state "${opened:-s.handles.length > 0}"
    window=$(xdotool search --sync --onlyvisible --pid "$pid" | tail -n 1)
    xdotool windowfocus --sync "$window" 2>/dev/null || true
}

handle() { state "const h = s.handles.find(h => h.id === '$1'); Math.round(h.x) + ' ' + Math.round(h.y)"; } # P3 -> x y
