# The file of the scene on the stage is edited in the window: what is typed is on the stage at once, a mistake is named,
# and what was typed is still there when the lesson is opened again.
. tests/desktop/support.sh
open_window --lesson scene-effects
until_state 's.steps === 260'
for i in 1 2 3; do [[ $(state 's.asked === null') == true ]] || xdotool key s sleep 0.3; done
tab_to File
xdotool key Return
tab_to "The stage's file"
sleep 0.5
for key in ctrl+Home Down End BackSpace; do xdotool key "$key" sleep 0.3; done
until_state 's.steps === 26 && s.file.typed.startsWith("[scene]\nframes = 26\n")'
xdotool type --delay 60 5
until_state 's.steps === 265 && s.file.mistakes.length === 0'
xdotool type --delay 60 x
until_state 's.file.mistakes.length === 1 && s.steps === 265'
typed=$(state 's.file.typed.slice(0, 24)')
close_window
opened='Boolean(s.file)' open_window --lesson scene-effects
until_state 's.steps === 265 && s.file.mistakes.length === 1'
[[ $(state 's.file.typed.slice(0, 24)') == "$typed" ]] || fail "what was typed is lost: $(state 's.file.typed.slice(0, 24)')"
close_window
