# Completion of canonical-pose in bash: commands, options and their values, as the tool lists them; otherwise files.
_canonical_pose()
{
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words="" help
  if ((COMP_CWORD == 1)); then
    words="--help --version $(canonical-pose --help 2>/dev/null | awk '/^Subcommands:/ { found = 1; next } found { print $1 }')"
  else
    help=$(canonical-pose "${COMP_WORDS[1]}" --help 2>/dev/null)
    if [[ $before == -* ]]; then
      words=$(awk -v option="$before" '{ split($1, names, ",")
        for(i in names) if(names[i] == option && match($2, /\{.*\}/)) print substr($2, RSTART + 1, RLENGTH - 2) }' <<<"$help")
      words=${words//,/ }
    fi
    if [[ $word == -* ]]; then
      words=$(awk '/^ +-/ { gsub(",", " ", $1); print $1 }' <<<"$help")
    fi
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _canonical_pose canonical-pose
