# An exercise in the window: decided by mouse and by keys, kept over a restart, and handed in as a file that is graded.
. tests/desktop/support.sh
cd "$work"
snug=$OLDPWD/$snug
open_window exercise play be-quickhull --seed 11
[[ $(state 's.exercise.decision') == 0 ]] || fail "it begins with $(state 's.exercise.decision')"
for i in 1 2 3; do xdotool key h; until_state "s.exercise.hints.length === $i || s.exercise.hints.length === 2 && $i === 3"; done
first=$(state '/The answer: (.*)\.$/.exec(s.exercise.hints.at(-1))[1]')
sleep 1.5 # the view makes room for the hints
read -r x y <<< "$(handle "$first")"
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2 mouseup 1 # a tap decides
until_state 's.exercise.decision === 1'
[[ $(state 's.exercise.mark') == 0 ]] || fail "a decision that a hint has told earns $(state 's.exercise.mark')"
trace=$(state 's.trace')
for key in s Delete a ctrl+z Page_Down End; do xdotool key $key; done
sleep 0.5
[[ $(state 's.exercise.decision') == 1 && $(state 's.trace') == "$trace" ]] || fail "a key changed the exercise"
xdotool key bracketright # chooses, and decides nothing
until_state 's.asked.says.includes("chosen")'
[[ $(state 's.exercise.decision') == 1 ]] || fail "a key that goes through the answers has decided"
close_window

open_window exercise play be-quickhull --seed 11 # as it was left
[[ $(state 's.exercise.decision') == 1 ]] || fail "it goes on with $(state 's.exercise.decision')"
for i in $(seq 30); do # whatever is wrong is told, and the run goes on
    [[ $(state 's.exercise.finished && s.exercise.run === ""') == true ]] && break
    xdotool key bracketright Return
    sleep 0.3
    xdotool key Return
    sleep 0.3
done
until_state 's.exercise.finished && s.exercise.run === ""'
xdotool key r # the student's run, beside the right one
until_state 's.exercise.run === "own"'
decision=$(state 's.exercise.decision') step=$(state 's.step')
xdotool key Left
until_state "s.exercise.decision < $decision || $decision === 0"
xdotool key r # the right run, from there
until_state "s.exercise.run === 'right' && s.step <= $step"
xdotool key End
until_state 's.exercise.run === "" && s.step === s.steps'
tab_to "Hand in"
xdotool key Return
until_state 's.notice.startsWith("Saved as")'
"$snug" grade be-quickhull-11.json > graded || fail "it is graded: $(cat graded)"
grep -q 'be-quickhull .* ok$' graded || fail "it is graded: $(cat graded)"
mark=$(state 's.exercise.mark')
close_window

before=$(md5sum < "$XDG_STATE_HOME/snug/course.json")
open_window grade --watch be-quickhull-11.json # all decisions, to look at
until_state 's.exercise.finished'
[[ $(state 's.exercise.mark') == "$mark" ]] || fail "what is watched earns $(state 's.exercise.mark'), not $mark"
close_window
[[ $(md5sum < "$XDG_STATE_HOME/snug/course.json") == "$before" ]] || fail "what was watched is kept as one's own"

open_window exercise play build-worst-ritter --seed 3 # what is built
read -r x y <<< "$(handle P0)"
trace=$(state 's.trace')
xdotool mousemove --window "$window" "$x" "$y" sleep 0.3 mousedown 1 sleep 0.2 mousemove_relative -- -60 30 sleep 0.2 mouseup 1
until_state "s.trace !== '$trace'"
xdotool key h
until_state 's.exercise.hints.length === 1'
[[ $(state 's.handles.map(h => h.id).join()') == P0,P1,P2 ]] || fail "a point that is to stay can be dragged"
close_window

# A number is typed after another, and the card that tells it does not say how many decisions there are.
open_window exercise play radii-of-boxes --seed 9
tab_to Number
xdotool type 77
xdotool key Return
until_state 's.asked.says.startsWith("Not that one")'
xdotool type 78
xdotool key Return
until_state 's.outcome !== null'
