#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the batch evaluator `serve`: genomes through pipes, for one process and
# for all ranks; invalid lines; clients, ranks and pipes that disappear.
# tests/analysis/program/test_serve.py compares its results with those of a run.
. "$(dirname "$0")/common.sh"
time_limit=(timeout 60)
write_campaign served 8 3
serve=("$ideotype" serve campaigns/served.toml)
ranks=(mpirun -n 3)

# An empty input is valid; the first line of the output describes all genes.
"${serve[@]}" </dev/null >hello.json 2>hello.log
[ "$(wc -l <hello.json)" = 1 ] || fail "no single hello: $(cat hello.json)"
grep -Eq '^[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9:]{8}Z  ideotype: 0 genomes' \
    hello.log || fail "no line with the time: $(cat hello.log)"
genes=$(grep -o '"baseline":[^,]*' hello.json | cut -d : -f 2 | paste -s -d ,)

# Prints $1 requests: the baseline with its sixth leaf at many lengths.
requests() {
    awk -v n="$1" -v genes="$genes" 'BEGIN {
        split(genes, all, ",")
        for (i = 0; i < n; ++i) {
            line = all[1]
            for (k = 2; k in all; ++k)
                line = line "," (k == 31 ? 0.3 + 0.012 * (i % 100) : all[k])
            printf "{\"id\": %d, \"genome\": [%s]}\n", i, line
        } }'
}
# Prints the results of answers by id, without data that depend on the rank.
figures() {
    grep '"id":' "$1" | sed -E 's/,"rank":.*//; s/"line":[0-9]*,//' | sort -V
}

# Answers are equal for any number of ranks, from a file and from a pipe, and
# without a newline at the end.
requests 60 >requests
"${serve[@]}" <requests >alone.out
figures alone.out >alone
[ "$(grep -c '"status":"done","objectives":{"absorbed_par"' alone)" = 60 ] ||
    fail "not all are done: $(head -2 alone)"
# With so few paths some plants may absorb equal light although a leaf is a
# centimetre longer.
[ "$(cut -d : -f 4- alone | sort -u | wc -l)" -gt 55 ] || fail "all are alike"
head -c -1 requests | "${ranks[@]}" "${serve[@]}" >three.out
figures three.out | diff alone - || fail "3 ranks differ from one"
[ "$(grep -o '"rank":[0-9]*' three.out | sort -u | wc -l)" = 2 ] ||
    fail "not all workers have worked"
# Open MPI may print warnings about networks that it does not need.
OMPI_MCA_btl=^tcp "${ranks[@]}" "${serve[@]}" --quiet </dev/null 2>quiet.log | grep -q workers.:2
[ ! -s quiet.log ] || fail "--quiet says $(cat quiet.log)"

# Evaluations begin before the input ends, and each answer is sent immediately.
mkfifo in out
for start in "" "${ranks[*]}"; do
    $start "${serve[@]}" <in >out 2>talk.log &
    job=$!
    exec 3>in 4<out
    read -t 60 -r -u 4 line
    for i in 1 2 3; do
        sed -n "${i}p" requests >&3
        read -t 60 -r -u 4 line || fail "no answer to line $i: $(cat talk.log)"
        [[ $line == '{"id":'$((i - 1))',"line":'$i',"status":"done"'* ]] ||
            fail "line $i: $line"
    done
    exec 3>&-
    wait $job || fail "the end of the input ended it with $?"
    exec 4<&-
done

# An invalid line is answered with an error, and the next line is evaluated.
bad() {
    { echo "$1"; sed -n 1p requests; } | "${serve[@]}" --quiet >bad.out ||
        fail "ended with $? by: $1"
    grep -qF "$2" bad.out || fail "no '$2' in: $(tail -n 2 bad.out)"
    [ "$(tail -n 1 bad.out | grep -c '"line":2,"status":"done"')" = 1 ] ||
        fail "does not continue after: $1"
}
bad nonsense '"id":null,"line":1,"status":"failed","message":"this line is no'
bad '{"id": "a", "genome": [1, 2]}' \
    '{"id":"a","line":1,"status":"failed","message":"genome has 2 numbers; it must have 79'
bad "{\"genome\": [NaN,${genes#*,}]}" 'this line is not valid JSON (column 13'
bad "{\"genome\": [1e999,${genes#*,}]}" 'number overflow'
bad "{\"genome\": [null,${genes#*,}]}" 'number 1 of genome (leaf01_length) must'
bad '{"genom": [1]}' "there is no key 'genom'; did you mean 'genome'?"
bad '[1]' 'a line must be an object'
bad '{"id": 3}' 'genome is missing'
bad "{\"genome\": [$genes], \"tolerance\": 2}" 'must be above 0 and at most 0.05'
bad "{\"genome\": [$genes], \"seed\": -1}" 'seed must be a whole number from 0'
bad "{\"genome\": [$genes], \"final\": 1}" 'final must be true or false'
bad "{\"genome\": [$genes], \"quantities\": [\"laii\"]}" "did you mean 'lai'?"
bad "$(printf '[%.0s' $(seq 100))" 'brackets'
bad "$(head -c 3000000 /dev/zero | tr '\0' x)" 'longer than 1048576 bytes'
bad $'{"id": "\xff"}' 'not valid JSON'

# Requests may contain only free genes; values beyond the bounds are allowed.
printf '\n[[traits]]\nname = "turns"\nfree = ["azimuth"]\n' >>campaigns/served.toml
turns=$(grep -o '"trait":"azimuth"[^}]*' hello.json |
    grep -o '"baseline":[^,]*' | cut -d : -f 2 | paste -s -d ,)
{
    echo "{\"id\": 1, \"genome\": [$turns]}"
    echo "{\"id\": 1, \"genome\": [$genes]}"
    echo "{\"id\": 2, \"genome\": [9,${genes#*,}]}"
} | "${serve[@]}" --quiet | figures /dev/stdin >free
[ "$(grep '"id":1' free | sort -u | wc -l)" = 1 ] || fail "$(cat free)"
grep -q '"id":2,"status":"done"' free || fail "beyond a bound: $(cat free)"
sed -i '/^\[\[traits\]\]/,$d' campaigns/served.toml

# Waits until a command succeeds. $1 a description, the rest the command.
await() {
    for _ in $(seq 300); do
        ! "${@:2}" || return 0
        sleep 0.1
    done
    fail "$1 did not happen: $(cat ./*.log)"
}
no_ranks() { ! pgrep -f "serve campaigns/served.toml --log-level debug" >/dev/null; }
serve+=(--log-level debug)
# The mpirun of MPICH cannot hold more than 64 KiB of unread input.
count=1400
! is_mpich || count=$((60000 / $(requests 1 | wc -c)))
requests $count >many

for start in "" "${ranks[*]}"; do
    # The client stops reading answers but keeps the input open: all ranks end
    # with a message and exit code 1.
    rm -f gone.code
    sleep 60 >in &
    feeder=$!
    { cat many - <in | {
        $start "${serve[@]}" 2>gone.log || echo $? >gone.code
        kill $feeder
    }; } | head -n 3 >gone.out || true
    [ "$(wc -l <gone.out)" = 3 ] || fail "$(cat gone.out)"
    grep -q "Z  ideotype: nobody reads the output any more" gone.log ||
        fail "$(cat gone.log)"
    [ "$(cat gone.code)" = 1 ] || fail "a closed pipe ends with $(cat gone.code)"
    await "the end of all ranks" no_ranks

    # A client that is killed closes both pipes.
    rm -f killed.log  # of the other way to start
    (trap "" PIPE && $start "${serve[@]}" <in >out 2>killed.log) &
    bash -c 'exec 3>in 4<out; printf "%s\n" "$(<many)" >&3
        while read -r -t 60 -u 4 line; do :; done' &
    client=$!
    await "the first evaluation" grep -q "line 5: worker" killed.log
    kill -KILL $client
    wait $client 2>/dev/null || true
    await "the end of all ranks" no_ranks
    wait

    # After a request to stop, pending requests are still answered.
    $start "${serve[@]}" <in >stopped.out 2>stopped.log &
    job=$!
    exec 3>in
    cat many >&3 &
    await "the first evaluation" grep -q "line 5: worker" stopped.log
    kill -USR1 $job
    code=0
    wait $job || code=$?
    exec 3>&-
    wait
    { [ $code -eq 5 ] || { [ -n "$start" ] && is_stopped $code; }; } ||
        fail "a stop ends with $code: $(cat stopped.log)"
    grep -q "stopped before the end of the input" stopped.log ||
        fail "$(cat stopped.log)"
    [ "$(grep -c ": worker " stopped.log)" = "$(grep -c '"status":"done"' stopped.out)" ] ||
        fail "an evaluated genome has no answer"
done

# If a worker is killed, the job ends and mpirun reports it.
"${ranks[@]}" "${serve[@]}" <in >lost.out 2>lost.log &
job=$!
exec 3>in
cat many >&3 &
await "the first evaluation" grep -q "line 5: worker" lost.log
kill -KILL "$(rank_of $job 2)"
code=0
wait $job || code=$?
exec 3>&-
wait
[ $code -eq "$(code_of_signal 9)" ] || fail "a killed rank ends with $code: $(cat lost.log)"
await "the end of all ranks" no_ranks

# The error for a missing campaign is printed once.
code=0
"${ranks[@]}" "$ideotype" serve campaigns/none.toml </dev/null >none.log 2>&1 || code=$?
[ $code -ne 0 ] || fail "no campaign is no error"
[ "$(grep -c "none.toml" none.log)" = 1 ] || fail "$(cat none.log)"

# The service is about as fast as a run with equally many evaluations.
"$project/tests/benchmark/serve_rate.sh" "$ideotype" campaigns/served.toml 200 3 ||
    fail "the rate cannot be measured"
