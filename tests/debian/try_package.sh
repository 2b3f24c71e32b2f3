#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the packages of .ci/deb on a system without compiler and MPI, as
# package.sh prepares it, tries them as a user, and removes them.
#
#     try_package.sh DIRECTORY       # of the packages
set -euo pipefail
packages=${1:?usage: tests/debian/try_package.sh DIRECTORY}
here=$(cd "$(dirname "$0")" && pwd)
user=(setpriv --reuid=nobody --regid=nogroup --clear-groups)

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

if [ "$(id -u)" -eq 0 ]; then
    for command in c++ mpirun ideotype; do
        ! command -v "$command" || fail "$command is there"
    done
    grep PRETTY_NAME /etc/os-release
    size=$(du -sm --exclude=/proc --exclude=/sys --exclude=/dev / | cut -f 1)
    # Recommended packages are installed too, as apt does by default.
    time apt-get -qq install -y "$packages"/ideotype_*.deb >/dev/null
    echo "with its dependencies it takes $(($(du -sm --exclude=/proc \
        --exclude=/sys --exclude=/dev / | cut -f 1) - size)) MB"
    dpkg-query -W -f '${Package} ${Version}: ${Depends}; ${Recommends}\n' ideotype
    work=$(mktemp -d)
    chown nobody "$work"
    (cd "$work" && "${user[@]}" env HOME="$work" "$here/try_package.sh" \
        "$packages")
    rm -r "$work"

    # A program outside the project links the library.
    apt-get -qq install -y --no-install-recommends g++ cmake ninja-build \
        "$packages"/libideotype-dev_*.deb >/dev/null
    cmake -S analysis/examples -B "$work" -G Ninja >/dev/null
    cmake --build "$work" >/dev/null
    "$work/07_mesh" | tail -n 3
    apt-get -qq purge -y ideotype libideotype-dev >/dev/null
    [ -z "$(find /usr /etc /var/lib -name 'ideotype*' -print -quit)" ] ||
        fail "files are left: $(find /usr /etc /var/lib -name 'ideotype*')"
    echo "removed"
    exit
fi

# As a user, in an empty folder.
ideotype --version
cp -r /usr/share/ideotype/campaigns .
quick=(run campaigns/quickstart.toml --set stop.generations=3
    --set final.randomisations=8)
ideotype check campaigns/quickstart.toml | tail -n 3
time mpirun --oversubscribe -n 3 ideotype "${quick[@]}" --out ranks
ideotype "${quick[@]}" --out threads >threads.log
ideotype status ranks
for folder in ranks threads; do
    ideotype export $folder/quickstart/*_r1.h5 --generations --to $folder.csv \
        >export.log
done
cmp ranks.csv threads.csv
ideotype evaluate ranks/quickstart/*_r1.h5 --best | grep "agrees bit for bit"
/usr/share/ideotype/slurm/submit --dry-run campaigns/quickstart.toml |
    grep campaign.sbatch
zcat /usr/share/man/man1/ideotype.1.gz | grep -c '^\.TP'
. /usr/share/bash-completion/completions/ideotype
complete -p ideotype
