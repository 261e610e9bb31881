#!/bin/bash
# Drives the real window under a virtual display: cuts, ends the editor at a random moment, goes on
# from what it offers then, has the state checked and saves it as
# N.kerf.json. Prints "N: STROKES DONE MISSING" a round: how many strokes had come to their end, and
# whether the saved session lacks any of these. Arguments: the kerf executable, an empty folder, how
# many rounds, a seed, and how it ends: "kill" by SIGKILL, "reset" by one of the graphics driver,
# after which the same process opens a new window.
set -u
kerf=$1
folder=$2
rounds=$3
RANDOM=$4
end=$5
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

export KERF_LOSE_CONTEXT="$folder/lose"
middle=640
moveTo() { xdotool mousemove "$1" "$2"; }
# A stroke from top to bottom, or a part of it: so many tenths. The last one lets go.
stroke() {
    local x=$((middle - 120 + RANDOM % 240)) lean=$((RANDOM % 120 - 60))
    moveTo "$x" 60
    xdotool mousedown 1
    for i in $(seq "$1"); do
        moveTo $((x + lean * i / 10)) $((60 + 58 * i))
        sleep 0.02
    done
    [ "$1" -lt 10 ] || xdotool mouseup 1
}
# Something else that is kept: weight, one change taken back, time.
other() {
    case $((RANDOM % 4)) in
        0) xdotool key v ;;
        1) xdotool key ctrl+z ;;
        2) xdotool key space && sleep 0.4 && xdotool key space ;;
    esac
}
# The editor says so when its first window is gone; the next one may have the same number.
wasReset() { grep -q 'was reset' errors.txt; }
resetDriver() {
    touch "$KERF_LOSE_CONTEXT"
    moveTo 700 300
    waitFor wasReset
    xdotool mouseup 1
    findWindow "Kerf - "
}
killEditor() {
    kill -9 "$editor"
    wait "$editor" 2>/dev/null
    xdotool mouseup 1
}
savedAs() { [ -s "$1" ]; }
noJournals() { ! compgen -G "$XDG_STATE_HOME/kerf/journal/*.journal" >/dev/null; }

# Cuts, and is killed: in the midst of a stroke, soon after one, or while something else is done.
round() {
    openEditor
    rest
    strokes=$((1 + RANDOM % 2))
    for _ in $(seq "$strokes"); do
        stroke 10
        rest
        other
        rest
    done
    case $((RANDOM % 3)) in
        0) stroke $((2 + RANDOM % 7)) ;;
        1) stroke 10 ;;
        2) other ;;
    esac
    sleep "0.$((RANDOM % 10))"
    if [ "$end" = kill ]; then
        killEditor
        openEditor
    else
        resetDriver
    fi
}

# Takes the offer, which is the first choice; without it nothing would be there to be saved.
goOn() {
    rest
    xdotool key Return
    rest
    xdotool key shift+c
    rest
    xdotool key ctrl+s
    rest
    xdotool type --delay 40 "$1"
    sleep 0.3
    xdotool key Return
    waitFor savedAs "$1.kerf.json"
    rest
    leaveEditor >exit.txt
}

for n in $(seq "$rounds"); do
    round
    goOn "$n"
    lifts=$(grep -o '"type":"lift"' "$n.kerf.json" | wc -l)
    echo "$n: $strokes $lifts $([ "$lifts" -ge "$strokes" ] && echo complete || echo MISSING) $(cat exit.txt)"
    waitFor noJournals || echo "journal: left"
done
trap - EXIT
echo "end: reached"
