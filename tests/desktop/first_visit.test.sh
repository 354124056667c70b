# A newcomer's first lesson: three invitations on its stage, one at a time, each gone once it was followed with a real
# hand, and never shown again; no other lesson invites.
. tests/desktop/support.sh
opened='s.lesson === null'
open_window
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.step === 0 && /^Drag P[0-9]+$/.test(s.invitation?.words)'
name=$(state 's.invitation.words.slice(5)')
last=
until [[ $(handle "$name") == "$last" ]]; do last=$(handle "$name") && sleep 0.3; done
read -r x y <<<"$last"
xdotool mousemove --window "$window" "$x" "$y" sleep 0.3 mousedown 1 sleep 0.2
for i in 1 2 3 4; do xdotool mousemove --window "$window" $((x - 8 * i)) $((y + 3 * i)) sleep 0.05; done
xdotool mouseup 1
until_state 's.invitation?.words === "Now press Step"'
kill "$pid" && wait "$pid" 2>/dev/null || true
rm -f "$SNUG_STATE"

open_window # the first one is not shown again
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.invitation?.words === "Now press Step"'
xdotool key Right
until_state 's.step === 1'
for i in 1 2 3 4; do
    [[ $(state 's.asked === null && s.outcome === null') == true ]] && break
    xdotool key s sleep 0.3 key Return sleep 0.3
done
until_state 's.invitation?.words === "Press Play: it stops where it asks you"'
xdotool key space
until_state 's.invitation === null'
xdotool key F2
until_state 's.lesson === null'
kill "$pid" && wait "$pid" 2>/dev/null || true
rm -f "$SNUG_STATE"
grep -q '"invited": 3' "$work/snug/course.json" || fail "what was followed is not kept"

rm -r "$work/snug"
opened='s.handles.length > 0' open_window --lesson sphere-welzl
xdotool key Home
until_state 's.step === 0'
[[ $(state 's.invitation') == null ]] || fail "another lesson invites"
