# The known mistakes: tests/mistakes/NN_topic/NN.k.md has those of one exercise, each as edits of the solution.
# mistake_tool reads them, compiles what they change and runs it: see tests/support/mistake_tool.cpp.

# course_mistake_tests(chapter): each mistake is caught by the test case that it names, and recognized by what
# fails; those that `course certify` must see fail there, too.
function(course_mistake_tests chapter)
  if(NOT COURSE_ALL_TESTS)
    return()
  endif()
  include(ProcessorCount)
  processorcount(cores)
  foreach(id ${course_ids_${chapter}})
    add_test(NAME mistakes.${id} COMMAND mistake_tool check ${id})
    set_tests_properties(mistakes.${id} PROPERTIES LABELS mistakes TIMEOUT 600 PROCESSORS ${cores})
  endforeach()
  if(TARGET certify.${chapter}_solution)
    course_linked_with(certify.${chapter}_solution ${course_libraries_of_programs})
    add_test(NAME mistakes.certify.${chapter} COMMAND mistake_tool certify ${chapter})
    set_tests_properties(mistakes.certify.${chapter} PROPERTIES LABELS mistakes TIMEOUT 300 PROCESSORS ${cores})
    course_nightly(mistakes.certify.${chapter})
  endif()
  # What `course compare` says of some. For those who change it: `mistake_tool pictures` shows that it sees each
  # mistake that changes the picture.
  course_linked_with(${chapter}_solution ${course_libraries_linked_${chapter}} ${course_libraries_of_programs})
  add_test(NAME mistakes.compare.${chapter} COMMAND mistake_tool compare ${chapter})
  set_tests_properties(mistakes.compare.${chapter} PROPERTIES LABELS mistakes TIMEOUT 600 PROCESSORS ${cores})
  course_nightly(mistakes.compare.${chapter})
endfunction()
