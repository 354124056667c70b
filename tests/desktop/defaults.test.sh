# A class's defaults: the first lesson, the theme, and where results go. What a student was at comes before them.
. tests/desktop/support.sh
export XDG_CONFIG_HOME=$work/config HOME=$work/home
mkdir -p "$work/config/snug" "$HOME"
printf '%s\n' 'first_lesson = "obb-pca"' 'theme = "projector"' 'results = "~/handed in"' >"$work/config/snug/snug.toml"
opened="s.lesson === 'obb-pca'" open_window
[[ $(state 's.theme') == Projector ]] || fail "the theme is $(state 's.theme')"
xdotool key Left
until_state 's.step < s.steps'
close_window
opened='s.lesson === null' open_window # the course's page, which offers to go on
close_window

open_window exercise play aabb-overlap --seed 3
for i in $(seq 10); do # two or three decisions, whatever they earn
    [[ $(state 's.exercise.finished && s.exercise.run === ""') == true ]] && break
    xdotool key 1 sleep 0.3 key Return sleep 0.3 key Return sleep 0.3
done
tab_to "Hand in"
xdotool key Return
until_state "s.notice.startsWith('Saved as $HOME/handed in/aabb-overlap-3.json')"
[[ -s "$HOME/handed in/aabb-overlap-3.json" ]] || fail "no result"
rm -r "$HOME/handed in"
: >"$HOME/handed in" # a file is in the way
xdotool key Return
until_state "s.notice.startsWith('Not saved: $HOME/handed in: ')"
