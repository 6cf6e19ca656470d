#!/bin/sh
# Draws the pictures of docs/pictures that docs/render.md and docs/view.md show, without a screen: the
# window's on a display of xvfb-run. Those of models and cities of others need SOMS_DATA, the folder of the test data; without it they are left as they are.
# Usage: tools/make_pictures.sh [soms-view [NAME...]]
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
view=${1:-$root/build/release/bin/soms-view}
[ $# -eq 0 ] || shift
wanted=" $* "
out=$root/docs/pictures
most=450000  # bytes

# draw NAME[.svg] OPTIONS...: a PNG file, or the map of a point.
draw() {
  name=$1
  shift
  case $name in *.svg) file=$name ;; *) file=$name.png ;; esac
  case $wanted in "  " | *" $name "*) ;; *) return 0 ;; esac
  for word in "$@"; do
    case $word in
      /*.ply | /*.3ds | /*.obj | /*.gltf) [ -f "$word" ] || { echo "$name: left as it is, $word is missing" >&2; return 0; } ;;
    esac
  done
  "$view" render "$@" -o "$out/$file"
  check_size "$file"
}

check_size() {
  size=$(wc -c < "$out/$1")
  [ "$size" -le $most ] || { echo "$1 has $size bytes, more than $most" >&2; exit 1; }
}

# shot NAME OPTIONS...: the window with its panels, on a display of its own.
shot() {
  name=$1
  shift
  case $wanted in "  " | *" $name "*) ;; *) return 0 ;; esac
  [ -f "$1" ] || { echo "$name: left as it is, $1 is missing" >&2; return 0; }
  command -v xvfb-run > /dev/null || { echo "$name: left as it is, xvfb-run is missing" >&2; return 0; }
  LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1600x1200x24" \
    "$view" view "$@" --screenshot "$out/$name.png" --with-panels
  check_size "$name.png"
}

data=${SOMS_DATA:-/nonexistent}

draw city_contact --frame 60 --camera contact,1.5x --size 1200x675
draw city_above --frame 60 --camera contact,215:40,0.09x --size 960x540

for level in 1 3 5 6; do
  draw "bunny_level_$level" "$data/ply/bun_zipper.ply" --up y --level $level --tree rule=soms \
    --camera 200:15 --size 640x480
done
draw bunny_traversal "$data/ply/bun_zipper_res2.ply" --up y --mover "$data/ply/bun_zipper_res3.ply" \
  --mover-up y --pose "0.1 -0.04 0.05" --trace --tree rule=soms,traversal=e-node,descent=larger --colors plain \
  --camera 200:20 --size 960x640
draw thesis_right "$data/ply/bun_zipper_res4.ply" --mover "$data/ply/bun_zipper_res4.ply" --test right \
  --thesis --trace --colors plain --camera 200:20 --size 960x640
shot window_thesis "$data/ply/bun_zipper_res4.ply" --mover "$data/ply/bun_zipper_res4.ply" --test right \
  --thesis --frame 24 --frames 24 --size 1200x760 --up y --mover-up y

draw new_york "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" \
  --scale 1 --camera 200:28 --size 900x506
draw new_york_street "$data/cities/new_york_south.ply" --mover "$data/3ds/van_disim.3ds" --count 300 --seed 4 \
  --frame 30 --scale 1 --camera contact --size 960x540
draw pipes "$data/clash/structure.obj" --scale 1 --up z --mover "$data/clash/services.gltf" --pose "0 0 0" \
  --camera contact,30:35 --size 960x540
draw rotterdam "$data/cities/rotterdam.ply" --scale 1 --camera 300:30 --size 900x506
draw new_york_depth "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" --depth \
  --camera "-3400 -8300 300 -2300 -5500 60" --size 900x506
draw new_york_sight "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" \
  --visible-from=-1500,-5200,350 --camera 200:28 --size 900x506
draw rotterdam_sight.svg "$data/cities/rotterdam.ply" --visible-from 0,0,60
