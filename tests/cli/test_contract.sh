#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A run refuses to continue a history, with the reason, after a change of maths,
# another instruction set, a file that is no file or not there any more.
. "$(dirname "$0")/common.sh"
mixed_cluster=$(readlink -f "$4")
time_limit=(timeout 60)

write_campaign maths 8 3
maths=$(history_of run maths)
expect 0 "$ideotype" run campaigns/maths.toml --out run
expect 0 "$ideotype" run campaigns/maths.toml --out run --resume

# begin OUT [OPTION...]: begins a long run and stops it.
write_campaign begun 12 300
begin() {
    "$ideotype" run campaigns/begun.toml --out "$@" >begun.log 2>&1 &
    local job=$!
    until grep -q "generation 2," begun.log; do sleep 0.05; done
    kill -TERM $job
    wait $job || true
}
begin run
begun=$(history_of run begun)

# The C library's variants for processors with fused multiply-add and without
# differ in last bits.
# shellcheck disable=SC2054  # the comma is of the variable
plain=(env GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2)
if [ "$("$ideotype" --version | grep maths)" = \
    "$("${plain[@]}" "$ideotype" --version | grep maths)" ]; then
    grep -qw fma /proc/cpuinfo && fail "the maths of both variants look alike"
    echo "NO FUSED MULTIPLY-ADD HERE: OTHER MATHS ARE NOT TESTED" >&2
else
    expect 0 "${plain[@]}" "$ideotype" run campaigns/maths.toml --out run --resume
    says "finished before"
    expect 4 "${plain[@]}" "$ideotype" run campaigns/begun.toml --out run --resume
    says "$begun: .*would not continue this history with the same bits"
    says "maths was [0-9a-f]*, is [0-9a-f]*"
    says "another folder with --out"
    # A job does not start if its ranks differ.
    cat >ranks.sh <<'EOF'
#!/bin/sh
[ "${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-$PMIX_RANK}}" = 0 ] ||
    export GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2
exec "$@"
EOF
    chmod +x ranks.sh
    expect 4 mpirun -n 2 ./ranks.sh "$ideotype" run campaigns/maths.toml \
        --out ranks
    says "the ranks of this job would not compute the same bits (maths is "
    [ ! -e ranks ] || fail "something was written"
fi

# Tests an instruction set chosen by the user, and histories made with a
# different one.
expect 0 "$ideotype" run campaigns/maths.toml --out sse2 --isa sse2
h5dump -a isa "$(history_of sse2 maths)" | grep -q '"sse2"' || fail "no sse2"
expect 0 "$ideotype" run campaigns/maths.toml --out sse2 --resume
begin sse2 --isa sse2
expect 4 "$ideotype" run campaigns/begun.toml --out sse2 --resume --isa sse4.2
says "was begun with instruction set sse2, not sse4.2; leave --isa out"
expect 2 "$ideotype" run campaigns/maths.toml --out sse3 --isa sse3

# If all ranks except the first support only sse2, all ranks use sse2.
expect 0 mpirun -n 3 "$mixed_cluster" campaigns/maths.toml mixed 1
h5dump -a isa "$(history_of mixed maths)" | grep -q '"sse2"' ||
    fail "the ranks did not agree on sse2"
same_results "$(history_of sse2 maths)" "$(history_of mixed maths)"
if ! h5dump -a isa "$maths" | grep -q '"sse2"'; then
    expect 4 mpirun -n 3 "$mixed_cluster" campaigns/begun.toml run 1
    says "narrow has no instruction set .* (it has sse2); this history was"
fi

# Commands do not wait on paths that are not regular files.
mkdir -p odd/maths folder/x.h5
mkfifo pipe.h5
ln -s loop.h5 loop.h5
for thing in "pipe.h5 a.named.pipe 4" "folder/x.h5 a.folder 4" \
    "/dev/zero a.device 4" "loop.h5 form.a.loop 1"; do
    read -r path what code <<<"$thing"
    if [ "$path" != folder/x.h5 ]; then
        expect "$code" "$ideotype" status "$path"
        says "$path: .*$what"
    fi
    expect "$code" "$ideotype" export "$path" --best --to new.csv
    says "$path: .*$what"
    ln -sfn "$(realpath -ms "$path")" "$(history_of odd maths)"
    expect "$code" "$ideotype" run campaigns/maths.toml --out odd --resume
    says "$what"
    expect "$code" "$ideotype" check campaigns/maths.toml --left --out odd
    says "$what"
done
expect 1 "$ideotype" evaluate loop.h5 --best
says "form a loop"
expect 1 "$ideotype" status folder
says "there is no history"

# The folder of a run is removed, and another run starts at the same path. The
# first run must notice, and must not release the lock of the second.
write_campaign long 12 300
"$ideotype" run campaigns/long.toml --out place >first.log 2>&1 &
first=$!
until grep -q "generation 2," first.log; do sleep 0.05; done
kill -STOP $first
rm -r place
"$ideotype" run campaigns/long.toml --out place >second.log 2>&1 &
second=$!
until grep -q "generation 2," second.log; do sleep 0.05; done
kill -TERM $first
kill -CONT $first
code=0
wait $first || code=$?
[ $code -eq 4 ] || fail "the first run ended with $code: $(cat first.log)"
grep -q "this file was deleted, moved or replaced" first.log ||
    fail "$(cat first.log)"
"$ideotype" status place | grep -q ": running" || fail "the second run lost its lock"
expect 4 "$ideotype" run campaigns/long.toml --out place --resume
says "in use by process $second "
# No further file is needed to lock a history.
find place -type f ! -name '*.h5' -delete
expect 4 "$ideotype" run campaigns/long.toml --out place --resume
says "in use by process $second "
kill -TERM $second
wait $second || true

# A history is truncated during a run, at several lengths. BUS stands for the
# signal that the system sends if the program notices too late.
for size in 0 20000 200000 600000 1200000 BUS; do
    rm -rf cut cut.log
    "$ideotype" run campaigns/long.toml --out cut >cut.log 2>&1 &
    job=$!
    until grep -qs "generation 2," cut.log; do sleep 0.05; done
    if [ $size = BUS ]; then
        kill -BUS $job
    else
        truncate -s $size "$(history_of cut long)"
    fi
    code=0
    wait $job || code=$?
    [ $code -eq 4 ] || fail "cut to $size it ended with $code: $(cat cut.log)"
    grep "cut short while it was written.*start again in another folder" cut.log ||
        fail "cut to $size: $(cat cut.log)"
done

# Names that are too long are reported before any evaluation.
long=$(printf 'x%.0s' $(seq 64))
sed "s/^name = \"Ames\"/name = \"$long\"/; s/^\[\(day\|spacing\)\]/&\nname = \"$long\"/
    \$a [traits]\nname = \"$long\"\nfree = [\"azimuth\"]" campaigns/maths.toml >campaigns/names.toml
for command in check run; do
    expect 3 "$ideotype" $command campaigns/names.toml --out names
    says "$long.*: this name of a file is 269 bytes long, .*allows 255); shorten"
done
[ ! -e names ] || fail "something was written"
deep=$(printf '%0199d/' $(seq 21))
for command in check run; do
    expect 3 "$ideotype" $command campaigns/maths.toml --out "$deep"
    says "this path is 42.. bytes long, .*allows 4096); choose a shorter folder"
done

# The size of a history on disk is the size that `check` predicts.
expect 0 "$ideotype" check campaigns/maths.toml
size=$(stat -c %s "$maths" | awk '{ printf "%.2f", $1 / 1048576 }')
says "^disk      $size MiB per case, $size MiB in total"
