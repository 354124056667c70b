#!/bin/sh
# A subject keeps to its own folders: its files include no other subject's, and nothing outside asks what a lesson is
# about, but for the lists of subjects; the page's JavaScript neither. Prints the lines that do. For any POSIX shell.
set -eu
cd "$(dirname "$0")/.."
status=0
complain() { # what is wrong, the lines
    [ -z "$2" ] || { printf '%s\n%s\n' "$1" "$2"; status=1; }
}

for folder in app/subjects/*/ core/lesson/subjects/*/; do
    subject=$(basename "$folder")
    complain "$folder includes another subject:" \
        "$(git grep -hE '#include "[a-z]+/subjects/' -- "$folder" | grep -v "/subjects/$subject/" || true)"
done

# The rooms, without the subjects' folders and lists.
everywhere='core app desktop web :!*/subjects/* :!*/subjects.cpp'
complain 'What a lesson is about is tested outside the subjects:' \
    "$(git grep -nE '\bas<[A-Z][A-Za-z]*Subject>|subject(->|\.)name *[!=]=|\bk(Cloud|Pair|Frustum|Field|Tree|Scene|Update|Cost|Criteria|Claims)Row\b' \
        -- $everywhere || true)"
# `snug scene` and `snug chart` are each of one subject.
complain 'A subject is included outside the subjects:' \
    "$(git grep -nE '#include "(app|lesson)/subjects/' -- $everywhere :!desktop/cli/scene.cpp :!desktop/chart_file.cpp \
        || true)"
complain 'A door knows what only some subjects are made of:' \
    "$(git grep -nwE 'BoxPair|BoxSubject|boxes_of|PointSubject|HeldVolume|costs_of|recorded_scene' -- desktop web \
        :!desktop/cli/scene.cpp || true)"
# The page says what the lesson says of itself. (What links of old called the rows of boxes is read on.)
complain 'The page knows a subject by its name:' \
    "$(git grep -nwE 'cloud|frustum|frusta|scenes?|bodies|boxes|costs|(box|volume)_pair' -- 'web/page/*.js' \
        | grep -vE '^[^:]*:[0-9]+: *(//|\*|/\*\*)|links of old|performance\.now' || true)"
exit $status
