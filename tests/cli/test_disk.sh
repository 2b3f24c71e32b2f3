#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Disks that are too small, become full or are read-only, and truncated files:
# each causes a clear message, no recorded data are lost, and the run continues
# with --resume.
. "$(dirname "$0")/common.sh"

disk=
stop_all() {
    [ -z "$disk" ] || umount -l "$disk" 2>/dev/null || true
}
trap stop_all EXIT

write_campaign disk 12 200
run=("$ideotype" run campaigns/disk.toml)
"${run[@]}" --out whole >/dev/null
whole=$(history_of whole disk)

# A limit on the size of files is reported before the run begins. MPI also needs
# some space.
write_campaign large 12 10000
limited() {
    (ulimit -f 50000 && exec "$@")
}
expect 1 limited "$ideotype" run campaigns/large.toml --out limited
says "File too large"
says "MiB are needed and .* MiB are free"
[ -z "$(find limited -type f)" ] || fail "something is left: $(ls -R limited)"

# The limit takes effect during the run, like a write error; recorded rows are
# preserved.
"${run[@]}" --out cut >cut.log 2>&1 &
job=$!
until grep -qs "generation 2, " cut.log; do sleep 0.05; done
prlimit --pid $job --fsize=4096
code=0
wait $job || code=$?
[ $code -eq 1 ] || fail "a failed write ended with $code: $(cat cut.log)"
grep "File too large; all rows recorded before are safe; free disk" cut.log ||
    fail "no word about the cause: $(cat cut.log)"
expect 0 "${run[@]}" --out cut --resume
same_results "$whole" "$(history_of cut disk)"

# The folder cannot be created.
expect 1 "${run[@]}" --out /proc/none
says "/proc/none.*choose another with --out"

# Output that cannot be written is reported, and no incomplete file remains in a
# folder.
write_campaign full 6 2
full() {
    "$@" >/dev/full
}
for words in --version --help "run campaigns/full.toml --out full" \
    "check campaigns/full.toml" "check campaigns/full.toml --json" \
    "check campaigns/full.toml --cases" "check campaigns/full.toml --count" \
    "status full" "status full --json" "verify $(history_of full full)" \
    "evaluate campaigns/full.toml"; do
    # shellcheck disable=SC2086
    expect 1 full "$ideotype" $words
    says "cannot write to"
done
expect 0 "$ideotype" status full
says "finished (reached stop.generations)"

# If a standard stream is closed, the history must not be opened under its
# descriptor.
write_campaign closed 6 2
"$ideotype" run campaigns/closed.toml --out closed --quiet <&- >&- 2>&- || true
expect 0 "$ideotype" run campaigns/closed.toml --out closed --resume
expect 0 "$ideotype" verify "$(history_of closed closed)"
expect 0 "$ideotype" run campaigns/disk.toml --out exported \
    --set stop.generations=60
mkdir exports
small() {
    (ulimit -f 1 && exec "$@")
}
for words in "--generations --to exports/rows.csv" "--best --to exports/plant.vtp" \
    "--best --to exports/plant.obj"; do
    # shellcheck disable=SC2086
    expect 1 small "$ideotype" export "$(history_of exported disk)" $words
    says "exports/.*: this file cannot be written: File too large"
    [ -z "$(ls exports)" ] || fail "something is left: $(ls exports)"
done

# HDF5's own locks do not interfere, even if an environment variable requests
# them.
write_campaign locks 6 2
export HDF5_USE_FILE_LOCKING=TRUE
expect 0 "$ideotype" run campaigns/locks.toml --out locks
expect 0 "$ideotype" run campaigns/locks.toml --out locks --resume
expect 0 "$ideotype" status locks
unset HDF5_USE_FILE_LOCKING

# A copied history is truncated: the remaining data can be exported, and the
# loss is reported.
head -c -1000 "$whole" >short.h5
expect 4 "$ideotype" export short.h5 --best --to best.csv
says "truncated"
expect 4 "$ideotype" status short.h5
says "1000 bytes are missing at its end, 200 of 200 complete generations"
expect 0 "$ideotype" export short.h5 --generations --to short.csv
says "and 1 of these lack numbers and cannot be verified"
says "200 generations"
expect 0 "$ideotype" export "$whole" --generations --to whole.csv
cmp short.csv whole.csv || fail "saved generations differ"
[ "$(wc -l <short.csv)" -eq $((1 + 12 * 200)) ] || fail "not one row each"
head -c 200000 "$whole" >short.h5
expect 1 "$ideotype" export short.h5 --generations --to none.csv
says "no complete generation can be read"
[ ! -e none.csv ] || fail "an empty file was written"

# A history repacked by HDF5 reads as before.
h5repack -L -f SHUF -f GZIP=6 "$whole" packed.h5
[ $((2 * $(stat -c %s packed.h5))) -lt "$(stat -c %s "$whole")" ] ||
    fail "repacked it is not half as large"
expect 0 "$ideotype" verify packed.h5
expect 0 "$ideotype" status packed.h5
says "finished (reached stop.generations)"
expect 0 "$ideotype" evaluate packed.h5 --generation 7 --slot 3
says "agrees bit for bit"
expect 0 "$ideotype" export packed.h5 --generations --to packed.csv
cmp packed.csv whole.csv || fail "packed generations differ"
same_results "$whole" packed.h5
cp packed.h5 "$(history_of cut disk)"
expect 0 "${run[@]}" --out cut --resume
says "gain"

# A history that exceeds the free space is refused before anything is written.
expect 1 "${run[@]}" --out huge --set search.population=100000 --set stop.generations=20000
says "MiB are needed and .* MiB are free"
[ -z "$(find huge -type f)" ] || fail "something is left: $(ls -R huge)"
for command in check run; do
    expect 3 "$ideotype" $command "${run[2]}" --set search.population=100000 --set stop.generations=1000000
    says "stop.generations is 1000000 .*use 21474 or fewer"
    expect 2 "$ideotype" $command "${run[2]}" --out ""
    says "out is empty"
done

# The following disk is really full.
mkdir small
if ! mount -t tmpfs -o size=1m tmpfs small 2>/dev/null; then
    echo "MOUNTING IS NOT PERMITTED: THE FULL DISK IS NOT TESTED" >&2
    exit 0
fi
disk=$PWD/small
expect 1 "${run[@]}" --out small
says "No space left on device"
says "MiB are needed and .* MiB are free"
[ -z "$(find small -type f)" ] || fail "something is left: $(ls -R small)"

# The run reserves its space at the start, so that a disk that becomes full
# later has no effect.
mount -o remount,size=8m small
expect 5 "${run[@]}" --out small --wall-time 1s
says "stopped before the end"
head -c 16m /dev/zero >small/ballast 2>/dev/null || true
expect 5 "${run[@]}" --out small --wall-time 1s --resume

# A sparse copy of a history no longer has reserved space. It is refused before
# any evaluation, and resumes once there is space again.
small=$(history_of small disk)
cp --sparse=always "$small" sparse.h5
rm "$small"
cp --sparse=always sparse.h5 "$small"
head -c 16m /dev/zero >>small/ballast 2>/dev/null || true
expect 1 "${run[@]}" --out small --resume
says "MiB are needed and .* MiB are free"
expect 0 "$ideotype" status small
rm small/ballast
expect 0 "${run[@]}" --out small --resume
same_results "$whole" "$small"

# This file system is read-only, even for root.
mount -o remount,ro small
expect 1 "${run[@]}" --out small/new
says "Read-only file system.*choose another with --out"
expect 0 "$ideotype" status small
