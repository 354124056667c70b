# What was measured is saved under a name that is not there yet, which is told; without a folder that is told as well.
. tests/desktop/support.sh
snug=$(realpath "$snug")
mkdir "$work/own" && cd "$work/own"
opened="s.lesson === 'cost-chart'" open_window --lesson cost-chart # an empty chart has no handles
xdotool key ctrl+s
until_state '/nothing has been measured/.test(s.notice)'
xdotool key Escape
xdotool key m # it asks first
sleep 0.2
for question in 1 2 3; do xdotool key s; sleep 0.2; done
xdotool key m
for i in 1 2 3; do
    (until_state '/on the front/.test(s.caption)') 2>/dev/null && break
done
until_state '/on the front/.test(s.caption) && s.handles.length === 6' # until then each round moves the times
for name in snug-costs.csv snug-costs-2.csv snug-costs-3.csv; do
    xdotool key ctrl+s
    until_state "s.notice === 'Saved as $work/own/$name.'"
    [[ -s $name ]] || fail "no $name"
done
cp snug-costs.csv "$work/first.csv"
cmp "$work/first.csv" snug-costs-2.csv || fail "the same result saved twice differs"
xdotool key Escape
choose File "Export table …"
type_path table.json
until_state "s.notice === 'Saved as table.json.'"
node -e 'if (JSON.parse(require("fs").readFileSync("table.json")).rows.length !== 6) throw Error("rows")' || fail "the table is not whole"
rm -r "$work/own"
xdotool key ctrl+s
until_state '/^Not saved: the folder that Snug was started in is no longer there/.test(s.notice)'
kill -0 "$pid" || fail "it is gone"
cd /
