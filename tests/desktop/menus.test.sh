# The menus, by mouse and by keys: points are saved, opened and copied, nothing is replaced without asking, what was
# opened is remembered; Tab comes to every control of the window and back; the path is typed where no portal runs.
. tests/desktop/support.sh
snug=$(realpath "$snug")
unset DBUS_SESSION_BUS_ADDRESS
export XDG_RUNTIME_DIR=$work/no-bus
mkdir "$work/own" && cd "$work/own"
printf '0 0\n4 0\n4 3\n' >three.xyz

choose() { # menu item
    tab_to "$1 menu"
    xdotool key Return
    sleep 0.5
    tab_to "$2" Down
    xdotool key Return
    sleep 0.3
}
type_path() { # path
    until_state 's.asks_path'
    sleep 0.5
    xdotool key ctrl+a
    xdotool type --delay 40 "$1"
    xdotool key Return
}

open_window --lesson sphere-ritter
xdotool key F10
until_state 's.focus === "File menu"'
# Tab goes through everything, each control with a name, and comes back to where it began.
first=$(state 's.focus')
: >"$work/names"
for i in $(seq 90); do
    xdotool key Tab
    sleep 0.12
    name=$(state 's.focus')
    [[ -n $name ]] || fail "a control has no name, after $(tail -n 1 "$work/names")"
    echo "$name" >>"$work/names"
    [[ $name == "$first" ]] && break
done
[[ $name == "$first" ]] || fail "Tab never came back to $first"
for name in "Edit menu" "View menu" "Lesson menu" "Help menu" Keys Present Settings "Snug, the course" "To the end" Play; do
    grep -qx "$name" "$work/names" || fail "Tab never came to $name: $(tr '\n' '|' <"$work/names")"
done

xdotool key Escape sleep 0.2 key ctrl+o
type_path three.xyz
until_state 's.points === 3 && !s.asks_path'
xdotool key Escape
choose File "Save points …"
type_path three.xyz # is there already
until_state 's.asks_path && s.replaces'
[[ $(<three.xyz) == $'0 0\n4 0\n4 3' ]] || fail "a file was replaced without asking"
xdotool key Escape
until_state '!s.asks_path'
choose File "Save points …"
type_path saved.xyz
until_state 's.notice.startsWith("Saved as")'
[[ $(<saved.xyz) == $'0 0\n4 0\n4 3' ]] || fail "saved: $(<saved.xyz)"
xdotool key Escape
choose File "Save picture …"
type_path stage.png
until_state 's.notice.startsWith("Saved as")'
[[ $(identify -format %m stage.png) == PNG ]] || fail "there is no picture"
xdotool key Escape sleep 0.3 key ctrl+c
until_state 's.notice === "Copied: 3 points."'
[[ $(xclip -selection clipboard -o) == $'0\t0\n4\t0\n4\t3' ]] || fail "copied: $(xclip -selection clipboard -o)"
printf '1,5\t2\n' | xclip -selection clipboard -loops 0 >/dev/null 2>&1
xdotool key Escape sleep 0.3 key ctrl+v
until_state '/decimal/.test(s.notice) && s.points === 3'
xdotool key Escape sleep 0.3 key ctrl+q
for i in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
! kill -0 "$pid" 2>/dev/null || fail "Ctrl Q does not quit"
wait "$pid" || fail "it ended with an error"
rm -f "$SNUG_STATE"

open_window --lesson sphere-welzl # what was opened is in the menu
choose File three.xyz
until_state 's.points === 3'
close_window
