# A question that playing comes to stands on the stage at once; it is answered by its number twice, by a name typed, and
# by the bracket keys and Enter; what cannot be the answer costs nothing.
. tests/desktop/support.sh
open_window --size 1366x700 --lesson scene-broad
card() { import -window "$window" -crop 560x260+430+290 +repage "$work/$1.png"; } # on the stage's foot
xdotool mousemove --window "$window" 700 300
xdotool key Right
until_state 's.asked !== null'
xdotool key s
until_state 's.asked === null && s.outcome !== null'
xdotool key space # which continues
until_state 's.outcome === null'
xdotool key space
for i in 1 2 3 4 5 6; do (until_state 's.asked !== null') 2>/dev/null && break; done
until_state 's.asked !== null'
sleep 1
card waiting
xdotool mousemove --window "$window" 705 305 sleep 0.5 mousemove --window "$window" 700 300 sleep 1 # which draws anew
card moved
differing=$(compare -metric AE "$work/waiting.png" "$work/moved.png" null: 2>&1 || true)
[[ $differing == 0 ]] || fail "the question was not drawn until the mouse moved: $differing pixels of its card differ"
before=$(state 's.outcomes.length')
xdotool key 1 sleep 0.3
[[ $(state 's.outcomes.length') == "$before" ]] || fail "one key gave the answer"
[[ $(state 's.asked.says') == *"chosen. Choose it again or press Enter to answer." ]] || fail "it says: $(state 's.asked.says')"
xdotool key 1
until_state "s.outcomes.length === $before + 1 || s.asked.says.startsWith('Not that one. Try once more.')"
kill "$pid"; wait "$pid" 2>/dev/null || true
rm -f "$SNUG_STATE"

open_window --lesson frustum-2d
xdotool key Right
until_state 's.asked && s.asked.targets.length === 4'
xdotool key bracketright
until_state 's.asked.says.startsWith(s.asked.targets[0] + " chosen.")'
xdotool key Escape
until_state 's.asked.says === ""'
# A tap on the centre of the box: no vertex, so nothing is answered; two on a vertex answer.
tap() { read -r x y <<<"$(handle "$1")"; xdotool mousemove --window "$window" "$x" "$y" sleep 0.3 click 1 sleep 0.6; }
tap Box
[[ $(state 's.outcomes.length') == 0 ]] || fail "the centre answered"
name=$(state 's.asked.targets[0]')
tap "$name"
[[ $(state 's.asked.says') == "$name chosen. Tap it again or press Enter to answer." ]] || fail "a tap says: $(state 's.asked.says')"
tap "$name"
until_state "s.outcomes.length === 1 || s.asked.says.startsWith('Not that one. Try once more.')"
