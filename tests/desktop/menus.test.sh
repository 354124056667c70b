# The menus, by mouse and by keys: points are saved, opened and copied, nothing is replaced without asking, what was
# opened is remembered; Tab comes to every control of the window and back; the path is typed where no portal runs, and
# chosen in the desktop's own dialog where one does.
. tests/desktop/support.sh
snug=$(realpath "$snug")
if [[ ${1:-} == portal ]]; then # it calls itself on a bus of its own
    folder=$work/a\ folder
    mkdir "$folder"
    printf '0 0\n4 0\n4 3\n' >"$folder/three.xyz"
    asked() { tail -n 1 "$work/asked" 2>/dev/null | node -e 'a = JSON.parse(require("fs").readFileSync(0)); console.log(eval(process.argv[1]))' "$1"; }
    until_asked() { # what is true of the dialog that was asked for last
        local i
        for i in $(seq 100); do [[ $(asked "$1" 2>/dev/null) == true ]] && return || sleep 0.1; done
        fail "never asked: $1, but $(cat "$work/asked")"
    }
    answer() { echo "$1" >"$work/new" && mv "$work/new" "$work/answer"; }

    cd "$folder"
    open_window --lesson sphere-ritter # nobody answers on this bus: a path is typed
    xdotool key ctrl+o
    until_state 's.asks_path && !s.dialog'
    close_window

    /usr/bin/python3 "$OLDPWD/tests/desktop/fake_portal.py" "$work" &
    until_asked 'a.method === "ready"'
    open_window --lesson sphere-ritter
    xdotool key ctrl+o
    until_asked 'a.method === "OpenFile" && a.title === "Open points"'
    until_state 's.dialog && !s.asks_path'
    [[ $(asked 'a.filters[0].join(" ")') == "*.ply *.PLY *.stl *.STL"* && $(asked 'a.filters[1][0]') == "*" ]] || fail "shown: $(asked a.filters)"
    step=$(state s.step)
    xdotool key Left # the window answers meanwhile
    until_state "s.step !== $step"
    xdotool key ctrl+o # another one takes its place
    until_asked 'a.method === "OpenFile"'
    grep -q '"Close"' "$work/asked" || fail "the first dialog was left open"
    answer "$folder/three.xyz"
    until_state '!s.dialog && !s.asks_path && s.points === 3'
    xdotool key ctrl+o
    until_state 's.dialog'
    answer cancel
    until_state '!s.dialog && !s.asks_path && s.points === 3 && s.notice === ""'
    choose File "Save points …"
    until_asked 'a.method === "SaveFile" && a.name === "points.xyz" && a.folder.endsWith("a folder\0")'
    answer "$folder/saved é.csv" # of the two formats the name says which; the dialog itself asks before it replaces
    until_state 's.notice.startsWith("Saved as")'
    [[ $(<"saved é.csv") == $'0,0\n4,0\n4,3' ]] || fail "saved: $(cat ./*.csv)"
    xdotool key Escape sleep 0.3 key ctrl+o
    until_state 's.dialog'
    answer fail # a portal that cannot show it
    until_state '!s.dialog && s.asks_path'
    exit
fi
cat >"$work/bus.conf" <<END # where nothing starts by itself
<busconfig><type>session</type><listen>unix:tmpdir=/tmp</listen><policy context="default"><allow send_destination="*"/>
<allow receive_sender="*"/><allow own="*"/></policy></busconfig>
END
SNUG=$snug dbus-run-session --config-file="$work/bus.conf" -- bash "${BASH_SOURCE[0]}" portal
unset DBUS_SESSION_BUS_ADDRESS
export XDG_RUNTIME_DIR=$work/no-bus
mkdir "$work/own" && cd "$work/own"
printf '0 0\n4 0\n4 3\n' >three.xyz

open_window --lesson sphere-ritter
xdotool key F10
until_state 's.focus === "File menu"'
# Tab goes through everything, each control with a name, and comes back to where it began.
first=$(state 's.focus')
: >"$work/names"
for i in $(seq 90); do
    before=$(state 's.focus')
    xdotool key Tab
    for j in $(seq 40); do # a slow frame must not pass over a control
        name=$(state 's.focus')
        [[ $name == "$before" ]] || break
    done
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
xdotool key Escape
choose Edit "Copy picture"
until_state 's.notice === "The picture is on the clipboard."'
[[ $(xclip -selection clipboard -t image/png -o | identify -format %m -) == PNG ]] || fail "no picture is on the clipboard"
xdotool key Escape key F1
# The card of keys has those of the menus, of the commands and of the window.
until_state '["Ctrl O", "Ctrl C", "Ctrl V", "Ctrl Q", "F1", "F2", "F5", "F10", "F11", "Space", "Tab  Shift Tab"].every((key) => s.keys.includes(key))'
xdotool key Escape
until_state 's.keys.length === 0'
choose Help "About Snug"
until_state '/^Dear ImGui \d.*GLFW 3\..*OpenGL \d.* by ./.test(s.about)'
xdotool key Escape sleep 0.3 key ctrl+q
for i in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
! kill -0 "$pid" 2>/dev/null || fail "Ctrl Q does not quit"
wait "$pid" || fail "it ended with an error"
rm -f "$SNUG_STATE"

open_window --lesson sphere-welzl # what was opened is in the menu
choose File three.xyz
until_state 's.points === 3'

printf '1 1\n2 5\n' >"two points.xyz" # files are dropped: one is taken, and the other is told
/usr/bin/python3 "$OLDPWD/tests/desktop/drop.py" "$window" "two points.xyz" three.xyz
until_state 's.points === 2 && s.notice === "two points.xyz is open. One file is taken at a time; not opened: three.xyz."'
xdotool key Escape sleep 0.3 key F2
until_state 's.lesson === null'
printf '0 0 0\n4 0 0\n4 3 0\n1 1 2\n' >four.xyz
choose File "Open points …" # from the course: in the lesson that `snug four.xyz` opens
type_path four.xyz
until_state 's.lesson === "which-volume" && s.points === 4'
"$snug" lesson new mine --lessons . >/dev/null # a lesson's file opens in a window of its own
choose File "Open lesson …"
type_path mine.toml
until_state 's.lesson === "mine"'
own=$(pgrep -P "$pid")
kill "$own"
close_window
