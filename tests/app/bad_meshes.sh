#!/bin/sh
# bad_meshes.sh PROGRAM: a program that draws meshes refuses bad ones: see scene_files.sh.
# shellcheck source=tests/app/scene_files.sh
. "$(dirname "$0")/scene_files.sh"

mesh point.json "${corners}f 1 2 3\nf 1 2 4\n"
refuses point.json 'meshes\[0\].file.*"mesh.obj".*line 5 names point 4, and there are 3'
mesh back.json "${corners}f 1 2 -4\n"
refuses back.json 'meshes\[0\].file.*line 4 names point -4, and there are 3'
mesh zero.json "${corners}f 0 1 2\n"
refuses zero.json 'meshes\[0\].file.*line 4'
mesh texture.json "${corners}f 1/1 2/1 3/1\n"
refuses texture.json 'meshes\[0\].file.*line 4 names texture coordinate 1, and there are 0'
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
mesh ply.json 'ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0\n'
refuses ply.json 'meshes\[0\].file.*not a readable PLY file: its vertices have no property x'
mesh drawn.json "${corners}f -3 -2 -1\n"
"$program" drawn.json --explain --width 9 --height 9 --out drawn.png >stdout 2>stderr ||
    complain drawn.json "it was not drawn"
grep -q ', 0 spheres, 1 triangle$' stdout || complain drawn.json "not '0 spheres, 1 triangle'"
sed 's/mesh.obj/..\/mesh.obj/' drawn.json >outside.json
refuses outside.json 'meshes\[0\].file .*only files in that folder'
sed 's/"gold"}/"gold", "matrix": [[1, 0, 1, 0], [0, 1, 1, 0], [1, 1, 2, 0]]}/' drawn.json >flat.json
refuses flat.json 'meshes\[0\].matrix is a singular matrix.*flattens the mesh'
sed 's/"gold"}/"gold", "emits": [1, 1, 1]}/' drawn.json >both.json
refuses both.json 'meshes\[0\] has both material and emits.*reflects nothing'
sed 's/"material": "gold"}/"emits": [1, 2e6, 0]}/' drawn.json >bright.json
refuses bright.json 'meshes\[0\].emits\[1\] must be a number from 0 to 1000000'
sed 's/"material": "gold"}/"emits": [1, 2, 0]}/' drawn.json >shines.json
"$program" shines.json --explain --width 9 --height 9 --out shines.png >stdout 2>stderr ||
    complain shines.json "it was not drawn"

ends
