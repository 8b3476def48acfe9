# shellcheck shell=sh
# What bad_scenes.sh and bad_meshes.sh share: $program refuses bad scene files with exit code 2 and one line on stderr
# that names the file; no picture is written, and an older one stays as it was.
set -u
program=$1
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place" || exit 1
failures=0
complain() {
    failures=$((failures + 1))
    printf '%s: %s\n' "$1" "$2"
    sed 's/^/  stderr: /' stderr
}

# refuses FILE WORDS: the line begins with the file, and contains WORDS.
refuses() {
    echo 'an older picture' >old.png
    for picture in ${pictures:-old.png new.png}; do
        "$program" "$1" --quiet --width 9 --height 9 --out "$picture" >stdout 2>stderr
        code=$?
        [ "$code" -eq 2 ] || complain "$1" "exit code $code, not 2"
        [ "$(wc -l <stderr)" -eq 1 ] || complain "$1" "not one line on stderr"
        grep -q "^[0-9a-z_]*: $1" stderr || complain "$1" "the line does not begin with the file"
        grep -q -- "$2" stderr || complain "$1" "stderr does not say '$2'"
        [ ! -s stdout ] || complain "$1" "something was printed"
    done
    [ ! -e new.png ] || complain "$1" "a picture was written"
    [ "$(cat old.png)" = 'an older picture' ] || complain "$1" "the older picture was changed"
    rm -f new.png
    [ -z "$(find . -name '*.part')" ] || complain "$1" "a temporary file was left"
}

# scene NAME MEMBERS: a scene file with these members, added to those that it needs.
scene() {
    printf '{"camera": {"look_from": [0, 0, 5], "look_at": [0, 0, 0]},
        "materials": {"gold": {"type": "metal", "color": "#ffcc66"},
                      "glass": {"type": "glass", "index": %s}}%s}\n' "${index:-1.5}" "$2" >"$1"
}
# shellcheck disable=SC2034  # the scripts use it
sphere='"center": [0, 0, 0]'

# mesh NAME LINES: a scene with a mesh whose OBJ file has these lines.
mesh() {
    printf %b "$2" >mesh.obj
    scene "$1" ', "meshes": [{"file": "mesh.obj", "material": "gold"}]'
}
# shellcheck disable=SC2034
corners='v 0 0 0\nv 1 0 0\nv 0 1 0\n'

# ends: the script's last line.
ends() {
    [ "$failures" -eq 0 ] || echo "$failures complaints"
    [ "$failures" -eq 0 ]
}
