# The prose speaks to the stage in the window: a mark lights while it is pointed at, a handle lights its words, a link
# chooses an algorithm, and the section follows the step and the question.
. tests/desktop/support.sh
open_window --lesson sphere-welzl
xdotool key Home
until_state 's.step === 0 && s.section === -1'
for i in 1 2 3 4 5 6 7 8; do xdotool key End s; done
until_state 's.step === s.steps'

link() { state "const l = s.links.find(l => l.to === '$1'); Math.round(l.x) + ' ' + Math.round(l.y)"; }
point_at() { xdotool mousemove --window "$window" "$1" "$2" sleep 0.2 mousemove --window "$window" $(($1 + 1)) "$2"; }

# Scrolled to its beginning: the support set is spoken of in the first section.
xdotool mousemove --window "$window" 150 400
for i in $(seq 30); do xdotool click 4; done
last=
until [[ $(link support) == "$last" ]]; do last=$(link support) && sleep 0.3; done
point_at $last
until_state 's.lit.mark === "support"'

# On the stage one of its points is hovered, and the words are lit.
last=
until [[ $(handle P1) == "$last" ]]; do last=$(handle P1) && sleep 0.3; done
point_at $last
until_state 's.lit.mark === "" && s.lit.words.includes("support")'

# A section is the step's.
xdotool key Escape Home
until_state 's.step === 0'
xdotool key Right
until_state 's.step === 1 && s.section === 1'

# A link acts. The pointer is over the prose: it does not scroll away.
xdotool mousemove --window "$window" 150 400
for i in $(seq 60); do # until it is well on the stage's height
    [[ $(link pivot | cut -d ' ' -f 2) -lt 600 ]] && break
    xdotool click 5
    sleep 0.1
done
last=
until [[ $(link pivot) == "$last" ]]; do last=$(link pivot) && sleep 0.3; done
point_at $last
sleep 0.2
xdotool click 1
until_state 's.algorithm === "pivot"'
kill "$pid" && wait "$pid" 2>/dev/null || true

# A link leads to another lesson, which is read from its beginning.
open_window --lesson sphere-iterative
xdotool mousemove --window "$window" 150 400 sleep 0.3
for i in $(seq 20); do # on a busy machine the window may not have seen yet where the mouse is
    xdotool click 5 sleep 0.3
    [[ $(state 's.scrolled > 0') != true ]] || break
done
until_state 's.scrolled > 0'
point_at $(link sphere-ritter)
sleep 0.2
xdotool click 1
until_state 's.lesson === "sphere-ritter" && s.scrolled === 0'
kill "$pid" && wait "$pid" 2>/dev/null || true

# The figures of the run in the prose follow a drag, and are hidden while a question is open.
open_window --lesson sphere-ritter
xdotool mousemove --window "$window" 150 400
for i in $(seq 40); do xdotool click 5; done
until_state 's.figuresDrawn.length === 7 && s.figuresDrawn.every((text) => /^[+]?[0-9.]+/.test(text))'
before=$(state 's.figuresDrawn.join()')
last=
until [[ $(handle P3) == "$last" ]]; do last=$(handle P3) && sleep 0.3; done
read -r x y <<<"$last"
xdotool mousemove --window "$window" "$x" "$y" sleep 0.3 mousedown 1 sleep 0.2 mousemove --window "$window" $((x + 40)) $((y - 90)) sleep 0.3 mousemove --window "$window" $((x + 60)) $((y - 150)) sleep 0.3 mouseup 1
until_state "s.figuresDrawn.join() !== '$before'"
until_state 's.figuresDrawn[4].startsWith(s.readout.radius.toFixed(3))'
xdotool key Home Page_Down
until_state 's.asked && s.figuresDrawn.every((text) => text === "…")'
