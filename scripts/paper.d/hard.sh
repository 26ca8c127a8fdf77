# hard.sh - reconstructs surfaces harder than those of the paper, and shows where the grid is too
# coarse for them.

# hard_row ROLE: one row of the table.
hard_row() {
	pair "$1" "$(mesh "$1")" "$cells"
	back "$1-lh" "$1-back"
	run lhdiff --no-hausdorff --no-self-intersections "$w/$1.lhg" "$w/$1-back.lhg" -o "$w/$1.diff"
	say "| $(title "$1"), \`$(basename "$(mesh "$1")")\` | $(short "$(number "$w/$1.diff" max_rel)" 100) % | $(short "$(number "$w/$1.diff" mean_rel)" 100) % |"
}

if [ $real = yes ]; then
	say '## Beyond the paper: ears and half a cortex' '' \
		"Grids of $((cells + 1)) x $((cells + 1)) nodes, K = 0; distance between corresponding nodes over sqrt(area)." \
		'The error sits where a few cells, tens of times wider than the others, hold a whole tip.' '' \
		'| surface | max | mean |' '|---|---|---|'
	for role in bunny camel hemisphere; do
		hard_row $role
	done
	say ''
	for role in bunny camel hemisphere; do
		where $role
	done
fi
