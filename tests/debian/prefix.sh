#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds, installs and runs ideotype as a user with libraries that are unpacked in
# folders, as on a cluster where nobody installs packages; HDF5 is the one with MPI,
# in a separate folder, as Spack has it by default. run.sh runs it in a root of its
# own, where none of these libraries is installed:
#
#     tests/debian/run.sh bookworm /tmp/ideotype-prefix tests/debian/prefix.sh
set -euo pipefail
prefix=/opt/prefix/usr hdf5=/opt/hdf5 work=/tmp/prefix
machine=$(uname -m)-linux-gnu
libraries=$prefix/lib/$machine

if [ "$(id -u)" -eq 0 ]; then
    apt-get -qq install -y --no-install-recommends g++ cmake ninja-build >/dev/null
    rm -rf /opt/prefix $hdf5 $work
    mkdir -p /tmp/debs/partial /opt/prefix $hdf5/lib $work
    read -r -d '' -a packages < <(sed -n '/packages=(/,/)/p' .ci/install |
        sed 's/.*(//; s/"$@")//; s/libhdf5-dev/libhdf5-openmpi-dev/') || true
    apt-get -qq install -y --download-only --no-install-recommends \
        -o Dir::Cache::archives=/tmp/debs "${packages[@]}"
    for package in /tmp/debs/*.deb; do dpkg -x "$package" /opt/prefix; done
    # Links that the packages would create on installation.
    for name in mpicxx mpirun; do ln -s $name.openmpi $prefix/bin/$name; done
    ln -s $prefix/include/hdf5/openmpi $hdf5/include
    ln -s "$libraries"/hdf5/openmpi/*.so $hdf5/lib
    chown nobody $work
    exec setpriv --reuid=nobody --regid=nogroup --clear-groups \
        env HOME=$work "$0"
fi

# These variables are normally set by the modules of a cluster, because Debian's
# libraries have no separate paths.
export PATH=$prefix/bin:$PATH OPAL_PREFIX=$prefix
export LD_LIBRARY_PATH=$libraries:/opt/prefix/lib/$machine
export CPATH=$prefix/include/$machine
cmake -S . -B $work/build -G Ninja -DBUILD_TESTING=OFF \
    "-DCMAKE_PREFIX_PATH=$prefix;$hdf5"
cmake --build $work/build
cmake --install $work/build --prefix $work/installed >/dev/null
ideotype=$work/installed/bin/ideotype
"$ideotype" --version
"$ideotype" check campaigns/ames_quick.toml
mpirun --oversubscribe -n 3 "$ideotype" run campaigns/ames_quick.toml \
    --set stop.generations=2 --out $work/results
