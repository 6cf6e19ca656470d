#!/bin/sh
# Draws the pictures of docs/pictures that docs/render.md shows, without a screen. Those of models and
# cities of others need SOMS_DATA, the folder of the test data; without it they are left as they are.
# Usage: tools/make_pictures.sh [soms-view [NAME...]]
set -eu
root=$(CDPATH= cd -- "$(dirname -- "$0")/.." && pwd)
view=${1:-$root/build/release/bin/soms-view}
[ $# -eq 0 ] || shift
wanted=" $* "
out=$root/docs/pictures
most=300000  # bytes

draw() {
  name=$1
  shift
  case $wanted in "  " | *" $name "*) ;; *) return 0 ;; esac
  for word in "$@"; do
    case $word in
      /*.ply | /*.3ds) [ -f "$word" ] || { echo "$name: left as it is, $word is missing" >&2; return 0; } ;;
    esac
  done
  "$view" render "$@" -o "$out/$name.png"
  size=$(wc -c < "$out/$name.png")
  [ "$size" -le $most ] || { echo "$name.png has $size bytes, more than $most" >&2; exit 1; }
}

data=${SOMS_DATA:-/nonexistent}

draw city_contact --frame 60 --camera contact,0.7x --size 1200x675
draw city_above --frame 60 --spots --camera contact,215:40,0.06x --size 960x540

for level in 1 3 5 6; do
  draw "bunny_level_$level" "$data/ply/bun_zipper.ply" --up y --level $level --rule soms \
    --camera 200:15 --size 640x480
done
draw bunny_traversal "$data/ply/bun_zipper_res2.ply" --up y --mover "$data/ply/bun_zipper_res3.ply" \
  --mover-up y --pose "0.1 -0.04 0.05" --trace --rule soms --traversal e-node --descent larger --colors plain \
  --camera 200:20 --size 960x640

draw new_york "$data/cities/new_york_south.ply" "$data/cities/new_york_mid.ply" \
  --camera 200:28 --size 900x506
draw new_york_street "$data/cities/new_york_south.ply" --mover "$data/3ds/van_disim.3ds" --count 300 \
  --frame 30 --camera contact,0.55x --size 960x540
draw rotterdam "$data/cities/rotterdam.ply" --camera 300:30 --size 900x506
