# Where the numbers fill the right column, as fifteen axes do, the pseudocode is a tab beside them; where they do not, it
# stands below.
. tests/desktop/support.sh
comes_to() { (tab_to "$1") 2>/dev/null; } # name: whether Tab does
open_window --size 1280x800 --lesson obb-axes
tab_to Code
xdotool key Return
tab_to "Algorithm button"
tab_to Numbers
xdotool key Return
sleep 0.3
if comes_to "Algorithm button"; then fail "the choice of algorithms stands beside the fifteen rows"; fi
close_window

open_window --size 1280x800 --lesson obb-sat
tab_to "Algorithm button"
if comes_to Code; then fail "four rows need no tab"; fi
