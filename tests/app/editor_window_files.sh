#!/bin/bash
# Drives the real window under a virtual display: opens ball.obj by the dialog, exports it as
# whole.obj, opens slow.obj with a reader that never answers, cancels that and leaves. Prints what it
# saw, one "name: value" a line. Arguments: the kerf executable and the folder of the models.
set -u
kerf=$1
folder=$2
cd "$folder" || exit 1
# GLFW unloads the display's drivers at the end, and what they had kept then looks lost.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"
export XDG_STATE_HOME="$folder/state"
# Reads every model as kerf does, but slow.obj never.
cat >reader.sh <<EOF
#!/bin/sh
case "\$*" in *slow.obj) echo \$\$ >reader.pid; exec sleep 100 ;; esac
exec "$kerf" "\$@"
EOF
chmod +x reader.sh

KERF_EXECUTABLE="$folder/reader.sh" "$kerf" 2>errors.txt &
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
hasBall() { title | grep -q -- '^Kerf - ball'; }
hasExport() { [ -s whole.obj ]; }
readerRuns() { [ -s reader.pid ]; }
readerIsGone() { ! kill -0 "$(cat reader.pid)" 2>/dev/null; }
hasLeft() { ! kill -0 "$editor" 2>/dev/null; }
# The dialog is drawn a moment after its key, and takes what is typed from then on.
typeName() {
    sleep 1
    xdotool type --delay 60 "$1"
    sleep 0.5
    xdotool key Return
}

xdotool windowfocus "$window"
xdotool key ctrl+o
typeName ball.obj
waitFor hasBall
echo "opened: $(title)"

xdotool key ctrl+e
typeName whole.obj
waitFor hasExport
echo "exported: $(ls whole.obj)"

xdotool key ctrl+o
typeName slow.obj
waitFor readerRuns
sleep 1
readerIsGone || echo "loading: $(title)"
xdotool key F12
waitFor compgen -G 'kerf-*.png' >/dev/null
xdotool key Escape
waitFor readerIsGone
echo "cancelled: $(title)"

xdotool key ctrl+q
waitFor hasLeft
wait "$editor"
echo "exit: $?"
