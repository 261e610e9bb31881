#!/bin/bash
# Drives the real window under a virtual display: the driver is reset again and again, faster than
# anybody works. Prints what it saw, one "name: value" a line. Arguments: the kerf executable and a
# folder with ball.obj.
set -u
kerf=$1
folder=$2
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

export KERF_LOSE_CONTEXT="$folder/lose"
# A window that rests asks the driver nothing: the pointer wakes it.
resetsUntilItLeaves() {
    touch "$KERF_LOSE_CONTEXT"
    xdotool mousemove $((300 + RANDOM % 300)) 300
    hasLeft
}
openEditor "Kerf - ball" ball.obj
rest
echo "recent: $(cat "$XDG_STATE_HOME/kerf/recent-files")"
waitFor resetsUntilItLeaves
hasLeft || kill -9 "$editor"
wait "$editor"
echo "exit: $?"
