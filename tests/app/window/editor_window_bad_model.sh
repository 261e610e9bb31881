#!/bin/bash
# Drives the real window under a virtual display: starts the editor with bad.obj, which can't be cut,
# keeps a picture of what it says, and leaves. Prints what it saw, one "name: value" a line.
# Arguments: the kerf executable and the folder of the model.
set -u
kerf=$1
folder=$2
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

openEditor 'Kerf' bad.obj
rest
echo "opened: $(title)"
xdotool key Escape
leaveEditor
