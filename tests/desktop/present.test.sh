# A lecture: the whole screen, without bar and text, from lesson to lesson by keys and buttons; the text on demand; black,
# a picture that stands, pointers.
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
colors() { import -window "$window" png:- | identify -format %k -; }
seen() { import -window "$window" png:- | convert - -format '%#' info:; }
wait_for() { # what comes true...
    local i
    for i in $(seq 50); do "$@" && return; sleep 0.1; done
    fail "never: $*"
}
is_black() { [[ $(colors) == 1 ]]; }
is_seen() { (($(colors) > 50)); }
differs() { [[ $(seen) != "$1" ]]; }
step=$(state 's.step')
for key in b period; do
    xdotool key $key
    until_state 's.hall.black'
    wait_for is_black
    xdotool key Next # brings the picture back, and does nothing else
    until_state '!s.hall.black'
    wait_for is_seen
done
[[ $(state 's.step') == "$step" ]] || fail "the key that ends black did more"
xdotool mousemove --window "$window" 400 300 sleep 0.5
before=$(seen)
xdotool key f
until_state 's.hall.frozen'
xdotool key Next sleep 0.5
until_state "s.step !== $step || s.asked !== null"
[[ $(seen) == "$before" ]] || fail "the picture that stands has changed"
xdotool key f
wait_for differs "$before"
for key in l w r; do # the spotlight, the pen, the ruler
    sleep 0.5
    before=$(seen)
    xdotool key $key
    wait_for differs "$before"
    xdotool key Escape # lays it down, and ends nothing
    until_state 's.presenting'
done
xdotool key question
until_state 's.focus !== undefined'
xdotool key question
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
