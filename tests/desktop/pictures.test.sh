# Pictures for slides and papers: finer, without a ground, as SVG with words as text, as an animation; each with its address.
. tests/desktop/support.sh
draw() { "$snug" render "$@"; }
draw sphere-ritter --step 6 --size 600x400 --stage --scale 4 -o "$work/four.png"
[[ $(identify -format '%wx%h' "$work/four.png") == 2400x1600 ]] || fail "not four times as fine"
[[ $(identify -format '%[Source]' "$work/four.png") == '?lesson=sphere-ritter&seed='*'&step=6' ]] || fail "no address in the PNG"
draw sphere-ritter --step 6 --size 600x400 --stage --transparent -o "$work/clear.png"
[[ $(identify -format '%[channels]' "$work/clear.png") == *a* ]] || fail "no opacity"
share=$(convert "$work/clear.png" -alpha extract -format '%[fx:100*mean]' info:)
node -e "process.exit($share > 0.5 && $share < 40 ? 0 : 1)" || fail "$share % of the picture is not clear"
draw sphere-ritter --step 6 --size 600x400 --stage --no-labels -o "$work/bare.png"
draw sphere-ritter --step 6 --size 600x400 --stage -o "$work/named.png"
[[ $(compare -metric AE "$work/bare.png" "$work/named.png" null: 2>&1) != 0 ]] || fail "the labels stay"

# A plane, a mesh in space, and a frustum: as another program draws them, they are what the picture shows.
for lesson in sphere-ritter obb-pca sphere-pca; do
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
refused "at most 500 steps" --steps 0-9999 -o "$work/no.gif"
refused "there is no step 400" --steps 0-400 -o "$work/no.gif"
[[ -z $(find "$work" -name 'no.*') ]] || fail "something was written all the same"
