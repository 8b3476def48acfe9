# Exercise 00.2, which is a definition for the linker. Include after the chapters.

# A right answer in place of the learner's passes: its checkpoint is built like the learner's, so the linker
# finds the answer before it looks for what is missing.
set(course_sources gradient.cpp)
course_learners_checkpoints(00_toolchain PREFIX answered. INCLUDE ${course_solutions}
                            SOURCES ${CMAKE_SOURCE_DIR}/tests/00_toolchain/00.2_gradient.cpp)
set(course_sources "")
add_test(NAME 00_toolchain.answered.00.2 COMMAND answered.00_toolchain_checkpoint)
set_tests_properties(00_toolchain.answered.00.2 PROPERTIES LABELS mistakes TIMEOUT 60
  FAIL_REGULAR_EXPRESSION "No tests ran")

# If the learner's definition does not match the declaration, it compiles, it links, and the checkpoint says
# that the exercise is still to be written, and what to compare.
file(GLOB definitions CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/00_toolchain/linking/*.cpp)
foreach(definition ${definitions})
  get_filename_component(name ${definition} NAME_WE)
  set(target 00_toolchain_linking.${name})
  set_source_files_properties(${definition} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
  course_checkpoint(${target} double ${CMAKE_SOURCE_DIR}/tests/00_toolchain/00.2_gradient.cpp
                    ${definition} INCLUDE ${course_solutions})
  target_link_libraries(${target} PRIVATE 00_toolchain_missing)
  target_compile_options(${target} PRIVATE -O1)
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/mistakes)
  add_test(NAME 00_toolchain.linking.${name} COMMAND ${target})
  set_tests_properties(00_toolchain.linking.${name} PROPERTIES LABELS mistakes TIMEOUT 60
    PASS_REGULAR_EXPRESSION "the linker found no function.*00.2 is still to be written"
    FAIL_REGULAR_EXPRESSION "SIG[A-Z]+;passed")
endforeach()
