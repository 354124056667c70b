# The lesson with the chart of costs, by keyboard alone: predictions, the measurement, from mark to mark, a box loaded.
. tests/desktop/support.sh
open_window --lesson cost-chart
xdotool key m # not before the predictions
sleep 0.3
[[ $(state 's.handles.some(h => h.id === "exact")') == false ]] || fail "it measured before the predictions"
for question in 1 2 3; do xdotool key s; sleep 0.2; done
xdotool key m
for i in 1 2 3; do # what one wait does not see, a busy machine has not done yet
    (until_state '/lie on the front/.test(s.caption)') 2>/dev/null && break
done
until_state '/lie on the front/.test(s.caption) && s.handles.length === 6'
xdotool key Right
until_state '/front\.$/.test(s.caption)'
xdotool key Left Return
until_state 's.handles.every(h => /^P/.test(h.id)) && s.step === s.steps'
xdotool key c
until_state 's.handles.some(h => h.id === "exact")'
