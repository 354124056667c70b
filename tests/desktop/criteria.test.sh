# Which volume when, by keyboard: the question first, all volumes measured, another one chosen, one of them alone.
. tests/desktop/support.sh
opened='s.caption.length > 0' open_window --lesson which-volume
[[ $(state 's.handles.length') == 7 ]] || fail "it shows $(state 's.handles.length') small pictures"
[[ $(state 's.asked') == null ]] || fail "it asks before anything was seen"
xdotool key m # asks for the prediction first
until_state '/^Predict/.test(s.caption) && s.asked !== null'
xdotool key m
sleep 0.3
[[ $(state 's.caption') == Predict* ]] || fail "it measured before the prediction: $(state 's.caption')"
xdotool key s
until_state '!/^Predict/.test(s.caption)'
xdotool key m
for i in 1 2 3; do # what one wait does not see, a busy machine has not done yet
    (until_state '/^Sphere: T = /.test(s.caption)') 2>/dev/null && break
done
until_state '/^Sphere: T = /.test(s.caption)'
xdotool key Right
until_state '/^AABB: T = /.test(s.caption)'
xdotool key c # the AABB alone
until_state 's.handles.every(h => /^P/.test(h.id))'
xdotool key c
until_state 's.handles.length === 7'
close_window

# A point file alone is shown there, with all volumes around it.
printf '%s\n' '0 0 0' '4 0 0' '0 3 0' '0 0 2' '1 1 1' >"$work/mine.xyz"
opened='s.handles.length === 7' open_window "$work/mine.xyz"
[[ $(state 's.lesson') == which-volume ]] || fail "it opened $(state 's.lesson')"
xdotool key c
until_state 's.handles.length === 5 && s.handles.every(h => /^P/.test(h.id))'
