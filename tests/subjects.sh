#!/bin/sh
# A subject keeps to its own folders: its files include no other subject's, and nothing outside asks what a lesson is
# about, but for the one list of subjects. Prints the lines that do. For any POSIX shell.
set -eu
cd "$(dirname "$0")/.."
status=0
complain() { # what is wrong, the lines
    [ -z "$2" ] || { printf '%s\n%s\n' "$1" "$2"; status=1; }
}

for folder in app/subjects/*/ core/lesson/subjects/*/; do
    [ -d "$folder" ] || continue
    subject=$(basename "$folder")
    complain "$folder includes another subject:" \
        "$(git grep -nE '#include "[a-z]+/subjects/' -- "$folder" | grep -v "/subjects/$subject/" || true)"
done

# What lessons of one kind alone have, or are called.
kinds='(->|\.)(boxes|frame|frames)\(\)? *(==|!=) *nullptr|(->|\.)frames\(|(->|\.)measures\b|has_(frustum|boxes)\(|'
kinds=$kinds'kBoxPair|kFrustumBox|kScene\b|lesson\(\)\.(scene|boxes|volume ==)|step_word\([^)]*\)+ *==|\bsubject\(\) *=='
# The sentences, which have not moved to their subjects yet.
waiting=:!app/captions.cpp
complain 'A kind of lesson is tested outside the subjects:' \
    "$(git grep -nE "$kinds" -- app ':!app/subjects' ':!app/subjects.cpp' "$waiting" || true)"
complain 'A subject is included outside the subjects:' \
    "$(git grep -nE '#include "app/subjects/' -- app ':!app/subjects' ':!app/subjects.cpp' "$waiting" || true)"
exit $status
