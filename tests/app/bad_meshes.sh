#!/bin/sh
# bad_meshes.sh PROGRAM: a program that draws meshes refuses bad ones: see scene_files.sh.
# shellcheck source=tests/app/scene_files.sh
. "$(dirname "$0")/scene_files.sh"

mesh point.json "${corners}f 1 2 3\nf 1 2 4\n"
refuses point.json 'meshes\[0\].file.*"mesh.obj".*polygon 2'
mesh back.json "${corners}f 1 2 -4\n"
refuses back.json 'meshes\[0\].file.*polygon 1'
mesh zero.json "${corners}f 0 1 2\n"
refuses zero.json 'meshes\[0\].file.*line 4'
mesh texture.json "${corners}f 1/1 2/1 3/1\n"
refuses texture.json 'meshes\[0\].file.*polygon 1: the texture coordinate'
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

ends
