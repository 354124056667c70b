#!/bin/sh
# fetch_debian.sh VERSION WORK_FOLDER OUT
# Downloads the source archive of Debian's imgui package from the mirror that this machine's own
# apt uses, with package lists of its own: the system is left as it was, and no root is needed.
set -eu
version=$1 work=$2 out=$3
suite=forky # the release that carries VERSION
keys=/usr/share/keyrings/debian-archive-keyring.gpg

command -v apt-get >/dev/null || exit 1
mkdir -p "$work/lists/partial" "$work/archives/partial"
cd "$work"

# A mirror that lags behind serves as well: imgui.sha256 says which files we take.
apt_here() {
    apt-get -qq -o Acquire::Check-Valid-Until=false -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::Etc::SourceList="$work/sources.list" -o Dir::State::Lists="$work/lists" \
        -o Dir::Cache="$work" -o APT::Sandbox::User=root "$@"
}

for mirror in $(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sort -u |
    grep -v security); do
    echo "deb-src [signed-by=$keys] $mirror $suite main" >sources.list
    if apt_here update && apt_here source --download-only imgui; then # apt checks the signature
        cp "imgui_$version"*.orig.tar.* "$out" && exit 0
    fi
done 2>/dev/null
exit 1
