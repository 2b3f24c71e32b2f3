#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Ranks run out of memory: no result is recorded for plants that they could not
# evaluate, the user gets a message, and a resumed run ends as if undisturbed.
. "$(dirname "$0")/common.sh"
time_limit=(timeout 60)

# The scenes are large and the paths few. 200 MB are enough for MPI but not for
# these scenes.
write_campaign starved 4 2
sed -i 's/^rows = 3/rows = 20/; s/^plants = 3/plants = 20/; s/^paths = 256/paths = 16/' \
    campaigns/starved.toml
limit=200000
cat >starve.sh <<'EOF'
#!/bin/sh
# $1 the rank that is starved of memory, or all
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-$PMIX_RANK}}
[ "$1" != all ] && [ "$1" != "$rank" ] || ulimit -d "$LIMIT"
shift
exec "$@"
EOF
chmod +x starve.sh
export LIMIT=$limit
if ! ./starve.sh all "$ideotype" evaluate "$project/campaigns/ames_quick.toml" \
    --set field.rows=2 --set field.plants=2 >/dev/null 2>&1; then
    echo "THIS BUILD NEEDS MORE THAN $limit KB: NOT TESTED" >&2
    exit 0
fi
run=("$ideotype" run campaigns/starved.toml)
"${run[@]}" --out whole >whole.log
whole=$(history_of whole starved)

# Resumes the run in folder $1 and compares the result with the undisturbed run
# "expect".
goes_on() {
    says "could not evaluate .* on $(hostname): .*not enough memory"
    says "the machine failed, not the plant"
    says "Z  resume with"
    ! grep "evaluations of generation .* failed\|finalists failed" out.log ||
        fail "the machine's failure became the plants'"
    "$ideotype" status "$1" | grep -v "finished\|resume with\|--resume\|^(histories do not record options\|, 0 of 8\|, 0 failed" &&
        fail "rows have failed"
    expect 0 "${run[@]}" --out "$1" --resume
    same_results "$whole" "$(history_of "$1" starved)"
}
expect 1 ./starve.sh all "${run[@]}" --out alone
goes_on alone
expect 1 mpirun -n 3 ./starve.sh 1 "${run[@]}" --out worker
says "worker 1 could not"
goes_on worker

# The run is killed before its finalists are evaluated.
for _ in 1 2 3 4 5; do
    rm -rf finals finals.log
    "${run[@]}" --out finals >finals.log 2>&1 &
    job=$!
    until grep -qs "reached stop" finals.log; do sleep 0.01; done
    kill -KILL $job
    wait $job || true
    "$ideotype" status finals | grep -q finished || break
done
expect 1 mpirun -n 2 ./starve.sh 1 "${run[@]}" --out finals --resume
says "could not evaluate finalist 0"
goes_on finals

# Tests commands that evaluate one plant, and `serve`.
for LIMIT in 30000 "$limit"; do
    expect 1 ./starve.sh all "$ideotype" evaluate campaigns/starved.toml
    says "^ideotype: .*not enough memory"
done
genome=$(echo | "$ideotype" serve campaigns/starved.toml 2>/dev/null |
    grep -o '"baseline":[^,]*' | cut -d : -f 2 | paste -s -d ,)
echo "{\"genome\": [$genome]}" >request
expect 1 ./starve.sh all "$ideotype" serve campaigns/starved.toml <request
says "worker 0 could not evaluate .*not enough memory"
! grep '"status"' out.log || fail "an answer of a plant"

# A library cannot start a thread that it needs: the program reports the reason
# instead of being killed by a signal. Limits on the number of processes do not
# apply to root.
as_user=()
[ "$(id -u)" -ne 0 ] || as_user=(setpriv --reuid 65534 --clear-groups)
printf '#!/bin/bash\nulimit -u 1\nexec "$@"\n' >single.sh
chmod +x single.sh
as_user+=(./single.sh "$ideotype")
if "${as_user[@]}" --version >/dev/null 2>&1; then
    expect 1 "${as_user[@]}" evaluate campaigns/starved.toml
    says "^ideotype: a library ended the program (.*), usually for lack of"
else
    echo "ANOTHER USER CANNOT READ THIS BUILD: THREADS ARE NOT TESTED" >&2
fi
