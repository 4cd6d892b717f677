#!/usr/bin/env bash
# From the start of the program to a saved picture of a red glass ball on a floor with a soft shadow, by real mouse and
# keys in a real window; counts them. At most 10 are allowed. Usage: cargo build --release && crates/editor/window/red-glass-ball.sh
# SHOTS=folder keeps pictures of the window.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/window.sh"

start_display
start_program
shot 1-start
click 430 150 2      # Empty scene
shot 2-empty
click 225 52 1.5     # Sphere
shot 3-sphere
click 467 713 2      # Red glass
shot 4-red-glass
press ctrl+p 1.5     # Save picture
shot 5-save
press Return 1       # Render and save

picture=$VITRINE_HOME/untitled.png
for _ in $(seq 100); do [ -s "$picture" ] && break; sleep 0.2; done
[ -s "$picture" ] || { shot failed; echo "no picture was saved" >&2; exit 1; }
sleep 0.5
shot 6-saved
cp "$picture" "$shots/red-glass-ball.png"

size=$(identify -format '%wx%h' "$picture")
# The middle of the ball is red, the floor in front of it is grey.
read -r red green blue < <(convert "$picture" -crop 40x40+460+280 +repage -resize 1x1\! -format '%[fx:int(255*r)] %[fx:int(255*g)] %[fx:int(255*b)]\n' info:)
read -r floor_red floor_green < <(convert "$picture" -crop 40x40+100+600 +repage -resize 1x1\! -format '%[fx:int(255*r)] %[fx:int(255*g)]\n' info:)
echo "$inputs clicks and keys; picture of $size; ball rgb($red, $green, $blue), floor rgb($floor_red, $floor_green, …)"
[ "$size" = 960x720 ]
[ "$red" -gt $((green + 40)) ] && [ "$red" -gt $((blue + 40)) ]
[ $((floor_red - floor_green)) -lt 20 ]
[ "$inputs" -le 10 ]
echo passed
