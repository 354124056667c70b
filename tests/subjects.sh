#!/bin/sh
# A subject keeps to its own folders: its files include no other subject's, and nothing outside asks what a lesson is
# about, but for the lists of subjects. Prints the lines that do. For any POSIX shell.
set -eu
cd "$(dirname "$0")/.."
status=0
complain() { # what is wrong, the lines
    [ -z "$2" ] || { printf '%s\n%s\n' "$1" "$2"; status=1; }
}

for folder in app/subjects/*/ core/lesson/subjects/*/; do
    subject=$(basename "$folder")
    complain "$folder includes another subject:" \
        "$(git grep -nE '#include "[a-z]+/subjects/' -- "$folder" | grep -v "/subjects/$subject/" || true)"
done

# The rooms, without the subjects' folders and lists. A command or a tab that is one subject's own may include it.
everywhere='core app desktop web :!*/subjects/* :!*/subjects.cpp'
complain 'What a lesson is about is tested outside the subjects:' \
    "$(git grep -nE '\bas<[A-Z][A-Za-z]*Subject>|subject(->|\.)name *[!=]=|\bk(Cloud|Pair|Frustum|Scene|Cost)Row\b' \
        -- $everywhere || true)"
complain 'A subject is included outside the subjects:' \
    "$(git grep -nE '#include "(app|lesson)/subjects/' -- core app ':!*/subjects/*' ':!*/subjects.cpp' || true)"
exit $status
