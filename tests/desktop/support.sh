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

# Waits until the expression is true of the state; machines that do other work as well may be very slow.
until_state() { # expression
    node -e '
        const pause = new Int32Array(new SharedArrayBuffer(4)), end = Date.now() + 120_000;
        for (; Date.now() < end; Atomics.wait(pause, 0, 0, 20)) {
            try {
                s = JSON.parse(require("fs").readFileSync(process.env.SNUG_STATE));
                if (eval(process.argv[1]) !== true) continue;
                Atomics.wait(pause, 0, 0, 120); // what follows meets a window that has drawn it
                process.exit(0);
            } catch {} // not written yet, or half of it
        }
        process.exit(1)' "$1" ||
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
        for j in $(seq 8); do # a slow frame must not make it go one too far
            sleep 0.1
            [[ $(state 's.focus') == "$focus" ]] || break
        done
    done
    fail "the keyboard never came to $1, it is on $(state 's.focus')"
}

# P3 -> x y, once it stands still: a window that has just opened frames its stage anew when it knows its cards.
handle() {
    node -e '
        const read = () => JSON.parse(require("fs").readFileSync(process.env.SNUG_STATE));
        const place = () => {
            const { x, y } = read().handles.find(({ id }) => id === process.argv[1]);
            return Math.round(x) + " " + Math.round(y);
        };
        const pause = new Int32Array(new SharedArrayBuffer(4));
        let before = place();
        for (let still = 0, looks = 0; still < 6 && looks < 100; looks += 1) {
            Atomics.wait(pause, 0, 0, 50);
            let now = before;
            try { now = place(); } catch {} // half written
            still = now === before ? still + 1 : 0;
            before = now;
        }
        console.log(before);' "$1"
}

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
