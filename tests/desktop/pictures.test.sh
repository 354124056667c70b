# Pictures for slides and papers: finer, without a ground, as SVG with words as text, as an animation; each with its
# address; by the command and by the window's card.
. tests/desktop/support.sh
draw() { "$snug" render "$@"; }
draw sphere-ritter --step 6 --size 600x400 --stage --scale 4 -o "$work/four.png"
[[ $(identify -format '%wx%h' "$work/four.png") == 2400x1600 ]] || fail "not four times as fine"
[[ $(identify -format '%[Source]' "$work/four.png") == '?lesson=sphere-ritter&step=6&seed='* ]] || fail "no address in the PNG"
draw sphere-ritter --step 6 --size 600x400 --stage --transparent -o "$work/clear.png"
[[ $(identify -format '%[channels]' "$work/clear.png") == *a* ]] || fail "no opacity"
share=$(convert "$work/clear.png" -alpha extract -format '%[fx:100*mean]' info:)
node -e "process.exit($share > 0.5 && $share < 40 ? 0 : 1)" || fail "$share % of the picture is not clear"
draw sphere-ritter --step 6 --size 600x400 --stage --no-labels -o "$work/bare.png"
draw sphere-ritter --step 6 --size 600x400 --stage -o "$work/named.png"
[[ $(compare -metric AE "$work/bare.png" "$work/named.png" null: 2>&1) != 0 ]] || fail "the labels stay"

# A stage of each kind: as another program draws it, it is what the picture shows.
for lesson in sphere-ritter obb-pca sphere-pca frustum-2d bvh-build scene-broad obb-axes; do
    draw "$lesson" --step 4 --size 800x600 --stage --theme light -o "$work/$lesson.png"
    draw "$lesson" --step 4 --size 800x600 --stage --theme light -o "$work/$lesson.svg"
    rsvg-convert "$work/$lesson.svg" -o "$work/$lesson-svg.png"
    grep -q '<text ' "$work/$lesson.svg" || fail "$lesson: no words"
    grep -q "<metadata>?lesson=$lesson&amp;" "$work/$lesson.svg" || fail "$lesson: no address"
    # compare says by its status that they differ
    apart=$( (compare -metric MAE "$work/$lesson.png" "$work/$lesson-svg.png" null: 2>&1 || true) | sed 's/.*(\(.*\))/\1/')
    node -e "process.exit($apart < 0.02 ? 0 : 1)" || fail "$lesson: SVG and PNG differ by $apart"
done

draw sphere-ritter --steps 2-5 --size 400x300 --stage --pause 0.25 -o "$work/steps.gif"
[[ $(identify -format '%T ' "$work/steps.gif") == '25 25 25 63 ' ]] || fail "other pauses: $(identify -format '%T ' "$work/steps.gif")"
[[ $(identify -format '%c' "$work/steps.gif[0]") == '?lesson=sphere-ritter'* ]] || fail "no address in the GIF"
[[ $(compare -metric AE "$work/steps.gif[0]" "$work/steps.gif[3]" null: 2>&1) != 0 ]] || fail "nothing moves"

refused() { # what is said, arguments...
    local says=$1 status=0 said
    shift
    said=$("$snug" render sphere-ritter "$@" 2>&1) || status=$?
    ((status == 2)) && [[ $said == snug:*"$says"* && $(wc -l <<<"$said") == 1 ]] || fail "$*: $status, $said"
}
refused "an SVG is of the stage alone: add --stage" -o "$work/no.svg"
refused "the name must end in .gif" --steps 1-2 -o "$work/no.png"
refused "says which" -o "$work/no.gif"
refused "an animation keeps its ground" --steps 1-2 --stage --transparent -o "$work/no.gif"
refused "at most 500 steps" --steps 0-9999 -o "$work/no.gif"
refused "there is no step 400" --steps 0-400 -o "$work/no.gif"
[[ -z $(find "$work" -name 'no.*') ]] || fail "something was written all the same"

# A chart, from a table of costs.
"$snug" cost --generate cube:200 --csv >"$work/cost.csv" 2>/dev/null
"$snug" chart "$work/cost.csv" --size 600x400 --scale 2 --transparent -o "$work/chart.png"
[[ $(identify -format '%wx%h' "$work/chart.png") == 1200x800 ]] || fail "the chart is not twice as fine"
share=$(convert "$work/chart.png" -alpha extract -format '%[fx:100*mean]' info:)
node -e "process.exit($share > 0.5 && $share < 40 ? 0 : 1)" || fail "$share % of the chart is not clear"
"$snug" chart "$work/cost.csv" --size 600x400 --theme dark -o "$work/dark.png"
"$snug" chart "$work/cost.csv" --size 600x400 --theme light -o "$work/light.png"
[[ $(compare -metric AE "$work/light.png" "$work/dark.png" null: 2>&1) != 0 ]] || fail "a dark chart is a light one"

# The window's card: as fine, as clear and in what colours one wants; steps as an animation.
snug=$(realpath "$snug")
mkdir "$work/own" && cd "$work/own"
save_picture() {
    xdotool key F10
    until_state 's.focus === "File menu"'
    xdotool key Return sleep 0.5
    tab_to "Save picture …" Down
    xdotool key Return
    until_state 's.asks_path'
    sleep 0.5
}
press() { # button...
    local name
    for name in "$@"; do
        tab_to "$name"
        xdotool key Return sleep 0.3
    done
}
open_window --lesson sphere-ritter --step 6
save_picture
press 4x Dark "Without names" Transparent Save
until_state 's.notice.startsWith("Saved as")'
width=$(identify -format '%w' sphere-ritter.png)
((width % 4 == 0 && width > 1600)) || fail "it is $width wide"
[[ $(identify -format '%[channels]' sphere-ritter.png) == *a* ]] || fail "no opacity in the window's picture"
[[ $(identify -format '%[Source]' sphere-ritter.png) == *'?lesson=sphere-ritter&step=6&'* ]] || fail "no address"
xdotool key Escape
until_state 's.notice === ""'
save_picture
press GIF
tab_to "Steps, the first and the last"
xdotool key ctrl+a
xdotool type --delay 40 2-4
press Save
until_state 's.notice.startsWith("Saved as") && s.step === 6'
[[ $(identify -format '%T ' sphere-ritter-2.gif) == '80 80 200 ' ]] || fail "$(identify -format '%T ' sphere-ritter-2.gif)"
close_window
