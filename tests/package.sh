#!/usr/bin/env bash
# package.sh FOLDER: puts the packages in it on a bare Debian 12, runs them there as a user without rights, and takes them
# off again; then the archive likewise, from a folder that cannot be written to. Needs root and a network.
set -euo pipefail
folder=$(realpath "$1")
((EUID == 0)) || { echo "package.sh makes a bare system, for which it needs root." >&2; exit 2; }
work=$(mktemp -d)
chmod 755 "$work"
root=$work/root
trap 'umount "$root/proc" "$root/dev" 2>/dev/null; rm -rf --one-file-system "$work"' EXIT
fail() { printf 'not ok: %s\n' "$*" >&2; exit 1; }
passed() { printf 'ok: %s\n' "$*"; }

lintian --allow-root --fail-on error "$folder"/*.deb || fail "lintian"
passed "lintian has no error"

# This machine's own archive, if it is a Debian 12.
. /etc/os-release
sources=()
[[ ${VERSION_CODENAME:-} != bookworm ]] ||
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do [[ ! -s $file ]] || sources+=("$file"); done
mmdebstrap --quiet --mode=root --variant=minbase bookworm "$root" "${sources[@]}"
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
here() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
student() { here setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=/nonexistent "$@"; }
apt() { here apt-get -y -qq -o Dpkg::Use-Pty=0 "$@" >"$work/apt.log" 2>&1 || { tail -n 30 "$work/apt.log"; fail "apt-get $*"; }; }
files() { (cd "$root" && find . -xdev \( -path ./proc -o -path ./var -o -path ./tmp -o -path ./etc \) -prune -o -print | sort); }
mkdir "$root/packages"
for file in "$folder"/*.deb; do cp "$file" "$root/packages/$(basename "${file%%_*}").deb"; done
printf '0 0 0\n2 0 0\n0 2 0\n0 0 2\n' >"$root/packages/tetra.xyz"
here apt-get -qq update

tries() { # snug
    [[ $(student "$1" --version) =~ ^[0-9.]+$ ]] || fail "$1 --version"
    student "$1" fit --volume sphere --algorithm welzl /packages/tetra.xyz | grep -q '"radius":1.63299' || fail "$1 fit"
    (($(student "$1" lesson list | wc -l) > 40)) || fail "$1 lesson list"
}
draws() { # snug
    mkdir -pm 777 "$root/drawn"
    student xvfb-run -a "$1" render sphere-ritter --step 3 -o /drawn/step.png || fail "$1 render"
    [[ $(head -c 4 "$root/drawn/step.png") == $'\x89PNG' ]] || fail "the picture is no PNG"
    rm -r "$root/drawn"
}

# The command alone.
files >"$work/before"
apt install --no-install-recommends /packages/snug.deb
tries snug
! here dpkg-query -W libglfw3 libgl1 libepoxy0 libx11-6 2>/dev/null | grep -q . || fail "the command brings what a window needs"
says=$(student snug render sphere-ritter -o /tmp/x.png 2>&1) && fail "it drew without a window" || true
[[ $says == *"the window is not installed"* ]] || fail "$says"
apt purge --auto-remove snug
files | diff "$work/before" - || fail "files were left behind"
passed "the command installs, runs and goes on a bare system, without a library of a screen"

# The window, on a screen.
apt install --no-install-recommends xvfb xauth libgl1-mesa-dri
files >"$work/before"
apt install --no-install-recommends /packages/snug.deb /packages/snug-window.deb
tries snug
draws snug
apt purge --auto-remove snug snug-window
files | diff "$work/before" - || fail "files were left behind"
passed "the window installs, draws and goes"

# The archive: nothing of the window's own is on the system now.
apt install --no-install-recommends libgl1 libx11-6
! here dpkg-query -W libglfw3 libepoxy0 2>/dev/null | grep -q . || fail "the system has the window's libraries"
mkdir "$root/stick"
tar --zstd -xf "$folder"/*.tar.zst -C "$root/stick"
chmod -R a-w "$root/stick"
snug=/$(cd "$root" && echo stick/*/bin/snug)
tries "$snug"
draws "$snug"
passed "the archive runs from a folder that cannot be written to, with its own libraries"

# The core, by a program that was never near this clone.
apt install --no-install-recommends cmake g++ make /packages/libsnug-dev.deb
here cmake -S /usr/share/doc/snug/example -B /tmp/example >"$work/cmake.log" && here cmake --build /tmp/example >>"$work/cmake.log" ||
    { tail -n 20 "$work/cmake.log"; fail "the example cannot be built"; }
[[ $(here /tmp/example/example) == "radius 1.63299, overlap 1" ]] || fail "the example computes something else"
passed "a program finds the packaged core and computes with it"

# A lab, from its folder to the mark that a teacher sees.
apt install --no-install-recommends /packages/snug.deb
cp tests/command/lab/overlap.cpp "$root/packages/"
chmod -R a+rX "$root/packages"
lab() { student sh -c "cd /tmp && rm -rf lab && snug lab new overlap lab && $1 && snug lab check lab; snug grade --json lab/result.json"; }
[[ $(lab true) == *'"mark":0.0,'* ]] || fail "the stub earns marks, or is not tried"
[[ $(lab "cp /packages/overlap.cpp lab") == *'"mark":7.0,'* ]] || fail "a lab that is solved earns less than every mark"
passed "a lab is begun, solved, checked and graded by somebody without rights"
