#!/bin/bash
# Drives the real window under a virtual display: opens the editor, does what a file of acts says and
# leaves by the keyboard. Prints what it saw, one "name: value" a line. Arguments: the kerf
# executable, an empty folder, the file of acts (shell lines that use the functions below).
set -u
kerf=$1
folder=$2
acts=$3
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

titleEnds() { [[ $(title) == *"$1" ]]; }
hasFile() { compgen -G "$1" >/dev/null; }
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

openEditor
echo "opened: $(title)"
source "$acts"
leaveEditor
