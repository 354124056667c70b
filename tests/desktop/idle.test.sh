# A window that nobody touches uses no processor.
. tests/desktop/support.sh
open_window --lesson sphere-ritter
sleep 1.5 # what opening has to settle
ticks() { awk '{print $14 + $15}' "/proc/$pid/stat"; }
before=$(ticks)
sleep 3
used=$(($(ticks) - before))
((used <= 6)) || fail "idle for 3 seconds it used $used hundredths of a second of processor"
xdotool key space # and it wakes up
until_state 's.step > 0 || s.caption.length > 0'
kill -0 "$pid" || fail "it is gone"
