# On a screen of two pixels to the page's one, the window is twice as large and a drag holds what is under the mouse.
xprop -root -f RESOURCE_MANAGER 8s -set RESOURCE_MANAGER $'Xft.dpi:\t192\n'
. tests/desktop/drag.test.sh
size=$(xdotool getwindowgeometry "$window" | grep -oP 'Geometry: \K\S+')
[[ $size == 2560x1560 ]] || fail "the window takes $size" # all of the screen but room for a frame
