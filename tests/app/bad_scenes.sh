#!/bin/sh
# bad_scenes.sh PROGRAM: chapter 08's program refuses bad scene files: exit code 2, one line on stderr
# that names the file, no picture, and an older one as it was.
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
sphere='"center": [0, 0, 0]'

refuses missing.json 'does not exist'
mkdir folder.json
refuses folder.json 'is a folder'
: >empty.json
refuses empty.json 'is empty'
echo 'once upon a time' >prose.json
refuses prose.json '1:1: '
scene good.json ''
sed 's/5\], "look/5] "look/' good.json >comma.json
refuses comma.json '1:[0-9]*: .*a comma is missing before it'
(echo '// mine' && cat good.json) >comment.json
refuses comment.json '1:1: .*JSON has no comments'
head -c 99 good.json >cut.json
refuses cut.json '2:[0-9]*: .*quote'
scene nan.json ', "spheres": [{"center": [NaN, 0, 0], "radius": 1, "material": "gold"}]'
refuses nan.json '3:[0-9]*: '
scene huge.json ', "spheres": [{"center": [1e999, 0, 0], "radius": 1, "material": "gold"}]'
refuses huge.json '3:[0-9]*: .*1e999'
scene key.json ', "sheres": []'
refuses key.json 'sheres.*"spheres"'
scene material.json ", \"spheres\": [{$sphere, \"radius\": 1, \"material\": \"gould\"}]"
refuses material.json 'spheres\[0\].material.*"gold"'
scene radius.json ", \"spheres\": [{$sphere, \"radius\": -1, \"material\": \"gold\"}]"
refuses radius.json 'spheres\[0\].radius must be'
scene flat.json ', "spheres": [{"matrix": [[1, 0, 1, 0], [0, 1, 1, 0], [1, 1, 2, 0]], "material": "gold"}]'
refuses flat.json 'spheres\[0\].matrix is a singular matrix'
scene zero.json ", \"spheres\": [{$sphere, \"radius\": 1, \"scale\": [1, 0, 1], \"material\": \"gold\"}]"
refuses zero.json 'spheres\[0\].scale\[1\] must be a number from 0.001 to 1000'
index=0 scene index.json ''
refuses index.json 'materials.glass.index must be a number from 0.1 to 10'
scene many.json ', "groups": [{"rule": "plane", "count": 1000000000, "extent": 9, "radius": 0.1, "materials": ["gold"]}]'
refuses many.json 'groups\[0\].count must be a whole number from 1 to 1000000'
scene fog.json ", \"fog\": {$sphere, \"radius\": 9, \"density\": 1}, \"spheres\": [{$sphere, \"radius\": 1, \"material\": \"glass\"}, {$sphere, \"radius\": 0.5, \"material\": \"gold\"}]"
refuses fog.json 'spheres\[0\] is glass.*spheres\[1\] overlaps it'
sed 's/"look_at": \[0, 0, 0\]/"look_at": [1e-30, 0, 0], "lens": {"aperture": 1}/; s/5\], "look/0], "look/' good.json >lens.json
refuses lens.json 'camera.lens needs "focus_distance"'
scene moves.json ", \"spheres\": [{$sphere, \"radius\": 1, \"material\": \"gold\", \"velocity\": [1, 0, 0]}]"
"$program" moves.json --width 9 --height 9 --out moves.png >stdout 2>stderr ||
    complain moves.json "it was not drawn"
grep -q '^note: 1 sphere .*camera.shutter is 0' stdout || complain moves.json "no note on the shutter"
# mesh NAME LINES: a scene with a mesh whose OBJ file has these lines.
mesh() {
    printf %b "$2" >mesh.obj
    scene "$1" ', "meshes": [{"file": "mesh.obj", "material": "gold"}]'
}
corners='v 0 0 0\nv 1 0 0\nv 0 1 0\n'
mesh point.json "${corners}f 1 2 3\nf 1 2 4\n"
refuses point.json 'meshes\[0\].file.*"mesh.obj".*polygon 2'
mesh back.json "${corners}f 1 2 -4\n"
refuses back.json 'meshes\[0\].file.*polygon 1'
mesh zero.json "${corners}f 0 1 2\n"
refuses zero.json 'meshes\[0\].file.*line 4'
mesh place.json "${corners}f 1/1 2/1 3/1\n"
refuses place.json 'meshes\[0\].file.*polygon 1: the place'
mesh word.json 'v 0 0 0\nv 1 oh 0\n'
refuses word.json "meshes\[0\].file.*line 2 has 'oh'"
mesh nan.json 'v 0 nan 0\n'
refuses nan.json 'meshes\[0\].file.*line 1'
mesh short.json 'v 0 0\n'
refuses short.json 'meshes\[0\].file.*line 1 has too few numbers'
mesh many.json "${corners}f$(seq -s ' ' 256 | sed 's/^/ /')\n"
refuses many.json 'meshes\[0\].file.*line 4 has a polygon of 256 corners'
mesh far.json "v 1e12 0 0\n${corners}f 1 2 3\n"
refuses far.json 'meshes\[0\].file.*more than 1000000000 from the origin'
mesh empty.json ''
refuses empty.json 'meshes\[0\].file.*no polygons'
mesh none.json "$corners"
refuses none.json 'meshes\[0\].file.*no polygons'
mesh drawn.json "${corners}f -3 -2 -1\n"
"$program" drawn.json --explain --width 9 --height 9 --out drawn.png >stdout 2>stderr ||
    complain drawn.json "it was not drawn"
grep -q ', 0 spheres, 1 triangle$' stdout || complain drawn.json "not '0 spheres, 1 triangle'"
sed 's/mesh.obj/..\/mesh.obj/' drawn.json >outside.json
refuses outside.json 'meshes\[0\].file .*only files in that folder'
sed 's/"gold"}/"gold", "matrix": [[1, 0, 1, 0], [0, 1, 1, 0], [1, 1, 2, 0]]}/' drawn.json >flat.json
refuses flat.json 'meshes\[0\].matrix is a singular matrix.*flattens the mesh'
ln -s /etc/passwd link.png
for image in ../picture.png /etc/passwd link.png; do
    scene image.json ", \"textures\": {\"map\": {\"type\": \"image\", \"file\": \"$image\"}}"
    refuses image.json 'textures.map.file .*only files in that folder'
done

# Files of the allowed size may not fill the memory, whatever they hold. A sanitized program or one for Windows
# does not start with so little address space, and is not limited.
# shellcheck disable=SC3045  # dash, bash and zsh have ulimit -v
limit() { ulimit -v 1700000; }
if (limit && "$program" --help) >stdout 2>&1; then limit; fi
# repeated FILE BEGIN PART END: 64 MiB of the same part.
repeated() {
    bytes=$((64 * 1024 * 1024 - 200))
    printf %s "$2" >"$1"
    yes "$3" | tr -d '\n' | head -c $((bytes - bytes % ${#3})) >>"$1"
    printf %s "$4" >>"$1"
}
pictures=new.png  # once is enough: such files take seconds to read
repeated objects.json '[' '{},' '0]'
refuses objects.json 'has too many keys and values; 12000000 are allowed'
repeated deep.json '' '[' ''
refuses deep.json 'is nested too deeply'
repeated text.json '{"about": "' 'a' '"}'
refuses text.json 'the scene needs "camera"'

[ "$failures" -eq 0 ] || echo "$failures complaints"
[ "$failures" -eq 0 ]
