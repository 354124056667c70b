# The lab sheets, done as a new student would: a measurement, an example and written answers go into one file, which
# snug grade reads; all of it is kept until then.
. tests/desktop/support.sh
snug=$(realpath "$snug")
mkdir "$work/own" && cd "$work/own"

write_into() { # field words
    tab_to "$1"
    sleep 0.3
    xdotool type --delay 40 "$2"
    sleep 0.5
}

open_window --lesson break-float
until_state 's.sheet.sheet === "break-float" && Object.keys(s.sheet.built).length === 0'
printf '0\t0\n1\t1\n' | xclip -selection clipboard -loops 0 >/dev/null 2>&1
xdotool key Escape sleep 0.3 key ctrl+v # from a spreadsheet
until_state 's.points === 2'
until_state 's.sheet.built[1] === "b0,0;1,1@0.0"'
tab_to "Hand in"
xdotool key Return
write_into "Answer 1" "The square root."
xdotool key Tab type --delay 0 "aa It has room." # at once: behind the Tab nothing is lost, and no letter is a command
until_state 's.sheet.written.double === "aa It has room." && s.sheet.written.where === "The square root."'
write_into "Your name" "Ada"
until_state 's.sheet.written.where === "The square root."'
close_window

open_window --lesson break-float # as it was left
until_state 's.sheet.written.where === "The square root." && s.sheet.built[1] === "b0,0;1,1@0.0"'
tab_to "Hand in"
xdotool key Return sleep 0.5
tab_to "Your name"
tab_to "Hand in"
xdotool key Return
until_state 's.notice.startsWith("Saved as") && s.notice.includes("1 of 4 parts is missing.")'
"$snug" grade break-float.json >graded || fail "it is graded: $(cat graded)"
grep -q 'Ada  *break-float  *1  *1  *ok$' graded || fail "it is graded: $(cat graded)"
grep -q 'Example of 2 points' graded || fail "the example is not judged: $(cat graded)"
grep -q 'The square root\.' graded || fail "the answer is not printed: $(cat graded)"
xdotool key Escape
choose File "Hand in" # from the menu, and nothing is overwritten
until_state 's.notice.startsWith("Saved as") && s.notice.includes("break-float-2.json")'
close_window

opened='s.lesson === "break-even"' open_window --lesson break-even # a measurement
xdotool key m # it asks first
until_state 's.asked !== null'
xdotool key s
until_state 's.asked === null'
xdotool key m
for i in 1 2 3; do
    (until_state 's.sheet.measured.body?.table.rows.length === 4') 2>/dev/null && break
done
until_state 's.sheet.measured.body?.table.rows.length === 4 && /^20\d\d-/.test(s.sheet.measured.body.date)'
close_window
node -e 'const kept = JSON.parse(require("fs").readFileSync(process.argv[1]));
if (kept.student !== "Ada" || kept.sheets["break-even"].measured.body.table.table !== "which") throw Error(JSON.stringify(kept))' \
    "$work/snug/course.json" || fail "what was measured is not kept"

# Another day: the table is shown again, with the day and the machine, until something is measured in its place.
sed -i 's/"date": "20[0-9-]*"/"date": "2026-01-02"/' "$work/snug/course.json"
open_window --lesson break-even
until_state '/^Measured on 2026-01-02, on .+, by .+, native, GNU .+\. Measure again to replace it\.$/.test(s.measured_before)'
xdotool key m # it asks again, and the table would tell
until_state 's.asked !== null && s.measured_before === null'
xdotool key s
until_state 's.asked === null'
xdotool key m
for i in 1 2 3; do
    (until_state 's.sheet.measured.body.date !== "2026-01-02"') 2>/dev/null && break
done
until_state 's.sheet.measured.body.date !== "2026-01-02" && s.measured_before === null'

# The keyboard comes to a field that is out of view, and what is typed there is an answer.
tab_to "Hand in"
xdotool key Return
write_into "Answer 4" "never"
until_state 's.sheet.written.never === "never"'

# Two windows on a sheet keep what was written in either.
write_answer() { # field words part
    tab_to "Hand in"
    xdotool key Return
    write_into "$1" "$2"
    until_state "s.sheet.written.$3?.includes('$2')"
    sleep 1
    close_window
}
open_window --lesson break-float
first=$pid first_window=$window first_state=$SNUG_STATE
export SNUG_STATE=$work/second.json
open_window "$OLDPWD/lessons/labs/break-float.toml" # its file is the sheet as well
write_answer "Answer 2" "Of the second." double
export SNUG_STATE=$first_state
pid=$first window=$first_window
xdotool windowfocus --sync "$window" 2>/dev/null || true
write_answer "Answer 1" "Of the first." where
node -e 'const { written } = JSON.parse(require("fs").readFileSync(process.argv[1])).sheets["break-float"];
if (!written.where.includes("first") || !written.double.includes("second")) throw Error(JSON.stringify(written))' \
    "$work/snug/course.json" || fail "one window destroyed what the other kept"
