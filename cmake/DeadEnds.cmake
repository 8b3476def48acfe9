# No dead ends: the final scene needs what the learner wrote. One program, in which every exercise can
# end as its stub does; see tests/dead_ends/dead_ends.py. Include after the chapters.
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT COURSE_ALL_TESTS OR NOT Python3_FOUND)
  return()
endif()
set(script ${CMAKE_SOURCE_DIR}/tests/dead_ends/dead_ends.py)
set(folder ${CMAKE_BINARY_DIR}/dead_ends)
file(GLOB_RECURSE written CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/solutions/*.hpp
     ${CMAKE_SOURCE_DIR}/exercises/*.hpp)
add_custom_command(OUTPUT ${folder}/made
  COMMAND Python3::Interpreter ${script} make ${CMAKE_SOURCE_DIR} ${folder}
  COMMAND ${CMAKE_COMMAND} -E touch ${folder}/made
  DEPENDS ${script} ${written} ${CMAKE_SOURCE_DIR}/course.json VERBATIM)
file(GLOB program CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/chapters/08_effects/*.cpp)
course_program(dead_ends double ${program} ${folder}/made
               INCLUDE ${folder} ${CMAKE_SOURCE_DIR}/tests/dead_ends ${course_solutions})
target_compile_options(dead_ends PRIVATE -O1)  # it draws little: compiling takes longer
add_test(NAME dead_ends COMMAND Python3::Interpreter ${script} run ${CMAKE_SOURCE_DIR} $<TARGET_FILE:dead_ends>)
set_tests_properties(dead_ends PROPERTIES LABELS solution TIMEOUT 600)
