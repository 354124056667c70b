# The lesson with the chart of costs, by keyboard alone: predictions, the measurement, from mark to mark, a box loaded.
. tests/desktop/support.sh
opened='s.caption.length > 0' open_window --lesson cost-chart # on an empty chart
[[ $(state 's.caption') == "Press Measure: first you predict, then it is measured." ]] || fail "asked at once: $(state 's.caption')"
xdotool key m # asks for the predictions first,
sleep 0.3
xdotool key m # and measures not before them,
xdotool key v # nor another chart
sleep 0.3
[[ $(state 's.caption') == "Predict first, then measure." ]] || fail "another chart before the predictions: $(state 's.caption')"
[[ $(state 's.handles.some(h => h.id === "exact")') == false ]] || fail "it measured before the predictions"
for question in 1 2 3; do xdotool key s; sleep 0.2; done
until_state '/now press Measure/.test(s.caption)'
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
# Another chart: how time grows, stopped by hand; what is ready stays.
xdotool key v
until_state '/^Nothing has been measured yet/.test(s.caption)'
xdotool key m
for i in 1 2 3; do
    (until_state '/: [2-6] of 6 algorithms/.test(s.caption)') 2>/dev/null && break
done
until_state '/: [2-6] of 6 algorithms/.test(s.caption) || s.handles.length === 6'
until_state 's.handles.some(h => h.id === "pca") && s.handles.some(h => h.id === "aabb")'
xdotool key Right
xdotool key v
until_state '/^Another chart is being measured/.test(s.caption) || /^Nothing has been measured/.test(s.caption)'
