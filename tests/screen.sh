#!/usr/bin/env bash
# screen.sh command...: runs the command on a screen of its own, with room for a window at two pixels to one. The screen
# keeps its settings when no window is left. Each run looks for a free number from a place of its own, because two runs
# that start at once would both find the same number free.
exec xvfb-run -a -n $((100 + $$ % 5000 * 2)) -s "-screen 0 2560x1600x24 -noreset" "$@"
