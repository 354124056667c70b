# A field of 100,000 boxes in the window: the slider leads there by one key, the aim is dragged with a real mouse, and
# every box has its answer.
. tests/desktop/support.sh
open_window --size 1280x800 --lesson frustum-field
xdotool key Home
until_state 's.step === 0'
for i in 1 2 3 4 5 6; do xdotool key End s; done # to the end, past every question
until_state 's.step === s.steps'
xdotool key Escape # the summary goes
until_state '!s.summary'
tab_to Objects
xdotool key End
all='s.readout.inside + s.readout.intersecting + s.readout.outside'
until_state "s.sliders[0].value === 100000 && $all === 100000"
drawn=$(state 's.readout.drawn')

last=
until [[ $(handle Aim) == "$last" ]]; do last=$(handle Aim) && sleep 1; done # the view eases to the larger field
read -r x y <<<"$last"
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2
for i in 1 2 3 4 5 6; do xdotool mousemove --window "$window" $((x + 10 * i)) $((y + 2 * i)) sleep 0.05; done
until_state "s.readout.drawn !== $drawn && $all === 100000" # while the button is down
xdotool mouseup 1
for key in inside intersecting outside; do [[ $(state "s.readout.$key") -gt 0 ]] || fail "none is $key"; done
