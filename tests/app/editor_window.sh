#!/bin/bash
# Drives the real window under a virtual display: opens the editor, drags the blade through the
# model from top to bottom, saves a screenshot and leaves by the keyboard. Prints what it saw, one
# "name: value" a line. Arguments: the kerf executable, an empty folder, and what kerf gets.
set -u
kerf=$1
folder=$2
shift 2
cd "$folder" || exit 1
# The settings of whoever runs the tests stay out of it.
export XDG_CONFIG_HOME="$folder/config"
# GLFW unloads the display's drivers at the end, and what they had kept then looks lost.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"

"$kerf" "$@" 2>errors.txt &
editor=$!
trap 'kill "$editor" 2>/dev/null' EXIT

window=$(timeout 60 xdotool search --sync --onlyvisible --name '^Kerf - ' | head -n 1)
title() { xdotool getwindowname "$window"; }
# Waits for a command to succeed, up to two minutes: the machine may be slow.
waitFor() {
    for _ in $(seq 600); do
        "$@" && return
        sleep 0.2
    done
}
isCut() { title | grep -q -- '- 2 pieces$'; }
hasPicture() { compgen -G 'kerf-*.png' >/dev/null; }
hasLeft() { ! kill -0 "$editor" 2>/dev/null; }

xdotool windowfocus "$window"
echo "opened: $(title)"

xdotool mousemove 640 40 mousedown 1
for y in $(seq 60 40 660); do
    xdotool mousemove 640 "$y"
done
xdotool mouseup 1
waitFor isCut
echo "cut: $(title)"

xdotool key F12
waitFor hasPicture
echo "screenshot: $(compgen -G 'kerf-*.png')"

xdotool key ctrl+q
waitFor hasLeft
wait "$editor"
echo "exit: $?"
