# All of the window by keyboard: Tab goes from control to control, each with its name, Enter presses; links of the prose
# light their marks and act; a menu has the keyboard alone and gives it back; a card has it first.
. tests/desktop/support.sh
open_window --lesson sphere-welzl
xdotool mousemove --window "$window" 640 300
[[ $(state 's.focus') == "" ]] || fail "the keyboard is somewhere at the start"
xdotool key Tab
until_state 's.focus === "Snug, the course"'

# Links of the prose, by their words.
xdotool key Home # the result that it opens on is left
until_state 's.step === 0'
for i in 1 2 3 4 5 6 7 8; do xdotool key End s; done
until_state 's.step === s.steps'
xdotool key Escape # the summary
tab_to "support set"
until_state 's.lit.mark === "support"'
xdotool key Down
until_state 's.focus !== "support set" && s.focus !== ""'
xdotool key Up
until_state 's.focus === "support set"'
xdotool key Right # the player's keys stay
xdotool key Left
until_state 's.step === s.steps - 1 && s.focus === "support set"'
before=$(state 's.scrolled')
for i in $(seq 20); do xdotool key Down; sleep 0.1; done # beyond the last link it scrolls
until_state "s.scrolled > $before"
xdotool key Escape
until_state 's.focus === "" && s.lit.mark === ""'

# A menu has the keyboard alone. A key that comes between two slow frames may be lost: it is pressed again.
title="Welzl's algorithm and the support set" next="Welzl's recursion, as printed"
focus_comes() { # name: whether the keyboard is there within three seconds
    local i
    for i in $(seq 30); do
        [[ $(state 's.focus') == "$1" ]] && return
        sleep 0.1
    done
    return 1
}
menu_to_next() {
    local try
    for try in 1 2 3; do
        tab_to "$title"
        xdotool key Return sleep 1 key Down
        focus_comes "$next" && return
        xdotool key Escape sleep 0.5
    done
    fail "the menu's next entry never had the keyboard, $(state 's.focus') has it"
}
menu_to_next
xdotool key Escape
focus_comes "$title" || { xdotool key Escape && tab_to "$title"; }
menu_to_next
xdotool key Return
until_state 's.lesson === "welzl-recursion"'
kill "$pid" && wait "$pid" 2>/dev/null || true
rm -f "$SNUG_STATE"

# A question's card comes first; what is chosen is given by its button, and its successor has the keyboard.
open_window --lesson scene-broad
xdotool key Right
until_state 's.asked !== null'
choice=$(state 's.asked.choices[0]')
xdotool key Tab
until_state "s.focus === '$choice'"
xdotool key Tab
until_state "s.focus === s.asked.choices[1]"
xdotool key space # which chooses it, and does not play
until_state 's.asked.says.endsWith("Choose it again or press Enter to answer.") && s.step === 0'
tab_to Answer
xdotool key Return
until_state 's.outcome !== null || s.asked.says.startsWith("Not that one. Try once more.")'
if [[ $(state 's.asked !== null') == true ]]; then
    tab_to Skip
    xdotool key Return
fi
until_state 's.outcome !== null && s.focus === "Continue"'
xdotool key Return
until_state 's.outcome === null'
xdotool key s # the next question is skipped
until_state 's.outcome !== null'
xdotool key Return
until_state 's.outcome === null && s.asked === null'

# The settings' sizes and themes, and the step by its button.
tab_to Settings
xdotool key Return
until_state 's.focus === "Text size: 100 %"'
xdotool key Return
until_state 's.focus === "Text size: 115 %"'
xdotool key Escape
until_state 's.focus === "Settings"'
tab_to "To the end"
