# A demo in the window: led by the keys of a clicker alone; any drag is forgotten; nothing of it is kept.
. tests/desktop/support.sh
demo=lessons/demos/collision.toml
hash_of() { grep -oP '^hash = "\K[0-9a-f]+' "$demo" | sed -n "$1p"; } # state, counted from 1
at() { until_state "s.presenting && s.trace === '$(hash_of "$1")' && s.step === $2"; } # state step
opened="s.presenting" open_window demo play "$demo"
at 1 20
xdotool key Next # the sentence
xdotool key Next # the numbers
xdotool key Next
at 2 0
xdotool key Right # the sentence
xdotool key Right
at 3 0
until_state 's.asked.id === "first-axis"'
xdotool key Right # the answer
until_state 's.asked === null && s.outcome === "first-axis"'
xdotool key Prior # as it was: asked again
until_state 's.asked.id === "first-axis"'
xdotool key Prior # the state before, with all that it reveals
at 2 0
until_state 's.asked === null'

# Whatever is done to a state, Home brings it back.
read -r x y < <(handle A)
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2
for i in 1 2 3 4 5 6; do xdotool mousemove --window "$window" $((x + 10 * i)) $((y - 5 * i)) sleep 0.03; done
xdotool mouseup 1
until_state "s.trace !== '$(hash_of 2)'"
xdotool key space
xdotool key Home
at 2 0

xdotool key b # black; the next key brings the picture back, and does nothing else
xdotool key Next
sleep 0.5
at 2 0
xdotool key n # of a presentation without a demo
sleep 0.5
at 2 0
xdotool key Escape
until_state '!s.presenting && s.lesson === "aabb"'
close_window
! grep -rq scene-broad "$work"/snug* 2>/dev/null || fail "the demo was kept as somebody's work"
mkdir "$work/pictures"
"$snug" demo pictures "$demo" -o "$work/pictures" --size 1280x720
(($(find "$work/pictures" -name '[0-2][0-9]-*.png' | wc -l) == 20)) || fail "not every state is drawn"
for picture in "$work"/pictures/*.png; do
    [[ $(identify -format '%wx%h' "$picture") == 1280x720 ]] || fail "$picture: another size"
    (($(identify -format '%k' "$picture") > 50)) || fail "$picture: next to nothing is drawn"
done
