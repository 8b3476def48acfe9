# The programs of a chapter. Which code a target compiles is decided by the order of its include folders alone:
#
#   solution of chapter N    what is given and the answers of chapters up to N, common
#   mine                     COURSE_YOURS, then the same
#   follow                   headers that record what they are given, then the same as mine
#
# Nearly everything is in headers. Where an answer is an rt/NAME.cpp, the first of the folders that has it
# provides it.

# course_long_tests(targets...): programs that only the tests with COURSE_ALL_TESTS run.
function(course_long_tests)
  if(NOT COURSE_ALL_TESTS)
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# course_nightly(tests...): tests that a push need not pass: see .ci/run. They are run with all others each night.
function(course_nightly)
  set_property(TEST ${ARGN} APPEND PROPERTY LABELS nightly)
endfunction()

# course_float_programs(targets...): programs in float, which a build with sanitizers does without, too: it sanitizes
# what checkpoints test, in both precisions.
function(course_float_programs)
  course_long_tests(${ARGN})
  if(RT_SANITIZE)
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# course_compile_options(source options...): for one file, which then cannot use headers precompiled without them.
function(course_compile_options source)
  set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${ARGN}" SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# course_executable(target real sources... INCLUDE folders...): a program on common, in one precision.
function(course_executable target real)
  cmake_parse_arguments(arg "" "" "INCLUDE" ${ARGN})
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS})
  target_include_directories(${target} PRIVATE ${arg_INCLUDE})
  target_link_libraries(${target} PRIVATE common_${real} course_utf8)
endfunction()

# course_as_program(target): sanitized only with RT_SANITIZE_PROGRAMS.
function(course_as_program target)
  if(NOT RT_SANITIZE_PROGRAMS)
    set_target_properties(${target} PROPERTIES COURSE_UNSANITIZED ON)
  endif()
endfunction()

# course_program(target real sources... INCLUDE folders...): the same, and the standard library's headers are
# read once for all such programs.
function(course_program target real)
  course_executable(${target} ${real} ${ARGN})
  course_as_program(${target})
  if(TARGET program_headers_${real})
    target_precompile_headers(${target} REUSE_FROM program_headers_${real})
  else()
    target_precompile_headers(${target} REUSE_FROM common_${real})
  endif()
endfunction()

# course_given_sources(out chapter pattern): the sources of the chapter's program that match, such as *.cpp.
function(course_given_sources out chapter pattern)
  set(patterns ${course_given_${chapter}})
  list(TRANSFORM patterns APPEND /${pattern})
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# course_sources(out chapter folders...): the sources of a chapter's answers, each from the first of these
# folders that has it, and those that are given.
function(course_sources out chapter)
  course_given_sources(sources ${chapter} rt/*.cpp)
  foreach(id ${course_ids_${chapter}})
    foreach(file ${course_files_${id}})
      foreach(folder ${ARGN})
        if(file MATCHES "^rt/.*[.]cpp$" AND EXISTS ${folder}/${file})
          list(APPEND sources ${folder}/${file})
          break()
        endif()
      endforeach()
    endforeach()
  endforeach()
  # Each is compiled as it is, without headers that it does not name.
  set_source_files_properties(${sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON
    COMPILE_OPTIONS "${course_source_options}" COMPILE_DEFINITIONS "${course_source_definitions}")
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# course_drawing_program(target real chapter folders...): the chapter's program without --study, with the code of these
# folders. What course_libraries_NN_topic names is linked, too.
function(course_drawing_program target real chapter)
  course_given_sources(program ${chapter} *.cpp)
  list(FILTER program EXCLUDE REGEX "/study[^/]*$")
  course_sources(sources ${chapter} ${ARGN})
  course_program(${target} ${real} ${program} ${sources} INCLUDE ${ARGN})
  target_link_libraries(${target} PRIVATE ${course_libraries_${chapter}})
endfunction()

# course_chapter_program(target real chapter folders...): that, and TARGET_study, the same with --study, which is in the
# sources named study*.cpp: they would take a third of the time that passes until a learner sees a picture.
function(course_chapter_program target real chapter)
  course_drawing_program(${target} ${real} ${chapter} ${ARGN})
  course_given_sources(study ${chapter} study*.cpp)
  course_program(${target}_study ${real} $<TARGET_OBJECTS:${target}> ${study} INCLUDE ${ARGN})
  target_link_libraries(${target}_study PRIVATE ${course_libraries_${chapter}})
endfunction()

# course_small_picture_test(name chapter real program): the solution still draws the same bytes. An emulator
# runs programs for other processors, which CMake does for a test only where the test is the program.
function(course_small_picture_test name chapter real program)
  add_test(NAME ${name}
    COMMAND sh ${CMAKE_SOURCE_DIR}/tests/app/small_picture.sh ${chapter} ${real}
            ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>)
  set_tests_properties(${name} PROPERTIES LABELS solution TIMEOUT 300)
endfunction()

# course_program_tests(chapter): the program still draws its picture, and refuses what it should.
function(course_program_tests chapter)
  set(tests ${CMAKE_SOURCE_DIR}/tests)
  course_small_picture_test(${chapter}.small_picture ${chapter} double ${chapter}_solution)
  add_test(NAME ${chapter}.bad_input COMMAND sh ${tests}/app/bad_input.sh $<TARGET_FILE:${chapter}_solution>)
  set_tests_properties(${chapter}.bad_input PROPERTIES LABELS solution TIMEOUT 300)
  if(NOT COURSE_ALL_TESTS)
    return()
  endif()
  if(NOT RT_SANITIZE)
    course_small_picture_test(${chapter}.small_picture_in_float ${chapter} float ${chapter}_solution_float)
    add_test(NAME ${chapter}.float_program
      COMMAND ${chapter}_solution_float --quiet --width 192 --height 108
              --out ${CMAKE_BINARY_DIR}/${chapter}_float.png)
    set_tests_properties(${chapter}.float_program PROPERTIES LABELS solution TIMEOUT 600)
    course_nightly(${chapter}.float_program)
  endif()
  # It is the picture that the text shows. On two processors, that of chapter 12 takes 13 minutes.
  if(Python3_Interpreter_FOUND)
    add_test(NAME ${chapter}.image
      COMMAND Python3::Interpreter ${tests}/pictures.py --compare --exactly ${CMAKE_BINARY_DIR} ${chapter})
    include(ProcessorCount)
    processorcount(cores)
    set_tests_properties(${chapter}.image PROPERTIES LABELS solution TIMEOUT 1800 PROCESSORS ${cores})
    course_nightly(${chapter}.image)
  endif()
  # `course compare` does not call right code wrong; see tests/support/compare_programs.cpp for
  # more runs. A still picture takes one.
  add_test(NAME ${chapter}.compare
    COMMAND compare_programs alarms 1 $<TARGET_FILE:${chapter}_solution>)
  set_tests_properties(${chapter}.compare PROPERTIES LABELS solution TIMEOUT 600)
  course_nightly(${chapter}.compare)
endfunction()

# course_certificate(chapter): what `course certify` measures of a chapter, on the solution, and on the learner's
# own code of all chapters up to this one.
function(course_certificate chapter)
  set(source ${CMAKE_SOURCE_DIR}/tests/certify/${chapter}.cpp)
  if(NOT EXISTS ${source})
    return()
  endif()
  set(folders ${course_folders_${chapter}})
  set(exercises ${folders})
  list(FILTER exercises INCLUDE REGEX "/solutions/")
  list(TRANSFORM exercises REPLACE "/solutions/" "/exercises/")
  set(support ${CMAKE_SOURCE_DIR}/tests/support)
  course_program(certify.${chapter} double ${source} INCLUDE ${exercises} ${folders} ${support})
  course_program(certify.${chapter}_solution double ${source} INCLUDE ${folders} ${support})
  set_target_properties(certify.${chapter} PROPERTIES EXCLUDE_FROM_ALL ON)
  course_of_learner(certify.${chapter})
  course_long_tests(certify.${chapter}_solution)
  if(COURSE_ALL_TESTS)
    # Other tests run at the same time: speeds say nothing.
    add_test(NAME certify.${chapter} COMMAND certify.${chapter}_solution --no-timing)
    set_tests_properties(certify.${chapter} PROPERTIES LABELS solution TIMEOUT 300
      FAIL_REGULAR_EXPRESSION "FAILS")
    course_nightly(certify.${chapter})
  endif()
endfunction()

# course_parts_of(out program): all objects of a program but its main().
function(course_parts_of out program)
  set(${out} $<FILTER:$<TARGET_OBJECTS:${program}>,EXCLUDE,main[.]cpp> PARENT_SCOPE)
endfunction()

# course_scenes_test(name script arguments...): a program that reads scene files.
function(course_scenes_test name script)
  add_test(NAME ${name} COMMAND sh ${CMAKE_SOURCE_DIR}/tests/app/${script} ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS solution TIMEOUT 300)
endfunction()

# course_given_tests(chapter): what a chapter gives beyond its exercises has tests of its own, and so have the
# program's parts.
function(course_given_tests chapter)
  file(GLOB given CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${chapter}/given/*.cpp)
  if(NOT given)
    return()
  endif()
  course_given_sources(parts ${chapter} *.cpp)
  list(FILTER parts EXCLUDE REGEX "/(study[^/]*|(main|narrowest_renderer|shown_scene|open_scene)[.]cpp)$")
  foreach(real double float)
    set(target ${chapter}_given_${real})
    course_checkpoint(${target} ${real} ${given} ${parts} INCLUDE ${course_folders_${chapter}})
    target_compile_definitions(${target} PRIVATE COURSE_ROOT="${CMAKE_SOURCE_DIR}")
    if(real STREQUAL "float")
      course_long_tests(${target})
    endif()
    if(real STREQUAL "double" OR COURSE_ALL_TESTS)
      add_test(NAME ${target} COMMAND ${target})
      set_tests_properties(${target} PROPERTIES LABELS "solution;hard" TIMEOUT 600)
    endif()
  endforeach()
endfunction()

# course_graft(chapter): the program that the chapter's graft leads to, for the learner's to be compared with.
function(course_graft chapter)
  string(SUBSTRING ${chapter} 0 2 number)
  set(source ${CMAKE_SOURCE_DIR}/solutions/tracer/${number}.cpp)
  if(NOT EXISTS ${source})
    return()
  endif()
  add_executable(tracer.${number} EXCLUDE_FROM_ALL ${source})
  course_as_program(tracer.${number})
  target_include_directories(tracer.${number} PRIVATE ${course_folders_${chapter}} ${CMAKE_SOURCE_DIR}/common)
  target_link_libraries(tracer.${number} PRIVATE course_flags Threads::Threads)
  course_linked_with(tracer.${number} -pthread)
  if(COURSE_ALL_TESTS)
    set_target_properties(tracer.${number} PROPERTIES EXCLUDE_FROM_ALL OFF)
    add_test(NAME tracer.${number} COMMAND graft_mistakes ${number})
    set_tests_properties(tracer.${number} PROPERTIES LABELS mistakes TIMEOUT 600)
    if(number MATCHES "06|07")  # times are measured
      set_tests_properties(tracer.${number} PROPERTIES RUN_SERIAL ON)
      course_nightly(tracer.${number})
    endif()
  endif()
endfunction()

# course_label_electives(): all tests of this folder get the label `elective`: project_tests does not build them.
function(course_label_electives)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test ${tests})
    set_property(TEST ${test} APPEND PROPERTY LABELS elective)
  endforeach()
endfunction()

# course_chapter(NN_topic): all targets and tests of one chapter. Its CMakeLists.txt calls this, and adds what the
# chapter alone has.
function(course_chapter chapter)
  if(chapter IN_LIST course_electives)
    set_property(DIRECTORY PROPERTY COURSE_ELECTIVE ON)
    if(NOT COURSE_ALL_TESTS)
      cmake_language(DEFER CALL course_label_electives)
    endif()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/study.cpp)
    # A study holds many loops, each of which is timed: g++ would stop inlining once the file has grown by
    # 40 %, and the loops after that would be slower than they are in a program.
    course_compile_options(study.cpp --param=inline-unit-growth=200)
  endif()
  set(folders ${course_folders_${chapter}})
  course_chapter_program(${chapter}_solution double ${chapter} ${folders})
  course_chapter_program(${chapter}_solution_float float ${chapter} ${folders})
  course_chapter_program(${chapter}_mine double ${chapter} ${COURSE_YOURS} ${folders})
  course_chapter_program(${chapter}_mine_float float ${chapter} ${COURSE_YOURS} ${folders})
  set(mine ${chapter}_mine ${chapter}_mine_float ${chapter}_mine_study ${chapter}_mine_float_study)
  if(NOT course_needs_${chapter})  # what it records would be lost between processes
    course_drawing_program(${chapter}_follow double ${chapter} ${CMAKE_SOURCE_DIR}/companion/follow/recorder
                           ${COURSE_YOURS} ${folders})
    list(APPEND mine ${chapter}_follow)
  endif()
  course_of_learner(${mine})
  set_target_properties(${mine} ${chapter}_solution_study ${chapter}_solution_float_study
                        PROPERTIES EXCLUDE_FROM_ALL ON)
  course_float_programs(${chapter}_solution_float)
  course_program_tests(${chapter})

  foreach(id ${course_ids_${chapter}})
    course_exercise(${chapter} ${id})
  endforeach()
  course_graft(${chapter})
  course_certificate(${chapter})
  course_mistake_tests(${chapter})
  course_given_tests(${chapter})

  # Scripts that check what the text says.
  file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${chapter}/*.sh)
  foreach(script ${scripts})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME ${chapter}.${name} COMMAND sh ${script} ${CMAKE_SOURCE_DIR})
    set_tests_properties(${chapter}.${name} PROPERTIES LABELS solution TIMEOUT 120
                         SKIP_RETURN_CODE 77)
  endforeach()
endfunction()
