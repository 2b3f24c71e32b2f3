# SPDX-License-Identifier: Apache-2.0
# shellcheck disable=SC2034,SC2154  # shared with the script that sources it
# Sourced by slurm/submit and by slurm/job.sh, with `here` the folder slurm.
# Sets the options of the site, and the path of the program `ideotype`.

# $1 a name in slurm/sites or a file
load_site() {
    site=$1
    [ -e "$site" ] || site=$here/sites/$1.sh
    if [ ! -e "$site" ]; then
        echo "there is no site '$1': neither a file nor one of" \
            "$(cd "$here/sites" && echo *.sh)" >&2
        return 2
    fi
    site=$(readlink -f "$site")
    sbatch_options=() launcher=(mpirun) out=results throttle='' lead=120
    . "$site"
}

# The program: $IDEOTYPE, the one installed or built with these scripts, or the one
# on the PATH.
find_program() {
    local candidate candidates=("$here/ideotype"
        "$here/../build/release/src/ideotype"
        "$(command -v ideotype || true)")
    [ -z "${IDEOTYPE:-}" ] || candidates=("$IDEOTYPE")
    for candidate in "${candidates[@]}"; do
        if [ -x "$candidate" ]; then
            ideotype=$(readlink -f "$candidate")
            return
        fi
    done
    echo "there is no program ${IDEOTYPE:-ideotype}: build it with" \
        "'cmake --preset release && cmake --build --preset release'," \
        "or set IDEOTYPE to its path" >&2
    return 1
}
