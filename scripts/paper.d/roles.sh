# roles.sh - the mesh, title, view and corners of each surface; a surface is called by its role.

real=no
[ ! -d "$meshes" ] || real=yes

# mesh ROLE: prints the mesh file of a surface; without real meshes mkmesh makes one of its kind.
mesh() {
	if [ $real = yes ]; then
		case $1 in
		man)      echo "$meshes/face_man_scan_6k.off" ;;
		woman)    echo "$meshes/face_woman_17k.off" ;;
		mask)     echo "$meshes/face_nefertiti_4.6k.off" ;;
		neutral)  echo "$meshes/face_neutral_1875.obj" ;;
		smile)    echo "$meshes/face_smile_1656.obj" ;;
		cortex)   echo "$meshes/cortex_fs5_lh_ball.off" ;;
		flatcuts) echo "$meshes/cortex_fs5_lh_flatcuts.off" ;;
		molar)    echo "$meshes/tooth_orangutan_edj_14k.off" ;;
		lemur)    echo "$meshes/tooth_lemur_B03.off" ;;
		buddha)   echo "$meshes/buddha_laughing_15k.off" ;;
		spiral)   echo "$meshes/spiral_synthetic.off" ;;
		moebius)  echo "$meshes/moebius_part.obj" ;;
		bunny)    echo "$meshes/bunny_28k.ply" ;;
		camel)    echo "$meshes/camelhead_11k.off" ;;
		hemisphere) echo "$meshes/cortex_hemisphere_48k.ply" ;;
		esac
		return
	fi
	case $1 in
	man)      make_mesh man face ;;
	woman)    make_mesh woman face nose=0.5 smile=0.5 ;;
	cortex)   make_mesh cortex cortex ;;
	molar)    make_mesh molar tooth ;;
	lemur)    make_mesh lemur tooth cusps=4 ;;
	buddha)   make_mesh buddha cap R=8 angle=110 ;;
	spiral)   make_mesh spiral spiral ;;
	moebius)  make_mesh moebius moebius ;;
	esac
}

make_mesh() {
	file=$w/$1.off
	shift
	[ -e "$file" ] || run mkmesh -q -n $((cells*24)) "$@" -o "$file"
	echo "$file"
}

if [ $real = yes ]; then
	kinds='man woman cortex molar buddha mask neutral smile lemur'
else
	kinds='man woman cortex molar buddha lemur'
fi

title() {
	case $1 in
	man)     echo 'human face (man)' ;;
	woman)   echo 'human face 2 (woman)' ;;
	mask)    echo 'face (Nefertiti)' ;;
	neutral) echo 'face scan, neutral' ;;
	smile)   echo 'face scan, smiling' ;;
	cortex)  echo 'cortical surface' ;;
	flatcuts) echo 'cortex, cut' ;;
	molar)   echo 'tooth (orangutan)' ;;
	lemur)   echo 'tooth (lemur)' ;;
	buddha)  echo 'Buddha' ;;
	spiral)  echo 'spiral' ;;
	moebius) echo 'part of a Moebius strip' ;;
	bunny)   echo 'bunny' ;;
	camel)   echo 'head of a camel' ;;
	hemisphere) echo 'half a cortex' ;;
	esac
}

# view ROLE: prints the options of render.py for a good view of the surface.
view() {
	case $real-$1 in
	yes-man)    echo --from=-0.45,-0.1,1 --up=0.03,1,0 ;;
	yes-cortex) echo --from=-1,0,0.1 --up=0,0,1 ;;
	yes-buddha) echo --from=0,-1,0.2 --up=0,0,1 ;;
	*-statue)   echo --from=-0.3,-0.7,1 --up=0,1,0 ;;
	*-molar|*-lemur) echo --from=0.3,-0.5,1 ;;
	yes-bunny)  echo --from=0.2,0.3,1 ;;
	yes-camel)  echo --from=1,0.3,0.4 ;;
	yes-hemisphere) echo --from=-1,0,0.1 --up=0,0,1 ;;
	*-spiral)   echo --from=.2,.5,1 ;;
	no-cortex)  echo --from=0,-0.4,1 ;;
	*)          echo --from=0,0,1 ;;
	esac
}

# chart ROLE: prints options of mesh2rect: the corners, chosen so that the human faces (man, woman)
# are upright on the rectangle; for the Buddha also --flip, so that its normals point outward.
chart() {
	case $real-$1 in
	yes-man)    echo '-c -66,-34,-888;21,-42,-811;29,90,-830;-70,100,-877' ;;
	yes-woman)  echo '-c -.045,.19,.05;.045,.19,.05;.05,.3,.08;-.05,.3,.08' ;;
	yes-buddha) echo '--flip -c -20,-6,-10;-6,-6,-10;-6,7,-10;-20,7,-10' ;;
	esac
}

# turned ROLE: prints the same options without the corners, for use with --like, which chooses them.
turned() { [ "$real-$1" != yes-buddha ] || echo --flip; }
