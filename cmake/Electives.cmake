# What electives add to chapter 08's program: --batches, --sampler, --target-error, --time-budget. Each is
# drawn by chapter 10 or 11, in a source of its own that is linked into the program. Include after the
# chapters.
#
# course_electives(program real folders...): gives this program these options, with the code of these folders:
# the program's own, and the electives'.
function(course_electives program real)
  set(chapters ${CMAKE_SOURCE_DIR}/chapters)
  add_library(${program}_electives OBJECT ${chapters}/10_batches/for_08/batch_drawing.cpp
              ${chapters}/11_samples/for_08/sampled_drawing.cpp)
  target_include_directories(${program}_electives PRIVATE ${ARGN} ${chapters}/08_effects)
  target_link_libraries(${program}_electives PRIVATE common_${real})
  target_link_libraries(${program} PRIVATE ${program}_electives)
endfunction()

set(exercises ${CMAKE_SOURCE_DIR}/exercises)
course_electives(08_effects_solution double ${course_solutions})
course_electives(08_effects_solution_float float ${course_solutions})
course_electives(08_effects double ${exercises}/11_samples ${exercises}/10_batches ${exercises}/08_effects ${course_solutions})
course_electives(08_effects_mine double ${COURSE_YOURS} ${course_solutions})
course_electives(08_effects_mine_float float ${COURSE_YOURS} ${course_solutions})
course_of_learner(08_effects_electives 08_effects_mine_electives 08_effects_mine_float_electives)
set_target_properties(08_effects_mine_electives 08_effects_mine_float_electives PROPERTIES EXCLUDE_FROM_ALL ON)
course_long_tests(08_effects_solution_float_electives)

# The same image file, for every scene.
function(course_batches_test name program)
  add_test(NAME ${name}
    COMMAND sh ${CMAKE_SOURCE_DIR}/tests/app/batches.sh $<TARGET_FILE:${program}>
            ${CMAKE_SOURCE_DIR}/chapters/08_effects/scenes)
  set_tests_properties(${name} PROPERTIES LABELS solution TIMEOUT 300)
endfunction()
course_batches_test(08_effects.batches 08_effects_solution)
if(COURSE_ALL_TESTS)
  course_batches_test(08_effects.batches_in_float 08_effects_solution_float)
endif()

# The options of chapter 11.
add_test(NAME 08_effects.refining
  COMMAND sh ${CMAKE_SOURCE_DIR}/tests/app/refining.sh $<TARGET_FILE:08_effects_solution>
          ${CMAKE_SOURCE_DIR}/chapters/08_effects/scenes)
set_tests_properties(08_effects.refining PROPERTIES LABELS solution TIMEOUT 300)
