# A question is answered by the key of its number and Enter, as on the page; until then no step is taken.
. tests/desktop/support.sh
open_window --lesson scene-broad
[[ $(state 's.asked') == null ]] || fail "it asks before anything was seen"
xdotool key Right # which asks
until_state 's.asked !== null'
xdotool key Right
sleep 0.5
[[ $(state 's.step') == 0 ]] || fail "it stepped past its question"
[[ $(state 's.asked.says') == "Press again to skip this question." ]] || fail "it says: $(state 's.asked.says')"
xdotool key 9 # there are four answers
sleep 0.5
[[ $(state 's.step') == 0 && $(state 's.asked.says') == "Press again"* ]] || fail "a number without an answer answered"
xdotool key 2 # chosen, and not given yet
sleep 0.5
[[ $(state 's.step') == 0 ]] || fail "one key gave the answer"
xdotool key Return # which takes the step
until_state 's.step === 1 && s.outcome !== null'
xdotool key Right # which continues
until_state 's.outcome === null'
[[ $(state 's.step') == 1 ]] || fail "it stepped away from what was told"
xdotool key s # the next question is skipped
until_state 's.step === 2'
