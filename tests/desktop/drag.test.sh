# A point is dragged with a real mouse: the radius follows, and one undo takes all of the drag back.
. tests/desktop/support.sh
open_window --lesson sphere-welzl
# From the result that it opens on to the start, and to the end past every question.
xdotool key Home
until_state 's.step === 0'
for i in 1 2 3 4 5 6 7 8; do xdotool key End s; done
until_state 's.step === s.steps'
before=$(state "s.readout.radius")

# The support point farthest from the middle of the stage is pulled outwards.
last=
until [[ $(handle P1) == "$last" ]]; do last=$(handle P1) && sleep 0.3; done # the view eases to the result
read -r x y <<<"$last"
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2
for i in 1 2 3 4 5 6 7 8; do xdotool mousemove --window "$window" $((x + 8 * i)) $((y - 5 * i)) sleep 0.03; done
until_state "s.selected === 1 && Math.abs(s.readout.radius - $before) > 0.01"
until_state "s.handles.find(h => h.id === 'P1').x > $x + 50" # it is under the mouse, before the button is let go
during=$(state "s.readout.radius")
xdotool mouseup 1
sleep 0.3
after=$(state "s.readout.radius")
node -e "process.exit($during === $after && $after > $before ? 0 : 1)" || fail "radius $before, while dragged $during, then $after"

xdotool key ctrl+z
until_state "s.readout.radius === $before"
xdotool key ctrl+y
until_state "s.readout.radius === $after"

# After a drag the arrow keys are still the player's; a point selected by a key they move.
xdotool key Left
until_state 's.step === s.steps - 1'
xdotool key End
until_state 's.step === s.steps'
xdotool key bracketright
until_state 's.selected === 2'
xdotool key bracketleft
until_state 's.selected === 1'
xdotool key Right
until_state "s.readout.radius !== $after"
xdotool key Escape # the summary goes first
until_state '!s.summary'
xdotool key Escape
until_state 's.selected === null'
xdotool key Home
until_state 's.step === 0'
xdotool key Right
until_state 's.step === 1'
