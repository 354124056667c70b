# Where the numbers fill the right column, as fifteen axes do, the pseudocode is a tab beside them; where they do not, it
# stands below.
. tests/desktop/support.sh
open_window --size 1280x800 --lesson obb-axes
tab_to Code
xdotool key Tab # the numbers are shown: no choice of algorithms comes before the situations
until_state 's.focus === "Edge against edge"'
tab_to Code
xdotool key Return sleep 1 key Tab
until_state 's.focus === "Algorithm button"'
close_window

open_window --size 1280x800 --lesson obb-sat
tab_to "Algorithm button"
xdotool key shift+Tab
until_state 's.focus !== "Algorithm button" && s.focus !== "Code"'
