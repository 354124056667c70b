#!/bin/sh
# fetch_debian.sh PACKAGE VERSION SUITE WORK_FOLDER OUT
# Downloads the source archive of a Debian package from the mirror that this machine's own apt uses,
# with package lists of its own: the system is left as it was, and no root is needed.
set -eu
package=$1 version=$2 suite=$3 work=$4 out=$5
keys=/usr/share/keyrings/debian-archive-keyring.gpg

command -v apt-get >/dev/null || exit 1
mkdir -p "$work/lists/partial" "$work/archives/partial"
cd "$work"

# A mirror that lags behind serves as well: the pinned hashes say which files we take.
apt_here() {
    apt-get -qq -o Acquire::Check-Valid-Until=false -o Dir::Etc::SourceParts=/dev/null \
        -o Dir::Etc::SourceList="$work/sources.list" -o Dir::State::Lists="$work/lists" \
        -o Dir::Cache="$work" -o APT::Sandbox::User=root "$@"
}

for mirror in $(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sort -u |
    grep -v security); do
    echo "deb-src [signed-by=$keys] $mirror $suite main" >sources.list
    # apt checks the signature; --tar-only leaves out Debian's changes.
    if apt_here update && apt_here source --download-only --tar-only "$package"; then
        cp "${package}_$version"*.orig.tar.* "$out" && exit 0
    fi
done 2>/dev/null
exit 1
