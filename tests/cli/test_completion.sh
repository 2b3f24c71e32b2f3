#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests that bash completes all commands and options listed by --help.
. "$(dirname "$0")/common.sh"
. "$project/src/cli/completion.bash"

# Completes the last word of a command line, with the result in out.log.
complete_words() {
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _ideotype "$ideotype"
    echo " ${COMPREPLY[*]} " >out.log
}

# Reads --help from standard input and prints the names of options.
options() {
    sed -n 's/^  \(-[-a-z,]*\).*/\1/p' | tr ',' '\n'
}

mapfile -t commands < <("$ideotype" --help | sed '1,/^Commands:/d; /^Commands of the/,$d' |
    sed -n 's/^  \([a-z]*\) .*/\1/p')
[ ${#commands[@]} -ge 9 ] || fail "too few commands: ${commands[*]}"
complete_words ideotype ""
for command in "${commands[@]}"; do says " $command "; done
count=0
for command in "${commands[@]}"; do
    expect 0 "$ideotype" "$command" --help
    ! grep -E "ENUM|value in|->" out.log || fail "not names of values"
    says "^  ideotype $command "
    complete_words ideotype "$command" -
    while read -r option; do
        says " $option "
        count=$((count + 1))
    done < <("$ideotype" "$command" --help | options)
done
[ $count -gt 60 ] || fail "too few options: $count"

complete_words ideotype ev
says "^ evaluate $"
complete_words ideotype status --js
says "^ --json $"
# After the name of an option the shell completes file names.
complete_words ideotype run --out ""
says "^  $"
expect 0 bash -ic ". '$project/src/cli/completion.bash'; complete -p ideotype"
says "complete -o default -F _ideotype ideotype"
