# shellcheck shell=bash disable=SC2034
# What the scripts share: messages, packages, the build. Sourced, after `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cores=$(nproc)

say() { printf 'kerf: %s\n' "$*" >&2; }

fail() {
    say "$*"
    exit 1
}

# Each line: a package of Debian 12 and 13, and why it is needed.
build_packages='
g++                 compiles C++20
cmake               configures the build
ninja-build         runs the build
pkg-config          finds libraries that have no CMake package
python3-glad        generates the OpenGL loader
libegl-dev          makes OpenGL contexts without a window
libgl1-mesa-dri     draws and computes where there is no GPU
libglfw3-dev        opens the window
libimgui-dev        draws the panels
libeigen3-dev       does linear algebra
libassimp-dev       reads model files
libpugixml-dev      reads XML
zlib1g-dev          is linked by assimp, and unpacks files of VTK
libcli11-dev        reads the command line
nlohmann-json3-dev  reads and writes session files
libspdlog-dev       writes the log
libboost-context-dev  lets steps rest while pictures are drawn
libstb-dev          reads and writes pictures
libturbojpeg0-dev   reads JPEG pictures
fonts-dejavu-core   is the font of the panels
nettle-dev          hashes states and files
libsqlite3-dev      keeps what is done for recovery
libcgal-dev         unites pieces that cross, in a program of its own
'
python_packages='
python3-dev         compiles modules for Python
pybind11-dev        makes the module of C++
python3-numpy       is the arrays of the module, and remakes the builtin models
'
lab_packages='
python3-matplotlib  plots in the reports of experiments, and in the examples for Python
python3-scipy       solves the finite elements beside Kerf
'
bare_packages='
debootstrap         makes a bare Debian
'
test_packages='
libgtest-dev        runs the tests
libgmock-dev        offers the tests matchers
xvfb                is a display for the window tests
xauth               lets programs onto that display
xdotool             moves the mouse in the window tests
python3-jsonschema  checks sessions by their JSON Schema
glslang-tools       is the reference compiler of shaders
ffmpeg              makes films, and reads them again
universal-ctags     tells scripts/house the classes and functions
'
quirk_packages='
glslang-tools       makes SPIR-V of shaders
spirv-tools         makes it text, and text it
spirv-cross         makes it GLSL again
'
zink_packages='
mesa-vulkan-drivers  is the Vulkan driver below zink
'
bench_packages='
libbullet-dev       is the peer of projecting constraints
xvfb                is a display for the benchmark of the window
xauth               lets it onto that display
'
package_packages='
dpkg-dev            finds the packages that a package needs
lintian             checks it
desktop-file-utils  checks its desktop entry
libxml2-utils       checks what it tells desktops
patchelf            tells programs where their own libraries lie
python3-venv        tries the wheel
'
docs_packages='
python3-sphinx      makes a site of the pages
python3-myst-parser  reads them as Markdown
furo                is its theme: dark and light, wide and narrow
libjs-katex         draws formulas without a network
ffmpeg              makes films
'
format_packages='
clang-format        checks the layout of the code
'
fuzz_packages='
clang               compiles what libFuzzer drives
libclang-rt-dev     is libFuzzer and the sanitizers of clang
llvm                names the functions in reports of the sanitizers
'
coverage_packages='
gcovr               sums up which lines the tests ran
'
tidy_packages='
clang-tidy          checks the code for likely mistakes and for names
'

is_installed() {
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# The lines of "$1" whose package is not installed.
missing_lines() {
    local name why
    while read -r name why; do
        if [[ -n $name ]] && ! is_installed "$name"; then
            printf '%s %s\n' "$name" "$why"
        fi
    done <<<"$1"
}

# Runs a command; the end of its output is shown only where it fails.
quietly() {
    local log status=0
    log=$(mktemp)
    "$@" >"$log" 2>&1 || status=$?
    if [[ $status != 0 ]]; then
        tail -n 30 "$log" >&2
    fi
    rm -f "$log"
    return "$status"
}

run_apt() { quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@"; }

# ensure_packages LINES: installs what is missing of them, and says what and why.
ensure_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "this is no Debian system, so nothing is installed; what is needed stands in scripts/lib/common.sh."
        return
    fi
    local missing names name why
    missing=$(missing_lines "$1")
    if [[ -z $missing ]]; then
        return
    fi
    names=()
    say "installing with apt:"
    while read -r name why; do
        names+=("$name")
        printf '  %-19s %s\n' "$name" "$why" >&2
    done <<<"$missing"
    become_root "${names[*]}"
    run_apt update || say "apt-get update failed in part (see above); going on with the lists at hand"
    run_apt install --yes --no-install-recommends "${names[@]}" ||
        fail "apt-get install failed (see above); check the network and the package sources, then try again"
}

# Sets as_root to what makes a command run as root: nothing, or sudo.
become_root() {
    as_root=()
    if [[ $(id -u) == 0 ]]; then
        return
    fi
    command -v sudo >/dev/null ||
        fail "installing needs root or sudo, and you have neither; ask somebody to run: apt-get install $1"
    sudo -v || fail "sudo did not let you install; ask somebody to run: apt-get install $1"
    as_root=(sudo)
}

# configure PRESET FOLDER [OPTION...]: only where it has not been done with these options on, such as
# KERF_TESTS; ninja sees later changes itself. Tests and Python are left out unless they are named.
configure() {
    local preset=$1 folder=$2 option missing=
    local -a switches=()
    shift 2
    for option in "$@"; do
        switches+=("-D$option=ON")
        grep -qs "^$option:BOOL=ON" "$folder/CMakeCache.txt" || missing=yes
    done
    if [[ -f $folder/build.ninja && -z $missing ]]; then
        return
    fi
    for option in KERF_TESTS KERF_PYTHON; do
        if [[ ! -f $folder/CMakeCache.txt && " $* " != *" $option "* ]]; then
            switches+=("-D$option=OFF")
        fi
    done
    say "configuring $preset in $folder"
    (cd "$root" && quietly cmake --preset "$preset" "${switches[@]}") ||
        fail "CMake could not configure the build (see above)"
}

# build FOLDER TARGET: quiet where there is nothing to do.
build() {
    cmake --build "$1" --target "$2" --parallel "$cores" |
        sed -u -e '/no work to do/d' -e '/Re-checking globbed/d' -e '/Entering directory/d' >&2
}

# The build folder of a preset.
folder_of() {
    case $1 in
        release) printf '%s/build\n' "$root" ;;
        *) printf '%s/build-%s\n' "$root" "$1" ;;
    esac
}

# use_driver NAME: what runs from here on draws and computes with that one of Mesa's drivers.
use_driver() {
    export LIBGL_ALWAYS_SOFTWARE=1
    case $1 in
        llvmpipe) return ;;
        zink) export ZINK_DEBUG=noreorder ZINK_INLINE_UNIFORMS=0 GALLIUM_THREAD=0 ;;
        zink-as-it-is) ;;
        *) fail "there is no driver '$1' here; there are llvmpipe, zink and zink-as-it-is." ;;
    esac
    ensure_packages "$zink_packages"
    export MESA_LOADER_DRIVER_OVERRIDE=zink
    if [[ -z ${XDG_RUNTIME_DIR:-} ]]; then # Vulkan's part for windows complains without it
        XDG_RUNTIME_DIR=$(mktemp -d)
        export XDG_RUNTIME_DIR
    fi
    VK_ICD_FILENAMES=$(find /usr/share/vulkan/icd.d -name 'lvp_icd.*.json' | head -n 1)
    [[ -n $VK_ICD_FILENAMES ]] || fail "Mesa's Vulkan driver for processors is not there (lvp_icd)."
    export VK_ICD_FILENAMES
}

# use_quirk NAME FOLDER: kernels that run from here on behave as on other drivers (tests/quirks).
# Kernels are those for GPUs, each rewritten once; FOLDER/quirks/NAME.log gets the ones that ran.
use_quirk() {
    local version
    [[ $2 != *[[:space:]:\']* ]] || fail "quirks need a folder without spaces, colons and quotes."
    ensure_packages "$quirk_packages"
    version=$(cat "$root"/tests/quirks/* | sha256sum | cut -c 1-16)
    export KERF_QUIRK=$1 KERF_KERNELS=shared KERF_QUIRK_SHADERS=$2/quirks/$version
    export KERF_QUIRK_REWRITER=$root/tests/quirks/quirk_shader.py KERF_QUIRK_LOG=$2/quirks/$1.log
    "$KERF_QUIRK_REWRITER" "$1" --known || fail "there is no quirk '$1' (see above)."
    mkdir -p "$KERF_QUIRK_SHADERS"
    build "$2" kerf_quirks
    export LD_PRELOAD=$2/tests/libkerf_quirks.so
}
