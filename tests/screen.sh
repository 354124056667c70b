#!/usr/bin/env bash
# screen.sh command...: runs it on a screen of its own. Two that start at once would find the same number free: each
# begins to look at its own.
exec xvfb-run -a -n $((100 + $$ % 5000 * 2)) -s "-screen 0 2560x1600x24 -noreset" "$@"
