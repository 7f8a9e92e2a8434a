#!/usr/bin/env bash
# package.sh BUILD_FOLDER: checks the packages in BUILD_FOLDER/packages as users install them. Needs root,
# and the packages of [soak]. Each chroot takes about 500 MB in /tmp until the end.
set -euo pipefail
build=$(readlink -f "$1")
package=$(ls -t "$build"/packages/afterglow_*.deb | head -n 1)
tarball=$(ls -t "$build"/packages/afterglow-*.tar.xz | head -n 1)
work=$(mktemp -d /tmp/afterglow-soak-XXXXXX)
failed=0
host_libraries=libgl1,libegl1,libgl1-mesa-dri,libx11-6,libstdc++6,xvfb

clean_up() {
    local folder
    for folder in "$work"/*/proc "$work"/*/dev; do
        if mountpoint -q "$folder"; then umount --recursive --lazy "$folder"; fi
    done
    rm -rf --one-file-system "$work"
}
trap clean_up EXIT

# check NAME COMMAND...: runs it and prints the result. The output is shown if it fails.
check() {
    local name=$1
    shift
    if "$@" >"$work/output" 2>&1; then
        echo "  pass    $name"
    else
        echo "  FAILED  $name"
        sed 's/^/          /' "$work/output" | tail -n 20
        failed=1
    fi
}

# within SUITE COMMAND: runs a shell command in the chroot of the suite.
within() {
    chroot "$work/$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LIBGL_ALWAYS_SOFTWARE=1 \
        DEBIAN_FRONTEND=noninteractive bash -euc "$2"
}

# make_chroot SUITE PACKAGES
make_chroot() {
    mmdebstrap --quiet --mode=root --variant=minbase --include="$2" "$1" "$work/$1" >/dev/null 2>&1
    mount --bind /proc "$work/$1/proc"
    mount --rbind /dev "$work/$1/dev"
    mount --make-rslave "$work/$1/dev"
    cp /etc/resolv.conf "$work/$1/etc/"
    within "$1" 'apt-get update -qq'
}

# A window that still runs after ten seconds has opened.
opens_window='Xvfb :91 -screen 0 1280x800x24 >/dev/null 2>&1 & server=$!; sleep 2; code=0
DISPLAY=:91 timeout 10 PROGRAM phosphor || code=$?; kill $server; test $code = 124'
draws_picture='PROGRAM render phosphor --preset amber-p3 --size 320x180 -o /tmp/a.png
PROGRAM render crt --size 320x180 -o /tmp/b.exr; PROGRAM compare /tmp/a.png /tmp/a.png | grep -q "max    0"'

with_program() {
    echo "${2//PROGRAM/$1}"
}

check_metadata() {
    local pages=$build/pages/share
    check 'lintian finds no errors' lintian --allow-root --fail-on error "$package"
    check 'AppStream metadata is valid' appstreamcli validate --no-net "$pages"/metainfo/*.xml
    check 'the desktop entry is valid' desktop-file-validate "$(dirname "$0")/../../app/package/afterglow.desktop"
    check 'bash reads the completion' bash -n "$pages/bash-completion/completions/afterglow"
}

# The same package with a higher version.
make_newer() {
    dpkg-deb --raw-extract "$package" "$work/newer"
    sed -i 's/^Version: .*/&+newer/' "$work/newer/DEBIAN/control"
    dpkg-deb --build --root-owner-group "$work/newer" "$work/bookworm/tmp/newer.deb" >/dev/null
}

check_deb() {
    make_chroot bookworm "$host_libraries,shared-mime-info,man-db"
    within bookworm 'find / -xdev \( -path /tmp -o -path /var -o -path /root \) -prune -o -print | sort >/tmp/before'
    cp "$package" "$work/bookworm/tmp/afterglow.deb"
    check 'the .deb installs' within bookworm 'apt-get install -y -qq --no-install-recommends /tmp/afterglow.deb'
    check 'it draws' within bookworm "$(with_program afterglow "$draws_picture")"
    check 'its window opens' within bookworm "$(with_program afterglow "$opens_window")"
    check 'man pages are found' within bookworm 'test -f "$(man -w afterglow)"; test -f "$(man -w afterglow-render)"'
    check 'thumbnails of presets, looks and packs are drawn' within bookworm '
        afterglow preset phosphor -o /tmp/p.json; afterglow pack crt -o /tmp/c.afterglow
        for file in /tmp/p.json /tmp/c.afterglow /usr/share/afterglow/shaders/crt/look.json; do
            sed -n "s/^Exec=//p" /usr/share/thumbnailers/afterglow.thumbnailer |
                sed "s|%i|$file|; s|%o|/tmp/t.png|" >/tmp/thumbnail; bash -e /tmp/thumbnail
            test "$(head -c 4 /tmp/t.png | tail -c 3)" = PNG; rm /tmp/t.png; done'
    check 'file types are registered' within bookworm '
        grep -q "afterglow-pack:\*.afterglow" /usr/share/mime/globs && grep -q afterglow-preset /usr/share/mime/types'
    make_newer
    check 'it upgrades' within bookworm 'apt-get install -y -qq --no-install-recommends /tmp/newer.deb
        dpkg-query -W afterglow | grep -q newer'
    check 'it draws after the upgrade' within bookworm "$(with_program afterglow "$draws_picture")"
    check 'it is removed cleanly' within bookworm 'apt-get purge -y -qq afterglow; apt-get autoremove -y -qq
        find / -xdev \( -path /tmp -o -path /var -o -path /root \) -prune -o -print | sort >/tmp/after
        diff /tmp/before /tmp/after | grep -i afterglow && exit 1 || exit 0'
}

# check_tarball SUITE
check_tarball() {
    local suite=$1 program
    if [[ ! -d $work/$suite ]]; then make_chroot "$suite" "$host_libraries"; fi
    tar -C "$work/$suite/opt" -xf "$tarball"
    program=/opt/$(basename "$tarball" .tar.xz)/bin/afterglow
    check "$suite: the tarball's program finds all libraries" within "$suite" "
        missing=\$(find /opt \\( -name afterglow -type f -o -name '*.so*' \\) -exec ldd {} + 2>&1 | grep 'not found' || true)
        echo \"\$missing\"; test -z \"\$missing\""
    check "$suite: it draws" within "$suite" "$(with_program "$program" "$draws_picture")"
    check "$suite: its window opens" within "$suite" "$(with_program "$program" "$opens_window")"
}

echo "Packages: $(basename "$package"), $(basename "$tarball")"
check_metadata
check_deb
check_tarball bookworm
check_tarball trixie
exit "$failed"
