# SPDX-License-Identifier: Apache-2.0
# shellcheck disable=SC2034,SC2154  # its variables are those of what sources it
# Shared by the tests of the program: $1 the executable, $2 the project, $3 a
# folder for this test alone.
set -euo pipefail
ideotype=$1
project=$2
folder=$3
rm -rf "$folder"
mkdir -p "$folder/campaigns"
cp -r "$project"/campaigns/{crops,plants} "$folder/campaigns"
cd "$folder"

fail() {
    echo "FAILED: $*" >&2
    exit 1
}

# A prefix that stops a command that hangs; empty unless a test sets it.
time_limit=()

# Runs a command and checks its exit code; its output is in out.log. $1 the
# expected code, the rest the command.
expect() {
    local expected=$1 code=0
    shift
    "${time_limit[@]}" "$@" >out.log 2>&1 || code=$?
    [ $code -eq "$expected" ] ||
        fail "'$*' ended with $code, not $expected: $(cat out.log)"
    echo "\$ $*"
    cat out.log
}

says() {
    grep -q -- "$1" out.log || fail "no '$1' in: $(cat out.log)"
}

# A campaign of a second or so: small field, few paths.
# $1 its name, $2 population, $3 generations
write_campaign() {
    cat >"campaigns/$1.toml" <<TOML
name = "$1"
seed = 7
[site]
name = "Ames"
latitude = 42.0
longitude = -93.6
utc_offset = -5
[day]
date = 2025-08-07
start = 07:00:00
end = 20:00:00
step_minutes = 60
[spacing]
row = 0.762
plant = 0.1524
[field]
rows = 3
plants = 3
[plant]
baseline = "crops/maize.toml"
bounds = "paper"
[light]
paths = 256
randomisations = 4
[search]
optimizer = "ga"
population = $2
elites = 2
[stop]
generations = $3
[final]
candidates = 3
paths = 256
randomisations = 4
TOML
}

# Replaces the clear day of a campaign by ten days of weather. $1 its name
give_season() {
    cp -r "$project/campaigns/weather" campaigns
    sed -i -e '/^\[day\]/,/^\[spacing\]/{/^\[spacing\]/!d}' \
        -e 's/42\.0/40.05/; s/-93\.6/-88.37/' \
        -e 's/utc_offset = -5/utc_offset = -6/' "campaigns/$1.toml"
    cat "$project/tests/data/campaign/july.toml" >>"campaigns/$1.toml"
}

# Replaces the clear day of a campaign by two months of growth, evaluated at
# three ages. $1 its name
give_growth() {
    give_season "$1"
    sed -i -e 's/maize\.toml/maize_hybrid.toml/; s/"paper"/"breedable"/' \
        -e 's/_0721_0920/_0501_0930/' \
        -e 's/^from = .*/from = 2011-05-15\nemergence = 2011-05-15/' \
        -e 's/^to = .*/to = 2011-07-15/' -e '/^diffuse_fraction/d' \
        -e 's/^\[light\]/[light]\nstages = 3/' "campaigns/$1.toml"
}

# Lets the plants of give_growth dry out a sandy soil without rain, and bear
# grain at the end. $1 the name of the campaign
give_soil() {
    give_growth "$1"
    local weather=campaigns/weather/bondville_2011_0501_0930.csv
    sed -i -e '1s/$/,rain/' -e '2,$s/$/,0/' "$weather"
    sed -i -e 's/^temperature = /rain = ["rain", "mm"]\ntemperature = /' \
        -e 's/^to = .*/to = 2011-08-15/' "campaigns/$1.toml"
    cat >>"campaigns/$1.toml" <<'TOML'
[photosynthesis]
model = "collatz"
[water]
[soil]
texture = "sand"
[irrigation]
dates = [2011-06-20, 2011-07-10]
amounts = 40
TOML
}

# Compares a group of two histories. $1 and $2 histories, $3 a group, the rest
# datasets that may differ
same_group() {
    # Scales contain addresses within the file, which differ between files.
    local excluded=() name scales="row finalist gene parent objective \
        randomisation leaf layer hour day light_source leaf_side generation \
        quantity factor"
    for name in $scales "${@:4}"; do excluded+=(--exclude-path "/$name"); done
    h5diff -c "${excluded[@]}" "$1" "$2" "$3" "$3" ||
        fail "$3 differs: $1 $2"
}

# Compares all results of two histories except times, workers, attempts and
# sessions, which may differ between runs.
same_results() {
    same_group "$1" "$2" /evaluations seconds worker attempt
    same_group "$1" "$2" /final seconds worker attempt checksum
    same_group "$1" "$2" /generations wall_time checksum
}

# Prints the descendants of process $1: MPICH has a process between mpirun and
# the ranks.
descendants_of() {
    local process
    for process in $(pgrep -P "$1"); do
        echo "$process"
        descendants_of "$process"
    done
}

# Returns whether all descendants of process $1 are gone, except zombies.
are_gone() {
    local process
    for process in $(descendants_of "$1"); do
        ! grep -qs "^State:[[:space:]]*[^ZX[:space:]]" "/proc/$process/status" ||
            return 1
    done
}

# Prints the process of a rank: $1 an ancestor of all ranks, $2 the rank.
rank_of() {
    local process
    for process in $(descendants_of "$1"); do
        if tr '\0' '\n' 2>/dev/null <"/proc/$process/environ" |
            grep -qx "\(OMPI_COMM_WORLD\|PMI\)_RANK=$2"; then
            echo "$process"
        fi
    done
}

# Returns whether the program is built with MPICH.
is_mpich() {
    "$ideotype" --version | grep -q "^MPICH"
}

# Returns whether $1 is an exit code of mpirun after a signal has stopped the
# run: 5, or 0 because MPICH 4.0 sometimes loses the code.
is_stopped() {
    [ "$1" -eq 5 ] || { [ "$1" -eq 0 ] &&
        "$ideotype" --version | grep -q "^MPICH 4\.0"; }
}

# Prints the exit code of mpirun when signal $1 ends a rank.
code_of_signal() {
    if is_mpich; then
        echo "$1"
    else
        echo $((128 + $1))
    fi
}

history_of() {
    echo "$1/$2/ames_${3:-0807}_762x152_all_r1.h5"
}
