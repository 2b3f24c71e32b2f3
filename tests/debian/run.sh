#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs both commands of README.md on a fresh Debian of another suite, as root
# and with its own packages, on a clone of the last commit here; then prints
# versions and results.
#
#     tests/debian/run.sh SUITE [DIRECTORY [COMMAND...]]      # such as trixie
#
# or runs COMMAND there, such as .ci/wheel, in the top folder.
# Needs root, debootstrap and 6 GB. The root is built in DIRECTORY
# (/tmp/ideotype-SUITE) and stays there: a second run begins with it and
# fetches the commits made since. Packages come from the mirror that apt uses
# here. Mounts and processes end with the script, however it ends, because they
# are in separate name spaces.
set -euo pipefail
suite=${1:?usage: tests/debian/run.sh SUITE [DIRECTORY]}
root=${2:-/tmp/ideotype-$suite}
here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../.." && pwd)

[ "$(id -u)" -eq 0 ] || { echo "only root may use chroot; run it as root" >&2; exit 2; }
command -v debootstrap >/dev/null || {
    echo "there is no debootstrap; apt-get install debootstrap" >&2
    exit 2
}

# Prints the first address of an archive here; $1 its label.
mirror_of() {
    # shellcheck disable=SC2016  # apt's own variable
    apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' \
        'Origin: Debian' "Label: $1" | sed -n 1p
}

# This mark distinguishes a complete root from one left by an interruption.
if [ ! -e "$root/etc/built" ]; then
    [ ! -e "$root" ] || { echo "$root is not a whole root; remove it" >&2; exit 2; }
    echo "building the root in $root"
    debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" \
        "$(mirror_of Debian)" >"$root.log" 2>&1 || { tail "$root.log" >&2; exit 1; }
    rm "$root.log"
    {
        echo "deb $(mirror_of Debian) $suite main"
        echo "deb $(mirror_of Debian) $suite-updates main"
        security=$(mirror_of Debian-Security)
        [ -z "$security" ] || echo "deb $security $suite-security main"
    } >"$root/etc/apt/sources.list"
    # Synchronous writes are not needed: a package may be lost if the power
    # fails during its installation.
    echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/unsafe-io"
    touch "$root/etc/built"
fi

# The new root uses the network settings of this machine: names, certificates
# and the configuration of pip.
for file in /etc/resolv.conf /etc/hosts /etc/pip.conf \
    /etc/ssl/certs/ca-certificates.crt; do
    [ ! -e "$file" ] || cp -L "$file" "$root$file"
done
environment=(HOME=/root LANG=C.UTF-8
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
while IFS= read -r variable; do
    environment+=("$variable")
done < <(env | grep -iE '^(https?_proxy|no_proxy|PIP_[A-Z_]+|SSL_CERT_FILE|CMAKE_BUILD_PARALLEL_LEVEL)=')

clone=$root/srv/ideotype  # the clone keeps its build if the root is used again
[ -e "$clone" ] || git clone --quiet --no-checkout "$project" "$clone"
commit=$(git -C "$project" rev-parse HEAD)
git -C "$clone" fetch --quiet --tags --force "$project" "$commit"
git -C "$clone" checkout --quiet --detach "$commit"
cp "$here/inside.sh" "$root/srv/inside.sh"

# shellcheck disable=SC2016  # variables of the inner shell
exec unshare --mount --pid --fork --kill-child --propagation private \
    bash -euo pipefail -c '
        root=$1
        mount --bind "$root" "$root"  # .ci/wheel expects a mount at /
        mount -t proc proc "$root/proc"
        # Packages must not change settings of this kernel.
        mount --bind "$root/proc/sys" "$root/proc/sys"
        mount -o remount,bind,ro "$root/proc/sys"
        mount -t sysfs -o ro sysfs "$root/sys"
        mount --rbind /dev "$root/dev"
        mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
        exec chroot "$root" env -i "${@:2}"
    ' bash "$root" "${environment[@]}" bash /srv/inside.sh "${@:3}"
