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
until_state 's.demo.next === "Next: the sentence. After that: AABB-AABB intersection"'
xdotool key Right # the sentence
xdotool key Right
at 3 0
until_state 's.asked.id === "first-axis"'
# The class votes, talks, and votes again: no number is on the screen before the answer is.
xdotool key 1 2 Return 3 1 Return
until_state 's.demo.vote.includes(" 12, ") && s.demo.vote.endsWith(" 31") && !/[0-9]/.test(s.demo.shown.replace(/P[0-9]+/g, ""))'
xdotool key Return v 4 Return 3 9 Return Return
until_state 's.demo.vote.includes("Second vote") && s.demo.shown.startsWith("Second vote") && !/ [0-9]/.test(s.demo.shown)'
xdotool key Right # the answer, and with it the votes
until_state 's.asked === null && s.outcome?.question === "first-axis" && s.step > 0 && s.demo.shown === s.demo.vote && / 39$/.test(s.demo.shown)'
xdotool key Prior # as it was: asked again
until_state 's.asked.id === "first-axis"'
xdotool key Prior # the state before, with all that it reveals
at 2 0
until_state 's.asked === null'

# Whatever is done to a state, Home brings it back; what has been scrolled begins at its top again.
whole=$(state s.height)
xdotool windowsize --sync "$window" 900 600
until_state 's.height === 600'
read -r x y < <(settled 'Math.round(s.storedRows[0].x) + " " + Math.round(s.storedRows[0].y)')
xdotool mousemove --window "$window" "$x" "$y" sleep 0.3
for i in 1 2 3 4 5 6; do xdotool click 5 sleep 0.1; done
until_state "s.storedRows[0].y < $y - 5"
xdotool key Home
until_state "Math.round(s.storedRows[0].y) === $y"
xdotool windowsize --sync "$window" $(xdotool getdisplaygeometry)
until_state "s.height === $whole"
read -r x y < <(handle A)
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2
for i in 1 2 3 4 5 6; do xdotool mousemove --window "$window" $((x + 10 * i)) $((y - 5 * i)) sleep 0.03; done
xdotool mouseup 1
until_state "s.trace !== '$(hash_of 2)'"
xdotool key space
xdotool key Home
at 2 0
next=$(state 's.demo.next')

# So does a key that is held: what it did by being pressed is forgotten.
read -r x y < <(handle A)
xdotool mousemove --window "$window" "$x" "$y" sleep 0.5 mousedown 1 sleep 0.2
for i in 1 2 3 4 5 6; do xdotool mousemove --window "$window" $((x + 10 * i)) $((y - 5 * i)) sleep 0.03; done
xdotool mouseup 1
until_state "s.trace !== '$(hash_of 2)'"
xdotool keydown Next
until_state "s.trace === '$(hash_of 2)' && s.demo.next === '$next'"
xdotool keyup Next
at 2 0
xdotool key F5 # the whole screen, which it has
sleep 0.3
until_state 's.presenting && s.demo.state === 2'

# The notes have a window of their own; closed, opened and closed again, nothing of the demo is lost.
for i in 1 2; do
    xdotool key s
    until_state 's.demo.notes'
    notes=$(xdotool search --sync --onlyvisible --name '^Notes – Snug$' | tail -n 1)
    xdotool windowfocus --sync "$notes" key Next # its keys lead as well
    at 2 0
    import -window "$notes" "$work/notes.png"
    (($(identify -format '%k' "$work/notes.png") > 20)) || fail "the notes are empty"
    xdotool windowfocus --sync "$notes" key Prior windowfocus --sync "$window"
    xdotool key s
    until_state '!s.demo.notes'
done
at 2 0
xdotool key Tab Tab sleep 0.3 key Home # a clicker's key for links moves the focus, and nothing else
at 2 0
xdotool key q # the state as a code: without the class's page there is none, but its letters
until_state 's.scanned.length === 4'
xdotool key q
until_state 's.scanned === ""'

xdotool key b # black; the next key brings the picture back, and does nothing else
until_state 's.hall.black'
xdotool key Next
until_state '!s.hall.black'
sleep 0.5
at 2 0
xdotool key n # of a presentation without a demo
sleep 0.5
at 2 0
xdotool key Escape
until_state '!s.presenting && s.lesson === "aabb"'
close_window

# Both from end to end, by the clicker's key alone, with wild drags between; the page's tests walk through them at the
# other size.
walk() { # demo width height
    local i=0 hash presses x y
    opened="s.presenting" open_window demo play "lessons/demos/$1.toml"
    xdotool windowsize --sync "$window" "$2" "$3"
    until_state "s.height === $3"
    while read -r hash presses; do
        until_state "s.trace === '$hash'"
        (until_state 's.smallest.size >= s.height / 40') 2>/dev/null ||
            fail "$1 at $2x$3, state $((i + 1)): too small for the last row: $(state 'JSON.stringify(s.smallest)')"
        if ((++i % 5 == 3)) && read -r x y < <(handle "$(state 's.handles[0]?.id ?? ""')" 2>/dev/null); then
            xdotool mousemove --window "$window" "$x" "$y" mousedown 1 mousemove --window "$window" $((x + 70)) $((y - 50)) mouseup 1
            xdotool key space sleep 0.2 key Home
            until_state "s.trace === '$hash'"
        fi
        for ((; presses >= 0; --presses)); do xdotool key Next; done
    done < <(awk '/^hash = /{gsub(/"/, "", $3); hash = $3; shown = 0} /^reveal = /{shown = gsub(/,/, ",") + 1}
        /^notes = /{print hash, shown; shown = 0}' "lessons/demos/$1.toml")
    ((i >= 20)) || fail "$1 has only $i states"
    close_window
}
walk geometry 1280 720
walk collision 1920 1080

# A demo is recorded by a key, with the view that a hand has made, and shows it again.
cd "$work"
folder=$OLDPWD
snug=$folder/$snug
export XDG_CONFIG_HOME=$work/config
mkdir -p "$work/config/snug"
echo 'page = "https://example.org/snug/"' >"$work/config/snug/snug.toml"
open_window --lesson obb-axes --step 3
trace=$(state s.trace)
xdotool key ctrl+Left ctrl+Left
sleep 1
xdotool key q # its code has the view as well, and is of the same address as the page's
until_state '/^https:..example.org.snug.[?]lesson=obb-axes&step=3&seed=[0-9]+&camera=[-0-9.,e]+&mark=[A-Z]{4}$/.test(s.codeAddress)'
xdotool key q
until_state 's.scanned === ""'
xdotool key D
until_state 's.notice.includes("with this state")'
xdotool key Escape Right
sleep 0.3
xdotool key D
until_state 's.notice.includes("with 2 states")'
close_window
grep -Pq '^camera = "-?[0-9.]+,' demo.toml || fail "the view is not recorded: $(cat demo.toml)"
"$snug" demo check demo.toml
opened="s.presenting" open_window demo play demo.toml
until_state "s.trace === '$trace'"
close_window
cd "$folder"
! grep -rq scene-broad "$work"/snug* 2>/dev/null || fail "the demo was kept as somebody's work"
mkdir "$work/pictures"
"$snug" demo pictures "$demo" -o "$work/pictures" --size 1280x720
(($(find "$work/pictures" -name '[0-2][0-9]-*.png' | wc -l) == 20)) || fail "not every state is drawn"
for picture in "$work"/pictures/*.png; do
    [[ $(identify -format '%wx%h' "$picture") == 1280x720 ]] || fail "$picture: another size"
    (($(identify -format '%k' "$picture") > 50)) || fail "$picture: next to nothing is drawn"
done
"$snug" demo pictures "$demo" -o "$work/demo.pdf" --size 640x360
(($(grep -ac '/Type/Page/' "$work/demo.pdf") == 20)) || fail "the PDF has not every state"
grep -aq '/Source(.*lesson=.*step=' "$work/demo.pdf" || fail "its pages have no address"
