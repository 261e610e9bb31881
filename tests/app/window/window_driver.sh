# For scripts that drive the real window under a virtual display; to be sourced once `kerf` (the
# executable) and `folder` (theirs alone) are set. Prints nothing.
cd "$folder" || exit 1
# The settings of whoever runs the tests stay out of it.
export XDG_CONFIG_HOME="$folder/config"
export XDG_STATE_HOME="$folder/state"
# The driver is examined by tests of its own.
export KERF_EXAMINES_DRIVER=no
# Not what the driver has compiled, which takes long.
export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}}"
export XDG_CACHE_HOME="$folder/cache"
# GLFW unloads the display's drivers at the end, and what they had kept then looks lost.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"

# Starts the editor and gives its window the keyboard. Arguments: what its title begins with (else
# "Kerf - "), and those of the editor (else a session with a ball).
openEditor() {
    local ball
    ball=$(dirname "$kerf")/../assets/sessions/drop-in.kerf.json
    "$kerf" "${@:2}" $([ $# -gt 1 ] || echo "$ball") 2>errors.txt &
    editor=$!
    trap 'kill "$editor" 2>/dev/null' EXIT
    findWindow "${1:-Kerf - }"
}
# Gives the window whose title begins so the keyboard, once it is there.
findWindow() {
    window=$(timeout 60 xdotool search --sync --onlyvisible --name "^$1" | head -n 1)
    xdotool windowfocus "$window"
}
title() { xdotool getwindowname "$window"; }
# Waits so many seconds for a command to succeed, and fails where it does not.
within() {
    for _ in $(seq $(($1 * 5))); do
        "${@:2}" && return
        sleep 0.2
    done
    return 1
}
# Two minutes: the machine may be slow.
waitFor() { within 120 "$@"; }
# Processor time of the editor so far, in hundredths of a second.
ticks() { awk '{print $14 + $15}' "/proc/$editor/stat"; }
# A thread of it would work if it had a processor: on a busy machine it may wait for one long.
wantsProcessor() { cat /proc/"$editor"/task/*/stat 2>/dev/null | grep -q ') R '; }
# Nothing moves: a still picture costs nothing.
isIdle() {
    local before
    before=$(ticks)
    for _ in 1 2 3 4 5; do
        sleep 0.2
        ! wantsProcessor || return 1
    done
    [ $(($(ticks) - before)) -le 1 ]
}
rest() { waitFor isIdle; }
hasLeft() { ! kill -0 "$editor" 2>/dev/null; }
# A key that comes before the window has the keyboard back from a dialog is lost.
leaves() {
    hasLeft || xdotool key ctrl+q
    sleep 0.5
    hasLeft
}
# Leaves by the keyboard and says how that went.
leaveEditor() {
    waitFor leaves
    hasLeft || kill "$editor"
    wait "$editor"
    echo "exit: $?"
}
