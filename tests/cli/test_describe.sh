#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The manual page and what shells complete have each verb and option of --help.
. "$(dirname "$0")/common.sh"

for form in man bash zsh; do
    "$ideotype" --describe "$form" >"made_$form"
done
expect 2 "$ideotype" --describe fish
expect 0 "$ideotype" --help
! grep -q describe out.log || fail "--describe is for packagers only"
sed 's/\\-/-/g' made_man >plain
. ./made_bash

# Completes the last word of a command line; the answer is in COMPREPLY.
complete_words() {
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
    _ideotype
    echo "${COMPREPLY[*]}" >out.log
}

# Names of options in a --help on standard input.
options() {
    sed -n 's/^  \(-[-a-z,]*\).*/\1/p' | tr ',' '\n'
}

mapfile -t verbs < <("$ideotype" --help | sed '1,/^Subcommands/d' |
    sed -n 's/^  \([a-z]*\) .*/\1/p')
[ ${#verbs[@]} -ge 11 ] || fail "too few verbs: ${verbs[*]}"
complete_words ideotype ""
for verb in "${verbs[@]}"; do
    grep -qw -- "$verb" out.log || fail "bash does not complete $verb"
    grep -q "^ *'$verb:" made_zsh || fail "zsh does not complete $verb"
    grep -qx "\.SS $verb" plain || fail "no section of $verb"
done
! grep -B1 '^$' made_man | grep '^\.TP' || fail "an option without words"
count=0
for verb in "${verbs[@]}"; do
    sed -n "/^\.SS $verb\$/,/^\.SS/p" plain >section
    expect 0 "$ideotype" "$verb" --help
    ! grep -E "ENUM|value in|->" out.log || fail "not names of values"
    says "^  ideotype $verb "
    grep -q "ideotype $verb " section || fail "the page has no example of $verb"
    complete_words ideotype "$verb" -
    grep "^ *$verb) " made_zsh >zsh_case
    while read -r option; do
        grep -q -- "^.*\\\\fB.*$option\\b" section ||
            fail "the page lacks $verb $option"
        grep -qF -- " $option " <(sed 's/.*/ & /' out.log) ||
            fail "bash lacks $verb $option"
        grep -qF -- "${option}[" zsh_case || fail "zsh lacks $verb $option"
        count=$((count + 1))
    done < <("$ideotype" "$verb" --help | options)
done
[ $count -gt 80 ] || fail "too few options: $count"

complete_words ideotype evaluate --bou
says "^--boundary$"
complete_words ideotype evaluate --boundary p
says "^periodic$"
complete_words ideotype run --out ""
says "^$"  # the shell's own completion takes over, of files
grep -q "'--isa\[.*:value:(sse2 " made_zsh || fail "zsh lacks values of --isa"
