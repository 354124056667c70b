# The gallery of hard cases stands under the course: keys go through it and open a case, and so does its name.
. tests/desktop/support.sh
opened='s.lesson === null'

open_window
until_state 's.cases.length >= 25'
[[ $(state 's.found.length === s.course.length') == true ]] || fail "cases are counted as lessons"
xdotool key End
until_state 's.chosen === s.course.length + s.sheets.length + s.cases.length - 1'
xdotool key Return
until_state 's.lesson === "wide-box" && s.step === 0'
xdotool key F2
until_state 's.lesson === null'
[[ $(state 's.lead') == "Start here" ]] || fail "a case is taken for a lesson begun: $(state 's.lead')"
close_window

opened='s.lesson === "twins"'
open_window twins
until_state 's.algorithm === "welzl_naive"'
close_window
