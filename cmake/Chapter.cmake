# course_chapter(NN_topic) makes all targets and tests of one chapter. Whose code a target compiles is
# decided by the order of its include folders alone:
#
#   solution of chapter N    solutions of chapters up to N, common
#   learner's chapter N      exercises/N, solutions of chapters up to N, common
#   mine                     exercises/ of the chosen chapters, solutions up to N, common
#   a mistake                tests/mistakes/N/MISTAKE, solutions up to N, common
#
# Solutions of later chapters are never among them, so no chapter can use what comes after it.

set(course_chapters "")   # all chapters so far
set(course_solutions "")  # their solution folders

# course_program(target real sources... INCLUDE folders...): a program on common, in one precision.
function(course_program target real)
  cmake_parse_arguments(arg "" "" "INCLUDE" ${ARGN})
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS})
  target_include_directories(${target} PRIVATE ${arg_INCLUDE})
  target_link_libraries(${target} PRIVATE common_${real})
endfunction()

# The same with Catch2's main: a program of test cases.
function(course_checkpoint target real)
  course_program(${target} ${real} ${ARGN})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support)
  target_link_libraries(${target} PRIVATE checkpoint_${real} catch_main)
  target_precompile_headers(${target} REUSE_FROM checkpoint_${real})
endfunction()

# course_exercise_tests(checkpoint label ids...): one test an exercise, and one for its hard cases.
function(course_exercise_tests checkpoint label)
  foreach(id ${ARGN})
    add_test(NAME ${checkpoint}.${id} COMMAND ${checkpoint} "[${id}]~[hard]")
    add_test(NAME ${checkpoint}.${id}.hard COMMAND ${checkpoint} "[${id}][hard]")
    set_tests_properties(${checkpoint}.${id} PROPERTIES LABELS ${label} TIMEOUT 120)
    set_tests_properties(${checkpoint}.${id}.hard PROPERTIES LABELS "${label};hard" TIMEOUT 120)
    # An exercise without a test case would pass unseen.
    set_tests_properties(${checkpoint}.${id} ${checkpoint}.${id}.hard PROPERTIES
      FAIL_REGULAR_EXPRESSION "No tests ran")
  endforeach()
endfunction()

# Reads one line "key: value" of a file.
function(course_read_line file key out)
  file(STRINGS ${file} line REGEX "^${key}: ")
  list(LENGTH line count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "${file} needs one line that starts with '${key}: '")
  endif()
  string(REPLACE "${key}: " "" value "${line}")
  set(${out} "${value}" PARENT_SCOPE)
endfunction()

# A typical wrong answer: the test case that mistake.txt names must fail, by an assertion.
function(course_mistake chapter folder)
  get_filename_component(mistake ${folder} NAME)
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${mistake})
  file(GLOB source ${CMAKE_SOURCE_DIR}/tests/${chapter}/${id}_*.cpp)
  if(NOT source OR NOT EXISTS ${folder}/mistake.txt)
    message(FATAL_ERROR "${folder} needs a mistake.txt and tests/${chapter}/${id}_*.cpp")
  endif()
  course_read_line(${folder}/mistake.txt "caught by" caught_by)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/mistake.txt)
  set(target mistake.${mistake})
  course_checkpoint(${target} double ${source} INCLUDE ${folder} ${course_solutions})
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/mistakes)
  target_compile_options(${target} PRIVATE -O1)  # there are many of them
  add_test(NAME ${target} COMMAND ${target} "${caught_by}")
  set_tests_properties(${target} PROPERTIES LABELS mistakes TIMEOUT 60
    PASS_REGULAR_EXPRESSION "test cases: +1 \\|( +0 passed \\|)? +1 failed"
    FAIL_REGULAR_EXPRESSION "SIG[A-Z]+;AddressSanitizer;runtime error")
endfunction()

function(course_chapter chapter)
  set(root ${CMAKE_SOURCE_DIR})
  list(APPEND course_chapters ${chapter})
  list(APPEND course_solutions ${root}/solutions/${chapter})
  set(course_chapters ${course_chapters} PARENT_SCOPE)
  set(course_solutions ${course_solutions} PARENT_SCOPE)

  file(GLOB program CONFIGURE_DEPENDS ${root}/chapters/${chapter}/*.cpp)
  file(GLOB checkpoints CONFIGURE_DEPENDS ${root}/tests/${chapter}/*.cpp)
  set(learner ${root}/exercises/${chapter} ${course_solutions})

  course_program(${chapter} double ${program} INCLUDE ${learner})
  course_program(${chapter}_solution double ${program} INCLUDE ${course_solutions})
  course_program(${chapter}_solution_float float ${program} INCLUDE ${course_solutions})
  course_checkpoint(${chapter}_checkpoint double ${checkpoints} INCLUDE ${learner})
  course_checkpoint(${chapter}_checkpoint_solution double ${checkpoints}
                    INCLUDE ${course_solutions})
  course_checkpoint(${chapter}_checkpoint_solution_float float ${checkpoints}
                    INCLUDE ${course_solutions})
  # The learner waits for this one after every change: compiling it quickly matters more.
  target_compile_options(${chapter}_checkpoint PRIVATE -O1)

  set(mine "")
  foreach(number ${COURSE_MINE})
    foreach(known ${course_chapters})
      if(number STREQUAL "all" OR known MATCHES "^${number}_")
        list(APPEND mine ${root}/exercises/${known})
      endif()
    endforeach()
  endforeach()
  if(mine)
    course_program(${chapter}_mine double ${program} INCLUDE ${mine} ${course_solutions})
  endif()

  set(ids "")
  foreach(source ${checkpoints})
    get_filename_component(name ${source} NAME)
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
    list(APPEND ids ${id})
  endforeach()
  course_exercise_tests(${chapter}_checkpoint exercise ${ids})
  course_exercise_tests(${chapter}_checkpoint_solution solution ${ids})
  course_exercise_tests(${chapter}_checkpoint_solution_float solution ${ids})

  if(COURSE_CHECK_STUBS)
    foreach(id ${ids})
      # Every single test case must end by saying what is still to be written: none may pass.
      add_test(NAME shipped.${id} COMMAND ${chapter}_checkpoint "[${id}]")
      set_tests_properties(shipped.${id} PROPERTIES LABELS shipped TIMEOUT 20
        PASS_REGULAR_EXPRESSION "is still to be written.*test cases: +[0-9]+ \\|( +0 passed \\|)? +[0-9]+ failed"
        FAIL_REGULAR_EXPRESSION "SIG[A-Z]+")
    endforeach()
  endif()

  if(COURSE_MISTAKES)
    file(GLOB mistakes CONFIGURE_DEPENDS ${root}/tests/mistakes/${chapter}/*)
    foreach(folder ${mistakes})
      course_mistake(${chapter} ${folder})
    endforeach()
  endif()

  # What a chapter gives beyond its exercises has tests of its own, and so have the program's parts.
  file(GLOB given CONFIGURE_DEPENDS ${root}/tests/${chapter}/given/*.cpp)
  set(parts ${program})
  list(FILTER parts EXCLUDE REGEX "/main\\.cpp$")
  if(given)
    foreach(real double float)
      course_checkpoint(${chapter}_given_${real} ${real} ${given} ${parts}
                        INCLUDE ${course_solutions} ${root}/chapters/${chapter})
      target_compile_definitions(${chapter}_given_${real} PRIVATE COURSE_ROOT="${root}")
      add_test(NAME ${chapter}_given_${real} COMMAND ${chapter}_given_${real})
      set_tests_properties(${chapter}_given_${real} PROPERTIES LABELS "solution;hard" TIMEOUT 600)
    endforeach()
  endif()

  # The program still draws the picture that the text shows, and refuses what it should.
  add_test(NAME ${chapter}.image
    COMMAND sh ${root}/tests/app/same_image.sh $<TARGET_FILE:${chapter}_solution>
            $<TARGET_FILE:image_compare> ${root}/docs/images/${chapter}.png)
  add_test(NAME ${chapter}.bad_input
    COMMAND sh ${root}/tests/app/bad_input.sh $<TARGET_FILE:${chapter}_solution>)
  add_test(NAME ${chapter}.float_program
    COMMAND ${chapter}_solution_float --quiet --width 192 --height 108
            --out ${CMAKE_BINARY_DIR}/${chapter}_float.png)
  set_tests_properties(${chapter}.image ${chapter}.bad_input ${chapter}.float_program
                       PROPERTIES LABELS solution TIMEOUT 300)
endfunction()

# Once after the last chapter: targets over all of them, and the list that the companion reads.
function(course_finish)
  set(programs ${course_chapters})
  list(TRANSFORM programs APPEND _solution OUTPUT_VARIABLE solutions)
  list(TRANSFORM programs APPEND _solution_float OUTPUT_VARIABLE float_solutions)
  list(TRANSFORM programs APPEND _checkpoint_solution OUTPUT_VARIABLE checkpoints)
  list(TRANSFORM programs APPEND _checkpoint_solution_float OUTPUT_VARIABLE float_checkpoints)
  list(TRANSFORM programs APPEND _mine OUTPUT_VARIABLE mine)
  add_custom_target(solution_programs DEPENDS ${solutions} ${float_solutions})
  add_custom_target(solution_checkpoints_double DEPENDS ${checkpoints})
  add_custom_target(solution_checkpoints DEPENDS solution_checkpoints_double ${float_checkpoints})
  if(COURSE_MINE)
    add_custom_target(mine DEPENDS ${mine})
  endif()
  list(JOIN course_chapters "\n" lines)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/chapters.txt CONTENT "${lines}\n")
endfunction()
