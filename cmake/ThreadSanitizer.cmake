# Chapter 06 under the thread sanitizer, which watches every access to memory: it is silent on the
# solution, and it reports the generator that all workers share. Include after the chapters.
if(NOT RT_SANITIZE MATCHES "thread")
  return()
endif()

add_test(NAME 06_threads.no_data_race COMMAND 06_threads_checkpoint_solution)
set_tests_properties(06_threads.no_data_race PROPERTIES LABELS "solution;tsan" TIMEOUT 300
  PASS_REGULAR_EXPRESSION "All tests passed" FAIL_REGULAR_EXPRESSION "ThreadSanitizer")

course_mistakes_with(racing 06_threads "data race in")
set(folder ${CMAKE_SOURCE_DIR}/solutions/06_threads/rt)
file(GLOB course_sources RELATIVE ${folder} CONFIGURE_DEPENDS ${folder}/*.cpp)
foreach(name ${racing})
  if(NOT TARGET mistake.${name})  # mistakes may be left out of this build; this one is needed
    course_mistake(${name} 06_threads)
  endif()
  get_property(test_case GLOBAL PROPERTY "${name} data race in")
  add_test(NAME 06_threads.${name}_is_reported COMMAND mistake.${name} "${test_case}")
  set_tests_properties(06_threads.${name}_is_reported PROPERTIES
    LABELS "mistakes;tsan" TIMEOUT 300
    PASS_REGULAR_EXPRESSION "WARNING: ThreadSanitizer: data race")
endforeach()
set(course_sources "")
list(TRANSFORM racing PREPEND mistake.)
add_custom_target(thread_sanitizer DEPENDS 06_threads_checkpoint_solution ${racing})
