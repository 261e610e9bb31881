# shellcheck shell=bash
# The wheel of scripts/package: a Python package that holds the archive's programs and libraries.
# Sourced, after archive.sh.

# Pythons beside the system's own for which the wheel gets a module where their headers are there.
more_pythons='python3.12 python3.13'

# Those that are there, as a list of CMake.
more_pythons_here() {
    local name program
    for name in $more_pythons; do
        program=$(command -v "$name") || continue
        if "$program" -c 'import os, sys, sysconfig
sys.exit(not os.path.exists(sysconfig.get_path("include") + "/Python.h"))' 2>/dev/null; then
            printf '%s;' "$program"
        fi
    done
}

# build_modules FOLDER: the modules for further Pythons.
build_modules() {
    local found
    found=$(more_pythons_here)
    quietly cmake -DKERF_MORE_PYTHONS="${found%;}" "$1" || fail "CMake could not configure the build"
    build "$1" kerf_more_pythons
}

# fill_wheel ARCHIVE BUILD FOLDER: puts the package of the wheel there.
fill_wheel() {
    local package=$3/kerf module suffix
    mkdir -p "$package/program/lib"
    cp -r "$1/bin" "$1/libexec" "$package/program"
    cp -r "$1/lib/kerf" "$package/program/lib"
    mkdir "$package/program/share"
    cp -r "$1/share/kerf" "$1/share/doc" "$package/program/share"
    cp "$1"/lib/python3/dist-packages/kerf/* "$package"
    for module in $(find_modules "$2"); do
        suffix=${module##*/_native}
        strip -o "$package/_native$suffix" "$module"
        patchelf --force-rpath --set-rpath "\$ORIGIN/program/lib/kerf" "$package/_native$suffix"
    done
}

# find_modules BUILD: those of the system's Python and of the further ones that are there.
find_modules() {
    local python suffix list
    list="/usr/bin/python3;$(more_pythons_here)"
    for python in ${list//;/ }; do
        suffix=$("$python" -c 'import sysconfig; print(sysconfig.get_config_var("EXT_SUFFIX"))')
        printf '%s\n' "$1/python/kerf/_native$suffix"
    done
}

# try_wheel WHEEL FOLDER SESSION: installs it into an environment of its own; the program, the
# package and its module come to one state.
try_wheel() {
    /usr/bin/python3 -m venv --system-site-packages "$2"
    "$2/bin/pip" install --quiet --no-index "$1"
    "$2/bin/kerf" replay "$3" --out "$2/replayed" --until 200
    "$2/bin/python" -c '
import json, sys, kerf
states = {json.load(open(sys.argv[2]))["state_hash"],
          kerf.replay(sys.argv[1], until=200)["state_hash"]}
simulation = kerf.Simulation.from_session(sys.argv[1])
simulation.step(200)
states.add(simulation.state_hash)
assert len(states) == 1, states
assert kerf.__file__.startswith(sys.prefix), kerf.__file__' "$3" "$2/replayed/summary.json"
}
