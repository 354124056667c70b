# The window's situations and sliders: by keys, by the mouse and by a link; undo leads back, and the place is kept.
. tests/desktop/support.sh
open_window --size 1280x800 --lessons tests/corpus/lessons near-boxes
[[ $(state 's.situation') == own && $(state 's.sliders.length') == 2 ]] || fail "it opened $(state 'JSON.stringify(s.sliders)')"
own=$(state 's.trace')

# With keys: one step of the slider, and its end; the player stays.
tab_to "Turn of B"
xdotool key Right
until_state 's.sliders[0].value === 1'
[[ $(state 's.trace') != "$own" && $(state 's.step') == 0 ]] || fail "the run did not follow the slider"
xdotool key End
until_state 's.sliders[0].text === "90°"'
xdotool key ctrl+z
until_state 's.sliders[0].value === 1'
xdotool key ctrl+z
until_state "s.trace === '$own'"

# With the mouse: a drag is one entry of undo.
read -r x y width < <(settled 'const t = s.sliders[0]; [t.x, t.y, t.width].map(Math.round).join(" ")')
xdotool mousemove $((x + 10)) "$y" mousedown 1
for part in 5 4 3 2; do
    xdotool mousemove $((x + width / part)) "$y"
    sleep 0.1
done
until_state 'Math.abs(s.sliders[0].value - 45) <= 1' # it is there before the button is let go
xdotool mouseup 1
xdotool key ctrl+z
until_state "s.trace === '$own'"

# The other situation, by its button, and back by a link.
tab_to "Near"
xdotool key Return
until_state 's.situation === "near" && s.sliders.length === 1 && s.sliders[0].text === "5°"'
read -r x y < <(settled 'const l = s.links.find(l => l.to === "own"); Math.round(l.x) + " " + Math.round(l.y)')
xdotool mousemove "$x" "$y" click 1
until_state 's.situation === "own"'
xdotool key ctrl+z
until_state 's.situation === "near"'
close_window

# A picture of a situation, and one that is not there.
"$snug" render tests/corpus/lessons/near-boxes.toml --situation near --step 1 -o "$work/near.png"
"$snug" render tests/corpus/lessons/near-boxes.toml --step 1 -o "$work/own.png"
cmp -s "$work/near.png" "$work/own.png" && fail "both situations look the same"
if "$snug" render tests/corpus/lessons/near-boxes.toml --situation nowhere -o "$work/no.png" 2>"$work/says"; then
    fail "it drew a situation that is not there"
fi
grep -q "there is no situation nowhere" "$work/says" || fail "it says $(cat "$work/says")"
