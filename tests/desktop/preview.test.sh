# Lessons of one's own in the window: a save is followed within a second at the same place, what is wrong with a file
# stands in the strip, and idle it draws nothing and uses next to no processor. What is done in them is kept apart from the
# course's lessons, as long as the file says the same.
. tests/desktop/support.sh
folder=$work/lessons
mkdir "$folder"
text() { cat lessons/examples/cloud.toml; }
write() { cat >"$folder/$1.toml"; }
text | write mine
within_a_second() { # expression: a save is followed so fast; a busy machine is given another
    local i
    for i in $(seq 40); do
        [[ $(state "$1" 2>/dev/null) == true ]] && return
        sleep 0.05
    done
    fail "not within a second: $1, the state is $(cut -c1-600 "$SNUG_STATE")"
}

open_window --size 1280x800 --lessons "$folder" mine
[[ $(state 's.lesson') == mine && $(state 's.mistakes.length') == 0 ]] || fail "it opened $(state 's.lesson')"
opens_at=$(state 's.step')
xdotool key Right
until_state 's.step === 1'
xdotool key Right
until_state 's.asked !== null || s.step === 2'
step=$(state 's.step')
text | sed 's/0.5, 2.5\]\]/0.5, 2.5], [0.4, 0.2]]/' | write mine
within_a_second 's.points === 6'
[[ $(state 's.step') == "$step" ]] || fail "from step $step it went to $(state 's.step')"

# Two mistakes: it draws on, and they stand there with their places; mended, they go.
text | sed 's/^minutes/minuts/; s/asks = "point"/asks = "pint"/' | write mine
within_a_second 's.mistakes.length === 3'
[[ $(state 's.mistakes[0]') == "mine.toml: 2 mistakes" ]] || fail "the strip says $(state 's.mistakes[0]')"
line() { grep -n "$1" "$folder/mine.toml" | cut -d: -f1; }
[[ $(state 's.mistakes[1]') == "$(line minuts):1: the lesson has no key \"minuts\""* ]] || fail "it says $(state 's.mistakes[1]')"
[[ $(state 's.mistakes[2]') == "$(line pint):8: "* ]] || fail "it says $(state 's.mistakes[2]')"
[[ $(state 's.points') == 5 && $(state 's.step') == "$step" ]] || fail "it no longer draws"
sleep 0.5
import -window "$window" -crop 1280x90+0+48 +repage "$work/strip.png"
[[ $(convert "$work/strip.png" -fill white +opaque '#A3265C' -format '%k' info:) == 2 ]] || fail "no line of the strip is drawn"
text | sed 's/\[points\]/[points/' | write mine
within_a_second 's.mistakes.length === 2 && /cannot be drawn/.test(s.mistakes[0])'
[[ $(state 's.points') == 5 && $(state 's.step') == "$step" ]] || fail "what cannot be drawn did not leave the stage as it was"
text | write mine
within_a_second 's.mistakes.length === 0'

# A link to a lesson that is not there is a mistake until it is there.
text | sed 's/has a centre\./has a centre, as [there](lesson:other)./' | write mine
within_a_second 's.mistakes.length === 2 && /links to a lesson that is not there: other/.test(s.mistakes[1])'
text | write other
within_a_second 's.mistakes.length === 0'
rm "$folder/other.toml"
text | write mine

# Nothing is drawn while nothing changes; looking at the files costs next to nothing.
sleep 1.5
ticks() { awk '{print $14 + $15}' "/proc/$pid/stat"; }
frames=$(state 's.framesDrawn') before=$(ticks)
sleep 3
used=$(($(ticks) - before))
((used <= 9)) || fail "idle for 3 seconds it used $used hundredths of a second of processor"
[[ $(state 's.framesDrawn') == "$frames" ]] || fail "idle it drew"

# Another lesson comes into the course, and one that cannot be read yet waits there for its file.
xdotool key F2
until_state 's.lesson === null'
printf 'version = ' | write late
within_a_second 's.course.length === 2'
[[ $(state 's.course.map(({id, chapter}) => id + " " + chapter).join()') == "late lessons,mine lessons" ]] || fail "the course is $(state 'JSON.stringify(s.course)')"
close_window
opened='s.lesson === null && s.mistakes.length === 2'
open_window --lessons "$folder" late
[[ $(state 's.mistakes[0]') == "late.toml: 1 mistake. It cannot be drawn like this." ]] || fail "it says $(state 's.mistakes[0]')"
cat lessons/examples/pair.toml | write late
within_a_second 's.lesson === "late" && s.mistakes.length === 0'
close_window
kept() { python3 -c 'import json, sys; print(*json.load(open(sys.argv[1]))["lessons"])' "$work/snug/course.json"; }
[[ $(kept) == "$folder/mine.toml" ]] || fail "kept: $(kept)"

# A file alone.
opened=
open_window "$folder/mine.toml"
[[ $(state 's.lesson') == mine ]] || fail "it opened $(state 's.lesson')"
[[ $(state 's.step') == "$step" ]] || fail "it opened at step $(state 's.step'), and was left at $step"
text | sed 's/Who sets the radius/Who decides/' | write mine
within_a_second 's.lesson === "mine" && s.mistakes.length === 0'
for i in $(seq 20); do xdotool getwindowname "$window" | grep -q '^Who decides' && break; sleep 0.05; done
xdotool getwindowname "$window" | grep -q '^Who decides' || fail "the title is $(xdotool getwindowname "$window")"
close_window
text >"$folder/mine.toml" # by another editor, while no window is open
open_window "$folder/mine.toml"
[[ $(state 's.step') == "$opens_at" ]] || fail "a lesson that says something else opened at step $(state 's.step')"
