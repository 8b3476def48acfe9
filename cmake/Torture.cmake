# Scenes made to break a ray tracer, in both precisions: tests/torture. With the solutions of all
# chapters; include after them.
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/torture/*.cpp)
foreach(real double float)
  course_checkpoint(torture_${real} ${real} ${sources} INCLUDE ${course_solutions})
  if(real STREQUAL "float")
    course_long_tests(torture_float)
  endif()
  if(real STREQUAL "double" OR COURSE_ALL_TESTS)
    add_test(NAME torture_${real} COMMAND torture_${real})
    set_tests_properties(torture_${real} PROPERTIES LABELS "solution;hard" TIMEOUT 600)
  endif()
endforeach()
