#!/bin/bash
# Drives the real window under a virtual display: opens ball.obj by the dialog, exports it as
# whole.obj, opens slow.obj with a reader that never answers, cancels that and leaves. Prints what it
# saw, one "name: value" a line. Arguments: the kerf executable and the folder of the models.
set -u
kerf=$1
folder=$2
source "$(dirname "${BASH_SOURCE[0]}")/window_driver.sh"

# Reads every model as kerf does, but slow.obj never.
cat >reader.sh <<EOF
#!/bin/sh
case "\$*" in *slow.obj\ *) echo \$\$ >reader.pid; exec sleep 100 ;; esac
exec "$(dirname "$kerf")/kerf-import" "\$@"
EOF
chmod +x reader.sh

hasBall() { title | grep -q -- '^Kerf - ball'; }
hasExport() { [ -s whole.obj ]; }
readerRuns() { [ -s reader.pid ]; }
readerIsGone() { ! kill -0 "$(cat reader.pid)" 2>/dev/null; }
# The dialog is drawn a moment after its key, and takes what is typed from then on.
typeName() {
    sleep 1
    xdotool type --delay 60 "$1"
    sleep 0.5
    xdotool key Return
}

export KERF_IMPORT="$folder/reader.sh"
openEditor
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
# Sooner than a reader that never answers is ended anyway (30 s).
within 10 readerIsGone && echo "cancelled: $(title)"

leaveEditor
