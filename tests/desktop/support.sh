# Sourced by the window's tests: opens it on the test's own display and reads its state file.
set -euo pipefail
snug=${SNUG:-build/release/snug}
work=$(mktemp -d)
export SNUG_STATE=$work/state.json XDG_STATE_HOME=$work # what is kept is the test's own
pid=
coproc READER { exec node "$(dirname "${BASH_SOURCE[0]}")/state_reader.mjs"; }
reader=$READER_PID
exec 7<&"${READER[0]}" 8>&"${READER[1]}" # subshells have these
trap 'kill $pid "$reader" 2>/dev/null || true; rm -rf "$work"' EXIT

fail() { printf '%s\n' "$*" >&2; exit 1; }

# What the reader of the state answers; one line to stderr where it cannot.
look() { # wanted given
    local said
    printf '%s\0' "$1" "$SNUG_STATE" "$2" >&8
    IFS= read -r -d '' said <&7
    [[ $said == +* ]] || { printf '%s\n' "$2: ${said#-}" >&2; return 1; }
    printf '%s\n' "${said#+}"
}

# A value of the state file: what the expression says of s.
state() { look state "$1"; }

# Waits until the expression is true of the state.
until_state() { # expression
    look until "$1" >/dev/null 2>&1 || fail "never came true: $1, the state is $(cut -c1-600 "$SNUG_STATE")"
}

# opened: what is true of the state once it is there, where that is not that something can be dragged.
open_window() { # arguments of snug...
    "$snug" "$@" 7<&- 8>&- &
    pid=$!
    until_state "${opened:-s.handles.length > 0}"
    window=$(xdotool search --sync --onlyvisible --pid "$pid" | tail -n 1)
    xdotool windowfocus --sync "$window" 2>/dev/null || true
}

# Ends the program, which keeps what it keeps; the state file is the next one's.
close_window() {
    kill "$pid"
    wait "$pid" 2>/dev/null || true
    rm -f "$SNUG_STATE"
}

# Presses Tab, or another key, until the control of that name has the keyboard.
tab_to() { # name [key]
    local i j focus
    for i in $(seq 70); do
        focus=$(state 's.focus')
        [[ $focus == "$1" ]] && return
        xdotool key "${2:-Tab}"
        for j in $(seq 10); do # a slow frame must not make it go one too far
            [[ $(state 's.focus') == "$focus" ]] || break
        done
    done
    fail "the keyboard never came to $1, it is on $(state 's.focus')"
}

# The same, once it stays as it is.
settled() { look settled "$1"; } # expression
# P3 -> x y, once it stands still.
handle() { settled "(({ x, y }) => Math.round(x) + ' ' + Math.round(y))(s.handles.find(({ id }) => id === '$1'))"; }

# An item of a menu, and a path where one is asked for.
choose() { # menu item
    tab_to "$1 menu"
    xdotool key Return
    sleep 0.5
    tab_to "$2" Down
    xdotool key Return
    sleep 0.3
}
type_path() { # path
    until_state 's.asks_path'
    sleep 0.5
    xdotool key ctrl+a
    xdotool type --delay 40 "$1"
    xdotool key Return
}
