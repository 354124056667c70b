#!/usr/bin/env bash
# installed.sh BUILD: what is installed runs from any folder, read-only, by any user, and other programs can use the core.
set -euo pipefail
build=$1 clone=$PWD
work=$(mktemp -d)
chmod 755 "$work"
pid=
trap '[[ -z $pid ]] || kill "$pid" 2>/dev/null || true; chmod -R u+w "$work"; rm -rf "$work"' EXIT
fail() { printf '%s\n' "$*" >&2; exit 1; }
passed() { printf 'ok: %s\n' "$*"; }

# Somebody without rights, whose home cannot be written to; of the environment only what is given.
stranger=()
((EUID != 0)) || stranger=(setpriv --reuid=65534 --regid=65534 --clear-groups)
mkdir "$work/home" "$work/elsewhere"
chmod 555 "$work/home"
as_stranger() { (cd "$work/elsewhere" && env -i PATH=/usr/bin:/bin HOME="$work/home" "${stranger[@]}" "$@"); }

install_parts() { # folder components...
    local part
    for part in "${@:2}"; do DESTDIR=$1 cmake --install "$build" --component "$part" --strip --prefix /opt/snug; done >/dev/null
}

install_parts "$work/a" cli
mv "$work/a/opt/snug" "$work/command alone"
snug="$work/command alone/bin/snug"
chmod 755 "$work/elsewhere"
[[ $(as_stranger "$snug" --version) =~ ^[0-9.]+$ ]]
printf '0 0 0\n2 0 0\n0 2 0\n0 0 2\n' >"$work/tetra.xyz"
as_stranger "$snug" fit --volume sphere --algorithm welzl "$work/tetra.xyz" | grep -q '"radius":1.63299'
(($(as_stranger "$snug" lesson list | wc -l) > 40))
as_stranger "$snug" lesson play sphere-ritter >/dev/null
as_stranger "$snug" cost --generate ball:50 --algorithms ritter --repeat 1 >/dev/null || fail "snug cost"
passed "the command and its lessons run from a moved folder, by a user without a home"

! ldd "$snug" | grep -E 'libGL|glfw|X11|epoxy|png|stdc' || fail "the command links what only a window needs"
says=$(as_stranger "$snug" render sphere-ritter -o "$work/x.png" 2>&1) && fail "it drew without a window" || true
[[ $says == "snug: the window is not installed: there is no "* ]] || fail "$says"
passed "the command needs no library of a screen, and says so where there is no window"

install_parts "$work/b" cli window libraries
mv "$work/b/opt/snug" "$work/all"
chmod -R a-w "$work/all"
snug=$work/all/bin/snug window=$work/all/libexec/snug/snug-window
for program in "$snug" "$window"; do
    ! grep -aqF -e "$clone/" -e "$(realpath "$build")" "$program" || fail "$program knows where it was built"
done
system='^[[:space:]]*lib(c|m|dl|pthread|rt|GL[^.]*|X[^.]*|xcb[^.]*|bsd|md)[.]so' # C's, OpenGL's and X's, which stay the system's
as_stranger env LD_TRACE_LOADED_OBJECTS=1 "$window" | grep '=>' | grep -vE "$system" | while read -r _ _ path _; do
    [[ $(realpath "$path") == "$work/all/lib/snug/"* ]] || fail "$path is not the folder's own"
done
passed "nothing leads to the folder that it was built in, and the window takes the libraries it comes with"

cp "${XAUTHORITY:-/dev/null}" "$work/authority"
chmod 644 "$work/authority"
screen=(env DISPLAY="${DISPLAY:?}" XAUTHORITY="$work/authority")
mkdir -m 777 "$work/out"
as_stranger "${screen[@]}" "$snug" render scene-broad --step 3 -o "$work/out/step.png"
[[ $(head -c 8 "$work/out/step.png" | od -An -tx1) == " 89 50 4e 47 0d 0a 1a 0a" ]]
(cd "$work/elsewhere" && exec env -i PATH=/usr/bin:/bin HOME="$work/home" SNUG_STATE="$work/out/state.json" \
    "${screen[@]}" "${stranger[@]}" "$snug" "$work/tetra.xyz") 2>"$work/says" &
pid=$!
for _ in $(seq 100); do [[ -s $work/out/state.json ]] && break || sleep 0.1; done
grep -q '"lesson": *"which-volume"' "$work/out/state.json" || fail "the window did not open: $(cat "$work/says")"
kill "$pid"
wait "$pid" 2>/dev/null || true
pid=
passed "the window draws and opens a point file, for a user whose home is read-only"

share=$work/all/share
desktop-file-validate "$share/applications/snug.desktop" 2>&1 | tee "$work/says"
[[ ! -s $work/says ]] || fail "the desktop entry is not valid"
# No domain is ours to begin the component's name with.
says=$(appstreamcli validate --no-net "$share/metainfo/snug.metainfo.xml" 2>&1) || true
! grep -E '^[EW]:' <<<"$says" | grep -v cid-desktopapp-is-not-rdns || fail "the AppStream file is not valid"
cmp "$share/icons/hicolor/scalable/apps/snug.svg" web/page/icon.svg
cp -r "$share/mime" "$work/mime"
chmod -R u+w "$work/mime"
XDG_DATA_HOME=$work update-mime-database "$work/mime" 2>&1 | tee "$work/says"
[[ ! -s $work/says ]] || fail "the MIME types are not valid"
IFS=';' read -ra types <<<"$(sed -n 's/^MimeType=//p' "$share/applications/snug.desktop")"
for type in "${types[@]}"; do
    grep -q "^[0-9]*:$type:" "$work/mime/globs2" || fail "no file is of the type $type"
    grep -q "<mediatype>$type<" "$share/metainfo/snug.metainfo.xml" || fail "AppStream lacks $type"
done
for ending in ply stl obj xyz; do grep -q "\*\.$ending\$" "$work/mime/globs2" || fail "no type is .$ending"; done
gzip -dc "$share/man/man1/snug.1.gz" | grep -q '^\.SS snug fit'
passed "desktop entry, AppStream file, MIME types, icon and manual are valid"

install_parts "$work/c" development
prefix=$work/c/opt/snug
cmake -S "$prefix/share/doc/snug/example" -B "$work/example" -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$work/example" >/dev/null
[[ $("$work/example/example") == "radius 1.63299, overlap 1" ]]
! grep -rqF "$clone" "$prefix/lib/cmake" || fail "the installed targets know where they were built"
passed "a program finds the installed core and computes with it"
