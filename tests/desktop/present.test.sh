# A lecture: the whole screen, without bar and text, from lesson to lesson by keys and buttons; the text on demand.
. tests/desktop/support.sh
size() { xdotool getwindowgeometry "$window" | grep -oP 'Geometry: \K\S+'; }
open_window --size 1280x800 --lesson sphere-ritter
all_of_screen=$(xdotool getdisplaygeometry | tr ' ' x)
xdotool key F5
until_state 's.presenting && !s.textShown && s.links.length === 0'
for i in $(seq 20); do [[ $(size) == "$all_of_screen" ]] && break; sleep 0.2; done
[[ $(size) == "$all_of_screen" ]] || fail "it takes $(size) of $all_of_screen"
xdotool key t
until_state 's.textShown && s.links.length > 0'
xdotool key t
until_state '!s.textShown'
xdotool key n
until_state 's.lesson === "sphere-pca" && s.step === 0 && s.presenting'
tab_to "Next lesson (N)"
xdotool key Return
until_state 's.lesson === "sphere-welzl" && s.presenting'
xdotool key p
until_state 's.lesson === "sphere-pca"'
xdotool key Escape
until_state '!s.presenting'
for i in $(seq 20); do [[ $(size) == 1280x800 ]] && break; sleep 0.2; done
[[ $(size) == 1280x800 ]] || fail "afterwards it takes $(size)"
xdotool key n # a key of the presentation alone
sleep 0.5
[[ $(state 's.lesson') == sphere-pca ]] || fail "it left the lesson"
