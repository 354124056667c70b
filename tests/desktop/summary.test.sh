# A lesson's end: how each prediction came out, a way back to each, to the task, and on to the next lesson; it is the
# same after a reload, until the answers are erased in the settings.
. tests/desktop/support.sh
opened='s.lesson === null'
open_window
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.step === 0'
for i in $(seq 12); do # past each question, by the key that says so first
    [[ $(state 's.summary') == true ]] && break
    xdotool key End sleep 0.3 key Prior sleep 0.2 key Next sleep 0.3
    if [[ $(state 's.asked !== null') == true ]]; then
        xdotool key Next
        until_state 's.asked.says === "Press again to skip this question." || s.outcome !== null'
        xdotool key Next sleep 0.3
    fi
    [[ $(state 's.outcome !== null') == true ]] && xdotool key Return sleep 0.3
done
until_state 's.summary && s.tally.skipped === s.tally.right + s.tally.wrong + s.tally.skipped + s.tally.open'
xdotool key F2
until_state 's.lesson === null && !s.course[0].done' # what was skipped is not done
close_window
sed -i '0,/"done": false/s//"done": true/' "$work/snug/course.json" # as if every question had been answered

open_window
until_state 's.course[0].done && s.lead === "Next lesson"'
xdotool key Right Return
until_state 's.lesson === "sphere-ritter" && s.summary && s.tally.skipped > 0'
xdotool key Tab
until_state 's.focus === "Go on with AABB centre"'
tab_to "To the task"
xdotool key Return
until_state 's.scrolled > 0'
tab_to "Next lesson"
xdotool key Return
until_state 's.lesson === "sphere-pca" && s.step === 0'
xdotool key Right # it was begun

# Erased in the settings, at the second press.
tab_to Settings
xdotool key Return
tab_to "Erase my answers"
xdotool key Return
until_state 's.focus === "Press again to erase them"'
grep -q sphere-ritter "$work/snug/course.json" || fail "one press erased them"
xdotool key Return
until_state 's.focus === "Erase my answers"'
grep -q sphere-ritter "$work/snug/course.json" && fail "they are still there"
xdotool key Escape F2
until_state 's.lesson === null && !s.course.some(l => l.done)'
close_window

# Where nothing can be written, the course says so, and works.
rm -r "$work/snug"
touch "$work/snug"
open_window
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.step === 0'
xdotool key Right
until_state 's.step === 1'
xdotool key F2
until_state 's.lesson === null && !s.kept && s.lead === "Continue"'
