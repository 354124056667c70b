# How a volume is stored stands beside the stage in the window: its numbers follow a drag, a member that is pointed at is
# lit, and the numbers of the test are a tab beside it.
. tests/desktop/support.sh
open_window --lesson aabb
until_state 's.storedRows.length === 8'

last=
until [[ $(handle A3) == "$last" ]]; do last=$(handle A3) && sleep 0.3; done
row() { state "const r = s.storedRows.find(r => r.mark === 'stored:A/$1'); Math.round(r.x) + ' ' + Math.round(r.y)"; }
point_at() { xdotool mousemove --window "$window" "$1" "$2" sleep 0.2 mousemove --window "$window" $(($1 + 1)) "$2"; }

# A member is lit while it is pointed at.
point_at $(row 0/1)
until_state 's.lit.mark === "stored:A/0/1"'
point_at $(row 1/1)
until_state 's.lit.mark === "stored:A/1/1"'
point_at $(handle B)
until_state 's.lit.mark === ""'

# A drag of the centre: min and max follow, widths stay.
before=$(state 's.storedRows.map(r => r.text).join(";")')
center=$(handle A)
xdotool mousemove --window "$window" $center mousedown 1
xdotool mousemove --window "$window" $((${center% *} + 40)) $((${center#* } + 30)) sleep 0.3 mouseup 1
until_state "s.storedRows.map(r => r.text).join(';') !== '$before'"
text() { state "s.storedRows.find(r => r.mark === 'stored:A/$1').text"; }
[[ $(text 1/1) == 2.000 && $(text 1/2) == 1.000 ]] || fail "a width has changed: $(text 1/1), $(text 1/2)"
[[ $before != *"$(text 0/0)"* ]] || fail "min has stayed: $(text 0/0)"
close_window

# A lesson that asks for nothing has none.
open_window --lesson swept-overlap
until_state 's.storedRows.length === 0'
