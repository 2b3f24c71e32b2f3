# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Completes verbs and options of ideotype, which the program itself tells by
# --help, and else files. zsh reads it after `autoload -U bashcompinit;
# bashcompinit`.
_ideotype() {
    local program=$1 word=${COMP_WORDS[COMP_CWORD]} verb=() words
    if ((COMP_CWORD > 1)); then
        verb=("${COMP_WORDS[1]}")
        [[ $word == -* ]] || return 0
    fi
    words=$("$program" "${verb[@]}" --help 2>/dev/null |
        sed -n 's/^  \([-a-z][-a-z,]*\).*/\1/p' | tr ',' '\n')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _ideotype ideotype
