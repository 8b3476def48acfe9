# The fuzzer of scene files, by clang++ with -DRT_SANITIZE=fuzzer-no-link,address,undefined.
# Run it in a folder for what it finds:
#   build-fuzz/bin/fuzz_scene_file -dict=tests/08_effects/fuzz/json.dict FINDINGS
#     tests/08_effects/fuzz/seeds chapters/08_effects/scenes
if(NOT RT_SANITIZE MATCHES "fuzzer")
  return()
endif()

set(fuzz ${CMAKE_SOURCE_DIR}/tests/08_effects/fuzz)
set(chapter ${CMAKE_SOURCE_DIR}/chapters/08_effects)
course_program(fuzz_scene_file double ${fuzz}/fuzz_scene_file.cpp ${chapter}/scene_file.cpp
               ${chapter}/placing.cpp INCLUDE ${chapter} ${course_solutions})
target_compile_definitions(fuzz_scene_file PRIVATE FUZZ_FOLDER="${fuzz}/seeds")
target_link_options(fuzz_scene_file PRIVATE -fsanitize=fuzzer)
# The reader of image files has to stand it, too; it copies nothing from nowhere, which is harmless.
target_compile_options(course_stb_code PRIVATE -fsanitize=${RT_SANITIZE}
  -fno-sanitize=nonnull-attribute -fno-sanitize-recover=all)
