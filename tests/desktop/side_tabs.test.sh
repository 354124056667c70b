# Where the numbers fill the right column, as fifteen axes do, the pseudocode is a tab beside them; where they do not, it
# stands below.
. tests/desktop/support.sh
has_focus_on() { # name...: whether Tab comes to all of these
    local name
    for name in "$@"; do tab_to "$name"; done
}
open_window --size 1280x800 --lesson obb-axes
has_focus_on Numbers Code
xdotool key Return
has_focus_on Algorithm
tab_to Numbers
xdotool key Return
sleep 0.3
if (has_focus_on Algorithm) 2>/dev/null; then fail "the choice of algorithms stands beside the fifteen rows"; fi
close_window

open_window --size 1280x800 --lesson obb-sat
has_focus_on Algorithm
if (has_focus_on Code) 2>/dev/null; then fail "four rows need no tab"; fi
