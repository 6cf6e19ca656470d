#!/bin/sh
# Makes every file of docs/pictures, without a screen: the window's on a display of xvfb-run. Those of models and
# cities of others need SOMS_DATA, the folder of the test data; without it they are left as they are. `soms` is taken
# from the folder of soms-view, and limits_bench for limits.svg.
# Usage: tools/make_pictures.sh [soms-view [NAME...]], or --names, which lists all names.
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
if [ "${1:-}" = --names ]; then
  sed -n 's/^ *\(draw\|shot\|made\) "\{0,1\}\([a-z][a-z_0-9.$]*\).*/\2/p' "$0" |
    sed 's/\(.*\)\$level$/\11 \13 \15 \16/' | tr ' ' '\n'
  exit
fi
view=${1:-$root/build/release/bin/soms-view}
[ $# -eq 0 ] || shift
wanted=" $* "
out=$root/docs/pictures
most=450000  # bytes
soms=$(dirname -- "$view")/soms
models=$(mktemp -d)
trap 'rm -rf "$models"' EXIT

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

# made NAME COMMAND...: a file that a command writes there itself.
made() {
  name=$1
  shift
  case $wanted in "  " | *" $name "*) ;; *) return 0 ;; esac
  command -v "$1" > /dev/null || { echo "$name: left as it is, $1 is missing" >&2; return 0; }
  "$@" > /dev/null
  [ -d "$out/$name" ] || check_size "$name"
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

# A street of a generated city, and cars of their own.
"$soms" generate city --triangles 40000 --seed 3 -o "$models/town.obj" -q
"$soms" generate city --triangles 20000 -o "$models/town.ply" -q
"$soms" generate sedan -o "$models/sedan.ply" -q  # without parts: it is one body
"$soms" generate van -o "$models/van.obj" -q
draw city_contact "$models/town.obj" --mover "$models/sedan.ply" --pose "-50.42 -74.9 -1.2 0.819152 0 0 0.573576" \
  --scale 1 --camera contact,335:15,1.4x --size 1200x675
draw town "$models/town.ply" --scale 1 --size 960x540
draw vehicles "$models/van.obj" --mover "$models/sedan.ply" --pose "1.2 -3.2 0" --no-gap --no-key \
  --camera scene,125:14,0.92x --size 960x480
draw city_above "$models/town.ply" --mover "$models/sedan.ply" --count 40 --frame 60 --no-ground --scale 1 --camera scene,215:38,1.1x \
  --size 960x540

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
draw new_york_depth "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" --scale 1 --depth \
  --camera "-3400 -8300 300 -2300 -5500 60" --size 900x506
draw new_york_sight "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" \
  --visible-from=-1500,-5200,350 --camera 200:28 --size 900x506
draw rotterdam_sight.svg "$data/cities/rotterdam.ply" --visible-from 0,0,60

made city.svg "$soms" simulate -q -o "$out/city.svg"
made terms python3 "$root/tools/draw_terms.py"
# Its times belong to those of docs/performance.md, so it is drawn by name alone.
limits() {
  "$(dirname -- "$view")/limits_bench" "$models" && cp "$models/limits.svg" "$out/limits.svg"
}
if [ "$wanted" != "  " ]; then
  made limits.svg limits
fi
