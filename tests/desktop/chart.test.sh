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
refused "only results on the same points can be compared" chart "$work/costs.csv" --against "$work/other.csv" -o "$work/no.png"
[[ ! -e $work/no.png ]] || fail "it left half a picture"
