# shellcheck shell=bash
# The archive of scripts/package, which runs on any Linux: the libraries that the programs need go
# along, in lib/kerf. Sourced, after common.sh.

# Each line: a library that is left to the system, and why.
system_libraries='
ld-linux-x86-64.so.2   starts the programs, and is of one piece with libc
ld-linux-aarch64.so.1  is the same
libc.so.6              is the one of the process, whoever else loads it
libm.so.6              is a part of libc
libdl.so.2             is a part of libc
libpthread.so.0        is a part of libc
librt.so.1             is a part of libc
libstdc++.so.6         is used by graphics drivers too, and they may want a newer one
libgcc_s.so.1          is used by graphics drivers too
libz.so.1              is used by graphics drivers too
libEGL.so.1            finds the graphics driver
libX11.so.6            is used by graphics drivers too, and comes with libEGL
'
# What Debian 12 has, and each system with its glibc or a later one: GCC 12 is older than that.
newest_versions='GLIBC_2.36 GLIBCXX_3.4.30'
# Packages whose code or file is in the archive, beside those of the libraries.
compiled_in=(libimgui-dev libeigen3-dev libcli11-dev nlohmann-json3-dev libcgal-dev pybind11-dev
    python3-glad fonts-dejavu-core)

needed_by() { readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }
is_of_system() { grep -q "^$1 " <<<"$system_libraries"; }
# found_for FILE NAME: where a program or library finds that library.
found_for() { ldd "$1" | awk -v name="$2" '$1 == name { print $3 }'; }
# at_most VERSION LIMIT
at_most() { [[ $(printf '%s\n' "$@" | sort -V | tail -n 1) == "$2" ]]; }
# The programs and libraries of a tree.
programs_of() {
    find "$1" -name share -prune -o -type f \( -perm /111 -o -name '*.so*' \) -print
}

# carry_for FILE FOLDER: puts the libraries that a file needs into the folder, and those that they
# need. Prints where each came from.
carry_for() {
    local name found
    for name in $(needed_by "$1"); do
        if is_of_system "$name" || [[ -e $2/$name ]]; then
            continue
        fi
        found=$(found_for "$1" "$name")
        [[ -f $found ]] || fail "$1 needs $name, which is not on this machine"
        install -m 644 "$found" "$2/$name"
        printf '%s\n' "$found"
        carry_for "$found" "$2"
    done
}

# keep_licences TREE LIBRARY...: those of the packages that the libraries and other code came from,
# and the common ones that they refer to.
keep_licences() {
    local doc=$1/share/doc/kerf library package common
    local -a packages=("${compiled_in[@]}")
    shift
    for library; do
        package=$(dpkg-query --search "*/$(basename "$(realpath "$library")")" | sed -n '1s/:.*//p')
        packages+=("${package:?no package holds $library}")
    done
    install -d -m 755 "$doc/licenses"
    for package in "${packages[@]}"; do
        install -m 644 "/usr/share/doc/$package/copyright" "$doc/licenses/$package"
    done
    grep -rohE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' "$doc" | sort -u |
        while read -r common; do
            install -m 644 "$common" "$doc/licenses/common-$(basename "$common")"
        done
    # shellcheck disable=SC2016
    dpkg-query --showformat '${Package} ${Version}, source ${source:Package} ${source:Version}\n' \
        --show "${packages[@]}" | sort -u >"$doc/licenses/packages-of-debian"
}

# complete_archive TREE: gives what is installed there all that other systems don't have.
complete_archive() {
    local libraries=$1/lib/kerf files file
    local -a carried
    install -d -m 755 "$libraries" "$1/share/kerf/assets/fonts"
    install -m 644 /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$1/share/kerf/assets/fonts"
    files=$(programs_of "$1")
    files=$(while read -r file; do carry_for "$file" "$libraries"; done <<<"$files")
    mapfile -t carried <<<"$files"
    keep_licences "$1" "${carried[@]}"
    # A path in the file, since python3 and ffmpeg, which Kerf starts, inherit LD_LIBRARY_PATH.
    programs_of "$1" | while read -r file; do
        patchelf --force-rpath --set-rpath \
            "\$ORIGIN/$(realpath --relative-to="$(dirname "$file")" "$libraries")" "$file"
    done
}

# check_archive TREE LIBRARIES: that it needs nothing but what it has in that folder, and what each
# system has.
check_archive() {
    local file name limit newest
    while read -r file; do
        for name in $(needed_by "$file"); do
            is_of_system "$name" || [[ $(found_for "$file" "$name") -ef $2/$name ]] ||
                fail "$file needs $name, which is neither in the archive nor in each system"
        done
    done < <(programs_of "$1")
    for limit in $newest_versions; do
        newest=$(programs_of "$1" | xargs -d '\n' objdump -T | grep -oE "\b${limit%_*}_[0-9.]+" |
            sort -uV | tail -n 1)
        at_most "$newest" "$limit" || fail "the archive needs $newest, which is newer than $limit"
        say "the archive needs $newest, and may need $limit"
    done
}
