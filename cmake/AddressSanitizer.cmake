# Chapter 00 under the address sanitizer, which watches every use of the heap: it is silent on the
# solution, and it reports the mistakes with memory. Include after the chapters.
if(NOT RT_SANITIZE MATCHES "address")
  return()
endif()

set(chapter 00_toolchain)
set(tests ${CMAKE_SOURCE_DIR}/tests)
set(all "")

# course_memory_test(name folder pattern): what a small program on plain memory must say. The
# folder's code comes before the solution's.
function(course_memory_test name folder pattern)
  set(target ${chapter}_memory.${name})
  course_program(${target} double ${tests}/${chapter}/sanitized/memory.cpp
                 INCLUDE ${folder} ${course_solutions})
  add_test(NAME ${chapter}.memory.${name} COMMAND ${target})
  set_tests_properties(${chapter}.memory.${name} PROPERTIES LABELS "solution;asan" TIMEOUT 60
                       PASS_REGULAR_EXPRESSION "${pattern}")
  set(all ${all} ${target} PARENT_SCOPE)
endfunction()

course_memory_test(solution ${CMAKE_SOURCE_DIR}/solutions/${chapter} "all memory is released")
set_tests_properties(${chapter}.memory.solution PROPERTIES FAIL_REGULAR_EXPRESSION "Sanitizer")
foreach(mistake_and_report
        "00.2_no_destructor|detected memory leaks"
        "00.2_shallow_copy|double-free"
        "00.2_move_keeps_pointer|double-free"
        "00.2_releases_before_copying|heap-use-after-free"
        "00.2_reference_into_copy|heap-use-after-free"
        "00.3_gives_up_ownership|detected memory leaks"
        "00.3_two_owners|double-free|heap-use-after-free")
  string(REGEX MATCH "^([^|]*)\\|(.*)$" matched "${mistake_and_report}")
  course_memory_test(${CMAKE_MATCH_1} ${tests}/mistakes/${chapter}/${CMAKE_MATCH_1}
                     "${CMAKE_MATCH_2}")
endforeach()
add_custom_target(address_sanitizer DEPENDS ${all})
