# A window shrinks to the screen, and is never smaller than its panels need.
. tests/desktop/support.sh

if [[ ${1:-} == small ]]; then # it calls itself on a small screen
    open_window --lesson sphere-ritter
    X=0 Y=0 WIDTH=0 HEIGHT=0
    eval "$(xdotool getwindowgeometry --shell "$window" | grep -E '^(X|Y|WIDTH|HEIGHT)=')"
    ((X >= 0 && Y >= 0 && X + WIDTH <= 1366 && Y + HEIGHT <= 768)) || fail "$WIDTH x $HEIGHT at $X, $Y on a screen of 1366 x 768"
    ((WIDTH == 1280 && HEIGHT >= 700)) || fail "it shrank to $WIDTH x $HEIGHT"
    exit
fi

status=0
said=$("$snug" --size 640x480 2>&1) || status=$?
((status == 2)) || fail "--size 640x480 ended with $status"
[[ $said == "snug: --size: the window is at least 900x600"* && $(wc -l <<<"$said") == 1 ]] || fail "it said: $said"
"$snug" render sphere-pca --size 640x480 -o "$work/small.png" # a picture may be
[[ $(identify -format '%wx%h' "$work/small.png") == 640x480 ]] || fail "a small picture has another size"

open_window --size 960x1000 --lesson sphere-ritter
[[ $(xdotool getwindowgeometry "$window" | grep -oP 'Geometry: \K\S+') == 960x1000 ]] || fail "a size that was asked for is not kept"
kill "$pid"; wait "$pid" 2>/dev/null || true
rm -f "$SNUG_STATE"

xvfb-run -a -s "-screen 0 1366x768x24" bash "${BASH_SOURCE[0]}" small

# The size, the place, the theme and the text size of the last window are those of the next one.
geometry() { xdotool getwindowgeometry "$window" | grep -oP 'Geometry: \K\S+'; }
place() { xdotool getwindowgeometry "$window" | grep -oP 'Position: \K\S+'; }
open_window --lesson sphere-ritter
xdotool windowsize --sync "$window" 1100 720
xdotool windowmove --sync "$window" 120 80
tab_to "Text size: 100 %"
xdotool key Return
tab_to "Theme: Light"
xdotool key Return
until_state 's.theme === "Dark"'
sleep 1
close_window
open_window --lesson sphere-ritter
[[ $(geometry) == 1100x720 ]] || fail "the window opens at $(geometry)"
[[ $(place) == 120,80 ]] || fail "the window opens at $(place)"
until_state 's.theme === "Dark" && s.text_scale > 1'
close_window
SNUG_THEME=contrast open_window --size 1280x800 --lesson sphere-ritter # what is asked for comes first
until_state 's.theme === "High contrast"'
[[ $(geometry) == 1280x800 ]] || fail "a size that was asked for gives way to the last one: $(geometry)"
close_window
sed -i 's/"x": 120/"x": 9000/' "$work/snug/course.json" # a screen that is gone
open_window --lesson sphere-ritter
x=$(place)
((${x%,*} < 2560)) || fail "the window opens where no screen is: $(place)"
close_window

# In the lowest window, at the largest text, the choice of the algorithm above the pseudocode is still there.
rm -f "$work/snug/course.json"
open_window --size 900x600 --lesson sphere-ritter
tab_to "Text size: 100 %"
for size in 1.15 1.3 1.5 2; do
    xdotool key Return
    until_state "Math.abs(s.text_scale - $size) < 0.001"
done
tab_to Numbers # which the left column has then, so that a stage is left
xdotool key Return
tab_to "Algorithm button"
xdotool key Return
sleep 0.5
xdotool key Down Return
until_state 's.algorithm !== "ritter"'
tab_to Play # and nothing of the player is lost
tab_to "To the end"
close_window
open_window --size 900x600 --lesson break-float
until_state 's.text_scale === 2'
for name in "Hand in" Numbers Points Lesson; do tab_to "$name"; done
close_window

# There, at the usual text: the names of small pictures have room beside each other, and a question stands beside the
# stage, whose figure fills it.
rm -f "$work/snug/course.json"
open_window --size 900x600 --lesson which-volume
until_state 's.text_scale === 1 && s.handles.every(({ x, y }, i, all) =>
    i === 0 || Math.abs(y - all[i - 1].y) > 30 || x - all[i - 1].x > 60)'
close_window
open_window --size 900x600 exercise play be-welzl --seed 3
until_state 's.asked !== null && Math.max(...s.handles.map(({ y }) => y)) - Math.min(...s.handles.map(({ y }) => y)) > 180'
