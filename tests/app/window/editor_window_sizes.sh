#!/bin/bash
# Drives the real window under a virtual display: makes it smaller, then larger, and keeps each time
# what the display shows (NAME.xwd) and what the editor drew (NAME.png), then leaves. Prints "exit:
# CODE". Arguments: the kerf executable and an empty folder, in which the display keeps its picture
# (-fbdir).
set -u
kerf=$1
folder=$2
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

hasPicture() { compgen -G 'kerf-*.png' >/dev/null; }
# Arguments: name, width, height.
keepPictures() {
    xdotool windowsize --sync "$window" "$2" "$3"
    rest
    cp Xvfb_screen0 "$1.xwd"
    xdotool key F12
    waitFor hasPicture
    rest
    mv kerf-*.png "$1.png"
}

openEditor
keepPictures smaller 900 560
keepPictures larger 1200 700
leaveEditor
