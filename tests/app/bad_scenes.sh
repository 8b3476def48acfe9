#!/bin/sh
# bad_scenes.sh PROGRAM: chapter 08's program refuses bad scene files, and meshes: see scene_files.sh.
# shellcheck source=tests/app/scene_files.sh
. "$(dirname "$0")/scene_files.sh"

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
mesh mesh.json "${corners}f 1 2 3\n"
refuses mesh.json 'meshes are not drawn by this program; ./course run 08 takes the one that draws them'
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

ends
