# snug chart: a picture of each table that snug cost writes, in every theme and on a phone; wrong files in one line.
. tests/desktop/support.sh
"$snug" cost --generate gaussian:300 --volume obb --repeat 3 --csv -o "$work/costs.csv"
"$snug" cost --generate gaussian:300 --volume obb --repeat 3 --json -o "$work/costs.json"
"$snug" cost --generate cube:1000 --growth --algorithms ritter,welzl --repeat 3 --csv -o "$work/growth.csv"
"$snug" cost --generate cube:1000 --growth --algorithms ritter,welzl --repeat 3 --json -o "$work/growth.json"
"$snug" cost --generate cube:50 --turn --repeat 3 --csv -o "$work/turn.csv"

drawn() { # picture size...
    [[ $(identify -format '%wx%h' "$1") == "$2" ]] || fail "$1: another size"
    ((  $(identify -format '%k' "$1") > 50 )) || fail "$1: next to nothing is drawn"
}
for theme in light dark contrast projector; do
    SNUG_THEME=$theme "$snug" chart "$work/costs.csv" --size 1280x800 -o "$work/$theme.png"
    drawn "$work/$theme.png" 1280x800
done
for table in costs.csv costs.json growth.csv growth.json turn.csv; do
    "$snug" chart "$work/$table" --size 390x844 -o "$work/$table.png"
    drawn "$work/$table.png" 390x844
done
# The front and the proven optimum have their colours.
for color in '#0A5FBF' '#007A5A'; do
    convert "$work/light.png" -fill white +opaque "$color" -format '%k' info: | grep -qx 2 || fail "no $color"
done
# What lies over it adds to it.
"$snug" chart "$work/costs.csv" --against "$work/costs.json" --size 1280x800 -o "$work/both.png"
[[ $(compare -metric AE "$work/light.png" "$work/both.png" null: 2>&1) != 0 ]] || fail "an earlier result is not drawn"

# All algorithms at once have looks of their own; more series than looks are refused.
"$snug" cost --generate cube:200 --repeat 1 --longest 20 -o "$work/all.csv"
"$snug" chart "$work/all.csv" --size 1280x800 -o "$work/all.png"
drawn "$work/all.png" 1280x800
"$snug" chart "$work/all.csv" --size 1280x800 -o - > "$work/stdout.png"
cmp "$work/all.png" "$work/stdout.png" || fail "- is another picture"

# SVG needs no display: real words, the colours of both grounds, well-formed.
"$snug" cost --trials four_points -o "$work/trials.csv"
"$snug" cost --trials ritter_ten_per_cent --json -o "$work/trials.json"
for table in costs.csv growth.csv turn.csv trials.csv trials.json; do
    DISPLAY='' "$snug" chart "$work/$table" --size 960x600 -o "$work/$table.svg"
    python3 -c 'import sys, xml.dom.minidom as xml; xml.parse(sys.argv[1])' "$work/$table.svg" || fail "$table.svg is no XML"
    (( $(grep -c '</text>' "$work/$table.svg") > 10 )) || fail "$table.svg has no words"
    grep -q 'prefers-color-scheme:dark' "$work/$table.svg" || fail "$table.svg is for one ground alone"
done
grep -q 'claimed: no larger</text>' "$work/trials.csv.svg" || fail "the claim is not written"
DISPLAY='' SNUG_THEME=contrast "$snug" chart "$work/costs.csv" -o "$work/contrast.svg"
grep -q 'prefers-color-scheme' "$work/contrast.svg" && fail "high contrast has colours of its own"
"$snug" chart "$work/trials.csv" --size 1280x800 -o "$work/trials.png"
drawn "$work/trials.png" 1280x800

refused() { # words arguments...
    local said status=0
    said=$("$snug" "${@:2}" 2>&1) || status=$?
    ((status == 2)) || fail "$*: ended with $status"
    [[ $said == "snug: "*"$1"* && $(wc -l <<<"$said") == 1 ]] || fail "$*: said $said"
}
refused "nowhere.csv" chart "$work/nowhere.csv" -o "$work/no.png"
refused "the first line of such a table" chart "$work/growth.csv" --against "$work/turn.csv" -o "$work/no.png"
echo "# snug table: claims" > "$work/claims.csv"
refused "the first line of such a table" chart "$work/claims.csv" -o "$work/no.png"
{ cat "$work/all.csv"; grep '^sphere' "$work/all.csv" | sed 's/^sphere,/&more_/'; } > "$work/many.csv"
refused "series, and a chart can tell 28 apart" chart "$work/many.csv" -o "$work/no.png"
"$snug" cost --generate gaussian:200 --volume obb --repeat 1 -o "$work/other.csv"
{ cat "$work/trials.csv"; sed -n 's/^four_points,/better_start,/p' "$work/trials.csv"; } > "$work/two.csv"
refused "about more than one claim" chart "$work/two.csv" -o "$work/no.svg"
refused "--against has no use for it" chart "$work/trials.csv" --against "$work/trials.csv" -o "$work/no.svg"
refused "the name must end in .png or .svg" chart "$work/trials.csv" -o "$work/no.jpg"
refused "only results on the same points can be compared" chart "$work/costs.csv" --against "$work/other.csv" -o "$work/no.png"
[[ ! -e $work/no.png && ! -e $work/no.svg ]] || fail "it left half a picture"
