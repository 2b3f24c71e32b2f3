# SPDX-License-Identifier: Apache-2.0 shellcheck shell=bash Completes commands
# and options of ideotype, read from its --help, and otherwise files. For zsh,
# source it after `autoload -U bashcompinit; bashcompinit`.
_ideotype() {
    local program=$1 word=${COMP_WORDS[COMP_CWORD]} command=() words
    if ((COMP_CWORD > 1)); then
        command=("${COMP_WORDS[1]}")
        [[ $word == -* ]] || return 0
    fi
    words=$("$program" "${command[@]}" --help 2>/dev/null |
        sed -n 's/^  \([-a-z][-a-z,]*\).*/\1/p' | tr ',' '\n')
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _ideotype ideotype
