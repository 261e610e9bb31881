#!/bin/bash
# Drives the real window under a virtual display: opens the editor, does what a file of acts says and
# leaves by the keyboard. Prints what it saw, one "name: value" a line. Arguments: the kerf
# executable, an empty folder, the file of acts (shell lines that use the functions below).
set -u
kerf=$1
folder=$2
acts=$3
cd "$folder" || exit 1
# The settings of whoever runs the tests stay out of it.
export XDG_CONFIG_HOME="$folder/config"
export XDG_STATE_HOME="$folder/state"
# GLFW unloads the display's drivers at the end, and what they had kept then looks lost.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"

"$kerf" 2>errors.txt &
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
titleEnds() { [[ $(title) == *"$1" ]]; }
hasFile() { compgen -G "$1" >/dev/null; }
hasLeft() { ! kill -0 "$editor" 2>/dev/null; }
# Processor time of the editor so far, in hundredths of a second.
ticks() { awk '{print $14 + $15}' "/proc/$editor/stat"; }
# Nothing moves: a still picture costs nothing.
isIdle() {
    local before
    before=$(ticks)
    sleep 1
    [ $(($(ticks) - before)) -le 1 ]
}
rest() { waitFor isIdle; }
# Says the title once it ends like this.
see() {
    waitFor titleEnds "$2"
    echo "$1: $(title)"
}
# Says the name of a file once it is there.
seeFile() {
    waitFor hasFile "$2"
    echo "$1: $(compgen -G "$2")"
}

xdotool windowfocus "$window"
echo "opened: $(title)"
source "$acts"
xdotool key ctrl+q
waitFor hasLeft
wait "$editor"
echo "exit: $?"
