#!/bin/sh
# bad_input.sh PROGRAM: a chapter's program refuses what it should: one line on stderr, the right exit
# code, no file left behind, an older image as it was.
# shellcheck disable=SC2086  # $small and others are several words
set -u
# Freed memory is overwritten at once, so that a program that still uses it fails.
export GLIBC_TUNABLES=glibc.malloc.perturb=165:glibc.malloc.tcache_count=0
program=$1
name=$(basename "$1")
place=$(mktemp -d)
cleanup() {
    umount "$place/work/full" 2>/dev/null
    chmod -R u+w "$place"
    rm -rf "$place"
}
trap cleanup EXIT
mkdir "$place/work" && cd "$place/work" || exit 1

failures=0
complain() {
    failures=$((failures + 1))
    printf '%s %s\n  %s\n' "$name" "$1" "$2"
    sed 's/^/  stderr: /' "$place/stderr"
}

# Everything in the folder: names, and what the files hold. It starts few processes, since that takes most of the
# time.
contents() { find . -type f -exec cksum {} + -o -print; }

# refuses CODE WORDS ARGUMENTS...: ends with CODE after one line on stderr that contains WORDS, and leaves
# everything as it was. $wrapper holds a command that runs the program, $into its stdout.
wrapper=''
into=$place/stdout
refuses() {
    code=$1
    words=$2
    shift 2
    before=$(contents)
    $wrapper "$program" "$@" >"$into" 2>"$place/stderr"
    got=$?
    [ "$got" -eq "$code" ] || complain "$*" "exit code $got, not $code"
    lines=0
    while read -r _; do lines=$((lines + 1)); done <"$place/stderr"
    [ "$lines" -eq 1 ] || complain "$*" "not one line on stderr"
    grep -q -- "$words" "$place/stderr" || complain "$*" "stderr does not say '$words'"
    [ "$(contents)" = "$before" ] || complain "$*" "files were left or changed: $(contents)"
}

# draws ARGUMENTS...: succeeds without a word.
draws() {
    "$program" --quiet "$@" >"$place/stdout" 2>"$place/stderr" || complain "$*" "failed"
    if [ -s "$place/stdout" ] || [ -s "$place/stderr" ]; then complain "$*" "is not quiet"; fi
}

echo 'an older image' >old.png
cp old.png old.ppm
mkdir folder folder.png
ln -s loop.png loop.png

# The command line.
refuses 2 -- --bogus --bogus
refuses 2 -- picture.png picture.png
refuses 2 --out --out
for value in 0 -5 1e9 abc 65537 99999999999999999999 ' 7' 7.5 ''; do
    refuses 2 'whole number from 1 to' --width "$value" --out old.png
    refuses 2 'whole number from 1 to' --height "$value" --out new.png
done
refuses 2 pixels --width 60000 --height 60000 --out old.png

if "$program" --help | grep -q -- --fov; then
    for value in 0 '' a 1,2 1,2,3,4 1,2,x '1 2 3' 1,,3 ,1,2,3 "1,2,3," nan,0,0 inf,0,0 1e10,0,0 0x1,2,3; do
        refuses 2 'three numbers from -1e9 to 1e9' --from "$value" --out old.png
        refuses 2 'three numbers from -1e9 to 1e9' --at "$value" --out new.png
    done
    for value in 0 -5 180 181 1e9 1e-400 abc nan '' 60,60 60deg; do
        refuses 2 'number between 0 and 180' --fov "$value" --out old.png
    done
    refuses 2 'two different points' --from -1,2,3 --at -1,2,3 --out old.png
    refuses 2 'two different points' --at 0,0.0,-0 --from 0,0,0 --out new.png
fi

# Small pictures, soon drawn.
small='--width 30 --height 20'
larger='--width 45 --height 45'
if "$program" --help | grep -q -- --spp; then
    small="$small --spp 4"
    larger="$larger --spp 4"
fi
# In false colors: what a program computes, and no more.
case $name in
    00* | 01*) can='' ;;
    02*) can='direction' ;;
    03*) can='direction normal distance sphere' ;;
    07*) can='direction normal distance sphere bounces samples boxes' ;;
    *) can='direction normal distance sphere bounces samples' ;;
esac
if [ -n "$can" ]; then
    "$program" --quiet $small --out usual.ppm
    for word in direction normal distance sphere bounces samples boxes; do
        case " $can " in
            *" $word "*)
                draws $small --show $word --out $word.ppm
                for other in usual $can; do
                    [ "$other" = "$word" ] || ! cmp -s "$other.ppm" "$word.ppm" ||
                        complain "--show $word" "draws the same picture as $other"
                done
                ;;
            *) refuses 2 "cannot show '$word', only: direction" --show $word --out old.png ;;
        esac
    done
    for word in usual $can; do rm -f "$word.ppm"; done
    for value in '' light normals; do
        refuses 2 "cannot show '$value', only: direction" --show "$value" --out old.png
    done
    if "$program" --help | grep -q -- --spp; then
        refuses 2 '--spp 2 or more' --show samples --spp 1 --out old.png
    fi
else
    refuses 2 -- --show --show normal
fi

# Where the image is to go.
refuses 2 'folder' --out folder
refuses 2 'folder' --out folder.png
refuses 2 '\.png, \.ppm, \.hdr or \.pfm' --out ''
refuses 2 'use \.png, \.ppm, \.hdr or \.pfm' --out image.jpg
refuses 2 'use \.png, \.ppm, \.hdr or \.pfm' --out image
refuses 2 'use \.png, \.ppm, \.hdr or \.pfm' --out 'two
lines.bmp'
refuses 1 'does not exist' --out nowhere/image.png
refuses 1 'does not exist' --out old.png/image.png
refuses 1 'loop.png' --out loop.png
ln -s nowhere/image.png dangling.png
refuses 1 'folder nowhere.*does not exist' --out dangling.png
mkfifo pipe
refuses 1 'nobody reads' --out pipe

# Paths that cannot be written to. Permissions do not hold for root, who becomes nobody if that
# user can run the program.
mkdir read_only
chmod 555 read_only
chmod 444 old.ppm
if [ "$(id -u)" -eq 0 ]; then
    nobody='setpriv --reuid=65534 --regid=65534 --clear-groups'
    chmod 711 "$place"
    if $nobody "$program" --help >"$place/stdout" 2>&1; then
        chmod 666 "$place/stderr"
        chmod 777 .
        wrapper=$nobody
    fi
    [ ! -d /proc/self ] || refuses 1 'proc' --width 9 --height 9 --out /proc/image.png
fi
if [ "$(id -u)" -ne 0 ] || [ -n "$wrapper" ]; then
    refuses 1 'is not writable' --out read_only/image.png
    refuses 1 'is not writable' --out old.ppm
    if "$program" --help | grep -q -- --study; then
        refuses 1 'is not writable' --study read_only
    fi
fi
wrapper=''
chmod 644 old.ppm

# Full disks: a device that always is, a limit on the size of files, and a real one where we may mount.
if [ -c /dev/full ]; then
    ln -s /dev/full full.png
    ln -s /dev/full full.ppm
    refuses 1 'free some space' $small --out /dev/full
    refuses 1 'free some space' $small --out full.png
    refuses 1 'free some space' $small --out full.ppm
    into=/dev/full
    refuses 1 'standard output' --help
    into=$place/stdout
fi
limited() { (ulimit -f 8 && exec "$@"); }
wrapper=limited
refuses 1 'free some space' $larger --out new.ppm
refuses 1 'free some space' $larger --out old.ppm
wrapper=''
mkdir full
if mount -t tmpfs -o size=8k tmpfs full 2>/dev/null; then
    echo 'an older image' >full/old.ppm
    refuses 1 'free some space' $larger --out full/new.ppm
    refuses 1 'free some space' $larger --out full/old.ppm
fi

# A user who may start few threads: a user of its own, so that no other test's threads count.
somebody="setpriv --reuid=$((50000 + $$ % 10000)) --regid=65534 --clear-groups prlimit"
if [ -n "${nobody:-}" ] && $somebody --nproc=3 "$program" --help >"$place/stdout" 2>&1 &&
    grep -q -- --threads "$place/stdout"; then
    wrapper="$somebody --nproc=1"
    refuses 1 'no thread can be started' --width 9 --height 9 --threads 8
    $somebody --nproc=3 "$program" --width 9 --height 9 --threads 8 --out few.png >"$place/stdout" \
        2>"$place/stderr" || complain --threads 'failed with fewer threads'
    grep -q 'only 2 of 8 threads' "$place/stderr" || complain --threads 'does not say how many there are'
    wrapper=''
fi

# Studies.
if "$program" --help | grep -q -- --study; then
    refuses 2 'folder' --study ''
    refuses 1 'old.png' --study old.png
    refuses 1 'old.png' --study old.png/study
fi

# What goes well.
"$program" --help >"$place/stdout" 2>"$place/stderr" || complain --help "failed"
[ ! -s "$place/stderr" ] || complain --help "speaks on stderr"
grep -q -- --out "$place/stdout" || complain --help "does not tell of --out"
for image in 'with spaces.png' old.png -dash.ppm /dev/null; do
    draws $small --out "$image"
done
# Through a link, whether or not there is a file behind it.
ln -s target.png link.png
draws $small --out link.png && draws $small --out link.png
{ [ -L link.png ] && [ -f target.png ]; } || complain link.png "was replaced by the image"
draws --width 1 --height 1 --out tiny.png
# It says where the image went, and what it measured meanwhile.
"$program" $small --out told.png >"$place/stdout" 2>"$place/stderr" || complain told.png 'failed'
grep -q '^told\.png: 30x20 pixels' "$place/stdout" || complain told.png 'is not named'
timeout 20 cat pipe >from_pipe &
draws --width 1 --height 1 --out pipe
wait
[ -s from_pipe ] || complain pipe 'brought no image'
if "$program" --help | grep -q -- --fov; then
    # From far and near, straight down, and through the narrowest and the widest lens.
    for view in '--from -3,2.5,1e1' '--from 0,9,0 --at 0,0,0' '--from 1e9,-1e9,1e9 --fov 1e-6' \
                '--from 0,0,0 --at 1e-9,0,0 --fov 179.9' '--at=-1,0,-2'; do
        draws $small $view --out view.png
    done
    draws $small --out usual.ppm && draws $small --fov 60 --out other.ppm
    ! cmp -s usual.ppm other.ppm || complain --fov 'draws the same picture'
fi
for image in 'with spaces.png' old.png target.png tiny.png; do
    head -c 4 "$image" | grep -q PNG || complain "$image" "is no PNG"
done
# Linear light: a header, and in .pfm 12 bytes for each pixel.
draws --width 3 --height 2 --out light.hdr && draws --width 3 --height 2 --out light.pfm
head -c 11 light.hdr | grep -q RADIANCE || complain light.hdr "is no Radiance file"
{ [ "$(head -n 1 light.pfm)" = PF ] && [ "$(wc -c <light.pfm)" -eq 84 ]; } || complain light.pfm "is no PFM file"
if "$program" --help | grep -q -- --exposure; then
    for value in '' a nan inf 33 -33 1,2; do
        refuses 2 'number of stops from -32 to 32' --exposure "$value" --out old.png
    done
    refuses 2 'exclude each other' --show normal --exposure 1 --out old.png
    draws $small --exposure 1 --out brighter.ppm && draws $small --out usual.ppm
    ! cmp -s usual.ppm brighter.ppm || complain --exposure 'draws the same picture'
fi
head -c 1 ./-dash.ppm | grep -q P || complain -dash.ppm "is no PPM"
[ -z "$(find . -name '*.part')" ] || complain "" "temporary files were left"

[ "$failures" -eq 0 ] || echo "$failures complaints"
[ "$failures" -eq 0 ]
