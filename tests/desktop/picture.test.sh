# snug render: a picture of the size that was asked for, with the lesson in it; and plain words where there is no display.
. tests/desktop/support.sh
for theme in light dark contrast projector; do
    SNUG_THEME=$theme "$snug" render sphere-pca --step 3 --size 1000x700 -o "$work/$theme.png"
    [[ $(identify -format '%wx%h' "$work/$theme.png") == 1000x700 ]] || fail "$theme: another size"
    colors=$(identify -format '%k' "$work/$theme.png")
    ((colors > 200)) || fail "$theme: only $colors colours"
done
# The stage is drawn by OpenGL and by ImGui: its ground and the ball's line are both there.
[[ $(convert "$work/light.png" -fill black +opaque '#FAF8F3' -format '%[fx:mean>0.08]' info:) == 1 ]] || fail "no stage"
convert "$work/light.png" -fill white +opaque '#0A5FBF' -format '%k' info: | grep -qx 2 || fail "no mark of the current volume"
"$snug" render sphere-pca --step 3 --size 1000x700 -o "$work/again.png"
[[ $(compare -metric AE "$work/light.png" "$work/again.png" null: 2>&1) == 0 ]] || fail "the same step drawn twice differs"

status=0
said=$(env -u DISPLAY -u WAYLAND_DISPLAY "$snug" render sphere-pca -o "$work/none.png" 2>&1) || status=$?
((status == 2)) || fail "without a display it ended with $status"
[[ $said == snug:*display* && $(wc -l <<<"$said") == 1 ]] || fail "it said: $said"
[[ ! -e $work/none.png ]] || fail "it left half a picture"

# A question stands open in the picture, or with the outcome of its model answer; both are of the lesson's own file.
lesson=lessons/examples/cloud.toml
"$snug" render "$lesson" --step 1 -o "$work/step.png"
"$snug" render "$lesson" --question farthest -o "$work/asked.png"
"$snug" render "$lesson" --question farthest --answered -o "$work/answered.png"
card() { convert "$work/$1.png" -crop 610x220+371+440 +repage "$work/$1-card.png"; } # on the stage's foot
for one in step asked answered; do card $one; done
has() { [[ $(convert "$work/$1-card.png" -fill white +opaque "$2" -format '%k' info:) == 2 ]]; }
white() { [[ $(convert "$work/$1-card.png" -fill black +opaque white -format '%[fx:mean>0.4]' info:) == 1 ]]; }
white asked || fail "the question does not stand on the stage"
! white step || fail "a card stands where nothing is asked"
has answered '#007A5A' || fail "the outcome is not told as right"
! has step '#007A5A' || fail "an outcome is told where none was asked for"
[[ $(compare -metric AE "$work/step.png" "$work/asked.png" null: 2>&1) != 0 ]] || fail "the question is not in the picture"
# The last step of another algorithm.
"$snug" render obb-pca --algorithm exact --step end -o "$work/end.png"
"$snug" render obb-pca --step end -o "$work/other.png"
[[ $(compare -metric AE "$work/end.png" "$work/other.png" null: 2>&1) != 0 ]] || fail "another algorithm draws the same"
# One title is too long for a choice beside its label: both choices of algorithms stand below theirs, in one column. A
# chooser's left border is 18 such pixels high there.
"$snug" render sphere-iterative --step end --size 1280x800 -o "$work/choices.png"
borders=$(convert "$work/choices.png" -crop 1x360+1025+400 +repage txt:- | grep -c '#F7F5F2' || true)
((borders == 36)) || fail "the choices of algorithms are not one below the other: $borders pixels of their borders"
