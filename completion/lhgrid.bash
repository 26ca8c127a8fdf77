# bash completion for the programs of lhgrid: options and their words come from COMMAND --help.

_lhgrid() {
	local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} words
	# readline breaks words at "=": --map=vi is three words
	if [[ $cur == = ]]; then
		cur=
	elif [[ $prev == = && $COMP_CWORD -ge 2 ]]; then
		prev=${COMP_WORDS[COMP_CWORD-2]}
	fi
	COMPREPLY=()
	case $prev in
	--*)	# "--map=viridis|diverging": the words in small letters
		words=$("${COMP_WORDS[0]}" --help 2>/dev/null |
			sed -n "s/^ *\(-[a-zA-Z], \)\?$prev=\([^ ]*\).*/\2/p" | tr '|' '\n' | grep -x '[a-z0-9]*')
		[[ -z $words ]] || COMPREPLY=($(compgen -W "$words" -- "$cur")) ;;
	esac
	if [[ ${#COMPREPLY[@]} = 0 && $cur == -* ]]; then
		words=$("${COMP_WORDS[0]}" --help 2>/dev/null | sed -n 's/^ \{2,6\}-/-/p' |
			grep -o -- '--[a-zA-Z][a-zA-Z-]*=\?' | sort -u)
		COMPREPLY=($(compgen -W "$words" -- "$cur"))
		[[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace
	fi
	[[ ${#COMPREPLY[@]} != 0 ]] || COMPREPLY=($(compgen -f -- "$cur"))
}

complete -o filenames -F _lhgrid @COMMANDS@
