# Chapter 08's program and its scene files; and their fuzzer. Include after the chapters.
set(program $<TARGET_FILE:08_effects_solution>)
set(scenes ${CMAKE_SOURCE_DIR}/chapters/08_effects/scenes)
set(app_tests ${CMAKE_SOURCE_DIR}/tests/app)

add_test(NAME 08_effects.bad_scenes COMMAND sh ${app_tests}/bad_scenes.sh ${program})
add_test(NAME 08_effects.stopped COMMAND sh ${app_tests}/stopped.sh ${program} ${scenes})
# The scenes of the page of hard cases.
add_test(NAME 08_effects.hard_scenes
  COMMAND sh ${app_tests}/all_scenes.sh ${program} ${CMAKE_SOURCE_DIR}/docs/hard-cases)
set_tests_properties(08_effects.bad_scenes 08_effects.stopped 08_effects.hard_scenes
                     PROPERTIES LABELS solution TIMEOUT 300)
if(COURSE_ALL_TESTS)
  # In float, where numbers become too large or too small sooner.
  add_test(NAME 08_effects.scenes_in_float
    COMMAND sh ${app_tests}/all_scenes.sh $<TARGET_FILE:08_effects_solution_float> ${scenes})
  set_tests_properties(08_effects.scenes_in_float PROPERTIES LABELS solution TIMEOUT 300)
endif()

# The fuzzer is built by clang++ with -DRT_SANITIZE=fuzzer-no-link,address,undefined; see .ci/run.
if(NOT RT_SANITIZE MATCHES "fuzzer")
  return()
endif()
set(fuzz ${CMAKE_SOURCE_DIR}/tests/08_effects/fuzz)
set(chapter ${CMAKE_SOURCE_DIR}/chapters/08_effects)
course_program(fuzz_scene_file double ${fuzz}/fuzz_scene_file.cpp ${chapter}/scene_file.cpp
               ${chapter}/placing.cpp INCLUDE ${chapter} ${course_solutions})
target_compile_definitions(fuzz_scene_file PRIVATE FUZZ_FOLDER="${fuzz}/seeds")
target_link_options(fuzz_scene_file PRIVATE -fsanitize=fuzzer)
# The reader of image files is fuzzed, too. It may copy 0 bytes from a null pointer, which is harmless.
target_compile_options(course_stb_code PRIVATE -fsanitize=${RT_SANITIZE}
  -fno-sanitize-recover=all -fno-sanitize=nonnull-attribute)
