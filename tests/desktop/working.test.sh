# Many points go on the stage in pieces: the window answers meanwhile and says how far, Escape leaves all as it was, and
# another try gets there.
. tests/desktop/support.sh
node -e '
let seed = 1;
const next = () => ((seed = (seed * 48271) % 2147483647) / 2147483647 - 0.5);
for (let i = 0; i < 25000; ++i) console.log(next() + next(), next() + next(), next() + next());' >"$work/many.xyz"
opened='s.preparing?.says.startsWith("Working on 25,000 points") && s.points < 1000' \
    open_window --lesson kdop-space --points "$work/many.xyz"
xdotool key Escape
until_state 's.preparing === null'
[[ $(state 's.notice') == "Cancelled: all is as it was." ]] || fail "it says $(state 's.notice')"
[[ $(state 's.points < 1000') == true ]] || fail "what was cancelled is on the stage"
close_window

opened='s.preparing !== null' open_window --lesson kdop-space --points "$work/many.xyz"
while [[ $(state 's.preparing !== null') == true ]]; do
    for i in $(seq 20); do xdotool mousemove --window "$window" $((300 + i)) 300; done
done
(($(state 's.frames_beside') > 0)) || fail "the window did not follow the mouse while a thread had the session"
for i in 1 2 3; do # what one wait does not see, a busy machine has not done yet
    (until_state 's.preparing === null && s.points === 25000') 2>/dev/null && break
done
until_state 's.preparing === null && s.points === 25000'
