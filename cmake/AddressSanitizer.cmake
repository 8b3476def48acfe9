# Chapter 00 under the address sanitizer, which watches every use of the heap: it is silent on the
# solution, and it reports the mistakes with memory. Include after the chapters.
if(NOT RT_SANITIZE MATCHES "address")
  return()
endif()

set(chapter 00_toolchain)
set(all "")

# course_memory_test(name folder pattern): what a small program on plain memory must say. The
# folder's code comes before the solution's.
function(course_memory_test name folder pattern)
  set(target ${chapter}_memory.${name})
  course_program(${target} double ${CMAKE_SOURCE_DIR}/tests/${chapter}/sanitized/memory.cpp
                 INCLUDE ${folder} ${course_solutions})
  add_test(NAME ${chapter}.memory.${name} COMMAND ${target})
  set_tests_properties(${chapter}.memory.${name} PROPERTIES LABELS "solution;asan" TIMEOUT 60
                       PASS_REGULAR_EXPRESSION "${pattern}")
  set(all ${all} ${target} PARENT_SCOPE)
endfunction()

course_memory_test(solution ${CMAKE_SOURCE_DIR}/solutions/${chapter} "all memory is released")
set_tests_properties(${chapter}.memory.solution PROPERTIES FAIL_REGULAR_EXPRESSION "Sanitizer")
course_mistakes_with(names ${chapter} "address sanitizer reports")
foreach(name ${names})
  course_mistake_folder(folder ${name})
  get_property(report GLOBAL PROPERTY "${name} address sanitizer reports")
  course_memory_test(${name} ${folder} "${report}")
  course_mistake_target(${chapter}_memory.${name} ${name})
endforeach()
add_custom_target(address_sanitizer DEPENDS ${all})
