# Chapter 06 under the thread sanitizer, which watches every access to memory: it is silent on the
# solution, and it reports the generator that all workers share. Include after the chapters.
if(NOT RT_SANITIZE MATCHES "thread")
  return()
endif()

add_test(NAME 06_threads.no_data_race COMMAND 06_threads_checkpoint_solution)
set_tests_properties(06_threads.no_data_race PROPERTIES LABELS "solution;tsan" TIMEOUT 300
  PASS_REGULAR_EXPRESSION "All tests passed" FAIL_REGULAR_EXPRESSION "ThreadSanitizer")

set(racing mistake.06.4_shared_generator)
if(NOT TARGET ${racing})  # mistakes may be left out of this build; this one is needed
  course_checkpoint(${racing} double ${CMAKE_SOURCE_DIR}/tests/06_threads/06.4_sample_rng.cpp
    INCLUDE ${CMAKE_SOURCE_DIR}/tests/mistakes/06_threads/06.4_shared_generator ${course_solutions})
  set_target_properties(${racing} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/mistakes)
endif()
add_test(NAME 06_threads.shared_generator_is_reported
  COMMAND ${racing} "06.4 any number of workers draws the same picture")
set_tests_properties(06_threads.shared_generator_is_reported PROPERTIES
  LABELS "mistakes;tsan" TIMEOUT 300
  PASS_REGULAR_EXPRESSION "WARNING: ThreadSanitizer: data race")
add_custom_target(thread_sanitizer DEPENDS 06_threads_checkpoint_solution ${racing})
