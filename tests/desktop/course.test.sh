# Without a lesson the window opens on the course; keys choose a lesson and open it, words find some, and the place is
# kept until the next time, unless the file is damaged.
. tests/desktop/support.sh
kept=$work/snug/course.json
opened='s.lesson === null'

open_window
[[ $(state 's.course.length') == $(grep -o '"[a-z0-9-]*"' <(grep '^lessons' lessons/course.toml) | wc -l) ]] || fail "not every lesson stands there"
[[ $(state 's.lead + s.chosen') == "Start here-1" ]] || fail "a newcomer is not asked to start"
xdotool key Right
until_state 's.chosen === 0'
xdotool key Right
until_state 's.chosen === 1'
# The search: by a slash from anywhere, and by its words.
xdotool key slash
until_state 's.focus === "Search the lessons"'
sleep 0.3
xdotool type --delay 60 "Welzl, support"
until_state 's.asked === "Welzl, support" && s.found.length < s.course.length'
state 's.found.map(i => s.course[i].id).join(" ")' | grep -qw sphere-welzl || fail "it finds $(state 's.found')"
xdotool type --delay 60 zzz
until_state 's.found.length === 0'
xdotool key Escape
until_state 's.asked === "" && s.found.length === s.course.length'
xdotool key Escape
until_state 's.focus === ""'
xdotool key slash
until_state 's.focus === "Search the lessons"'
sleep 0.3
xdotool type --delay 60 "frustum space: six"
until_state 's.found.length === 1'
xdotool key Return # to what was found
until_state 's.course[s.chosen]?.id === "frustum-3d"'
xdotool key Escape sleep 0.3 key Escape
until_state 's.found.length === s.course.length'
xdotool key slash
until_state 's.focus === "Search the lessons"'
sleep 0.3
xdotool type --delay 60 "lab sheet float" # lab sheets and exercises as well
until_state 's.found.length === 0 && s.found_beside.join() === "break-float"'
xdotool key Return sleep 0.5 key Return
until_state 's.lesson === "break-float"'
xdotool key F2
until_state 's.lesson === null'
xdotool key Escape
until_state 's.asked === ""'
xdotool key slash
until_state 's.focus === "Search the lessons"'
sleep 0.3
xdotool type --delay 60 "exercise price split"
until_state 's.found.length === 0 && s.found_beside.join() === "price-a-split"'
xdotool key Return sleep 0.5 key Return
until_state 's.exercise?.exercise === "price-a-split"'
xdotool key F2
until_state 's.lesson === null'
xdotool key Escape sleep 0.3 key Escape
until_state 's.found.length === s.course.length'
xdotool key Home
until_state 's.focus === "Start here"'
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.step === 0'
[[ ! -e $kept ]] || fail "what was only looked at is kept"
xdotool key Right
until_state 's.step === 1'
xdotool key F2
until_state 's.lesson === null && s.lead === "Continue"'
close_window

open_window
until_state 's.lead === "Continue"'
xdotool key Return
until_state 's.lesson === "sphere-ritter" && s.step === 1'
close_window

for damage in '{' '[]' '{"version":1,"last":3,"lessons":{"sphere-ritter":7,"x":{"step":-1,"answers":[]}}}' '{"version":99}'; do
    echo "$damage" >"$kept"
    open_window
    until_state 's.lead === "Start here"'
    case $damage in
        '{' | '[]') # it is kept aside, as it was, and the window says where
            [[ $(state 's.set_aside') == "$kept.damaged" && $(<"$kept.damaged") == "$damage" ]] || fail "$damage is lost" ;;
        *) [[ $(state 's.set_aside') == "" ]] || fail "$damage is set aside" ;;
    esac
    xdotool key Return
    until_state 's.lesson === "sphere-ritter" && s.step === 0'
    close_window
done

# Two windows at once keep what was done in both: the first one writes last.
rm -f "$kept"
opened='s.handles.length > 0'
open_window --lesson sphere-ritter
first=$pid first_window=$window first_state=$SNUG_STATE
export SNUG_STATE=$work/second.json
open_window --lesson sphere-welzl
xdotool key Right
until_state 's.step === 1'
close_window
pid=$first
export SNUG_STATE=$first_state
xdotool windowfocus --sync "$first_window" 2>/dev/null || true
xdotool key Right
until_state 's.step === 1'
close_window
node -e 'const kept = JSON.parse(require("fs").readFileSync(process.argv[1])).lessons;
if (kept["sphere-ritter"]?.step !== 1 || kept["sphere-welzl"]?.step !== 1) throw Error(JSON.stringify(kept))' "$kept" ||
    fail "one window destroyed what the other kept"
