# A lecture on usual screens: what its buttons, the sentence, the controls and the timeline leave free of the stage is at
# least half as high as the screen, with two rows of controls as well, and while a question stands.
. tests/desktop/support.sh
opened='s.lesson !== null'
controls() { # situations, whether it has sliders; a lesson without questions, whose cards would have the sentence's place and more
    (($1 == 0)) || echo 'situation_title = "The first of several situations"'
    cat <<'TOML'
version = 2
title = "Controls"
summary = "A lesson for tests."
minutes = 1
volume = "sphere"
algorithms = ["ritter"]
[points]
list = [[-1, 0], [1, 0.2], [0.3, 1], [0.1, -0.7]]
TOML
    for i in $(seq "$1"); do
        printf '[[situation]]\nname = "other-%s"\ntitle = "A situation, number %s"\n' "$i" "$i"
        printf '[situation.points]\nlist = [[-1, 0], [1, 0.%s], [0, 1]]\n' "$i"
    done
    if (($2 > 0)); then
        printf '[[slider]]\ntitle = "Angle"\ndrives = "angle"\nfrom = 0\nto = 90\n'
        printf '[[slider]]\ntitle = "Size"\ndrives = "scale"\nfrom = 0.5\nto = 1\nstart = 1\n'
    fi
    printf '[[section]]\ntitle = "First"\ntext = "A **term**."\n'
}
for of in '0 0' '2 0' '2 1'; do # no row of controls, one, two
    controls $of >"$work/controls.toml"
    open_window "$work/controls.toml"
    xdotool key F5
    until_state 's.presenting && s.mistakes.length === 0'
    for size in 1280x720 1366x768 1280x800 1920x1080; do
        xdotool windowsize --sync "$window" "${size%x*}" "${size#*x}"
        until_state "s.height === ${size#*x} && s.freeHeight >= s.height / 2"
    done
    close_window
done
open_window epsilons --question unit-size
xdotool key F5
until_state 's.presenting && s.asked !== null'
for size in 1280x720 1366x768; do
    xdotool windowsize --sync "$window" "${size%x*}" "${size#*x}"
    until_state "s.height === ${size#*x} && s.asked !== null && s.freeHeight >= s.height / 2"
done
close_window
