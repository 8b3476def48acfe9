# An effect that is absent costs nothing: the instructions that chapter 08's narrow renderers execute,
# against loops written by hand. Include after the chapters. Built for any machine of this kind, since
# valgrind does not know every instruction, and only where the compiler optimizes.
if(NOT CMAKE_BUILD_TYPE STREQUAL "Release" OR RT_SANITIZE OR NOT COURSE_ALL_TESTS)
  return()
endif()
# However many renderers there are: the program stays small.
add_test(NAME 08_effects.size
  COMMAND sh -c "[ \"$(wc -c <'$<TARGET_FILE:08_effects_solution>')\" -le 10000000 ]")
set_tests_properties(08_effects.size PROPERTIES LABELS solution TIMEOUT 20)

# Judged with g++. clang++ 14 calls the function scatter() of a material where g++ inlines it: 1.5 to 1.8 %
# more instructions than by hand, in every renderer.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  return()
endif()
add_executable(08_effects_costs ${CMAKE_SOURCE_DIR}/tests/08_effects/costs/main.cpp)
target_include_directories(08_effects_costs PRIVATE ${course_solutions} ${CMAKE_SOURCE_DIR}/common)
target_compile_options(08_effects_costs PRIVATE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
                       -fno-math-errno -fopenmp-simd)
add_test(NAME 08_effects.absent_costs_nothing
  COMMAND sh ${CMAKE_SOURCE_DIR}/tests/08_effects/costs/costs.sh $<TARGET_FILE:08_effects_costs>)
set_tests_properties(08_effects.absent_costs_nothing PROPERTIES
  LABELS solution TIMEOUT 300 SKIP_RETURN_CODE 77)
