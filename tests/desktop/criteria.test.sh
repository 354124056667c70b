# Which volume when, by keyboard: the question first, all volumes measured, another one chosen, one of them alone.
. tests/desktop/support.sh
opened='s.caption.length > 0' open_window --lesson which-volume
[[ $(state 's.handles.length') == 7 ]] || fail "it shows $(state 's.handles.length') small pictures"
[[ $(state 's.asked') == null ]] || fail "it asks before anything was seen"
xdotool key m # asks for the prediction first
until_state '/^Predict/.test(s.caption) && s.asked !== null'
xdotool key m
sleep 0.3
[[ $(state 's.caption') == Predict* ]] || fail "it measured before the prediction: $(state 's.caption')"
xdotool key s
until_state '!/^Predict/.test(s.caption)'
xdotool key m
for i in 1 2 3; do # what one wait does not see, a busy machine has not done yet
    (until_state '/^Sphere: T = /.test(s.caption)') 2>/dev/null && break
done
until_state '/^Sphere: T = /.test(s.caption)'
xdotool key Right
until_state '/^AABB: T = /.test(s.caption)'
xdotool key c # the AABB alone
until_state 's.handles.every(h => /^P/.test(h.id))'
xdotool key c
until_state 's.handles.length === 7'
close_window

# A point file alone is shown there, with all volumes around it.
printf '%s\n' '0 0 0' '4 0 0' '0 3 0' '0 0 2' '1 1 1' >"$work/mine.xyz"
snug=$(realpath "$snug")
cd "$work" # where it saves
opened='s.handles.length === 7' open_window mine.xyz
[[ $(state 's.lesson') == which-volume ]] || fail "it opened $(state 's.lesson')"
xdotool key c
until_state 's.handles.length === 5 && s.handles.every(h => /^P/.test(h.id))'

# What it saves is what `snug which` prints of the same points, but for the times.
xdotool key c m
for i in 1 2 3; do
    (until_state '/^Sphere: T = /.test(s.caption)') 2>/dev/null && break
done
xdotool key ctrl+s
for i in $(seq 50); do [[ -s snug-criteria.csv ]] && break; sleep 0.1; done
python3 - "$snug" <<'END' || fail "the saved table is not the one of snug which"
import csv, subprocess, sys
def rows(lines):
    lines = list(lines)
    head = dict(line[2:].strip().split(": ", 1) for line in lines if line.startswith("# "))
    return head, list(csv.DictReader(line for line in lines if not line.startswith("# ")))
head, saved = rows(open("snug-criteria.csv"))
load = {key: saved[0]["load." + key] for key in ("bodies", "frames", "updates", "pairs", "hit_rate")}
load["hit_rate"] = str(float(load["hit_rate"]) * 100)
options = [word for key, value in load.items() for word in ("--" + key.replace("_", "-"), value)]
run = subprocess.run([sys.argv[1], "which", "mine.xyz", "--seed", head["seed"], "--csv", "--repeat", "1", *options],
                     capture_output=True, text=True, check=True)
_, printed = rows(run.stdout.splitlines())
assert [*saved[0]] == [*printed[0]], ([*saved[0]], [*printed[0]])
still = [key for key in saved[0] if "_ns" not in key and key != "over_hull"]
assert len(still) > 10
for one, other in zip(saved, printed, strict=True):
    differing = [(key, one[key], other[key]) for key in still if one[key] != other[key]]
    assert not differing, (one["volume"], differing)
END
