# course_chapter(NN_topic) makes all targets and tests of one chapter. The order of its include folders alone
# decides whose code a target compiles:
#
#   solution of chapter N    solutions of chapters up to N, common
#   learner's chapter N      exercises/N, solutions of chapters up to N, common
#   mine                     COURSE_YOURS, solutions up to N, common
#   a mistake                the edited files (see Mistakes.cmake), solutions up to N, common
#
# Solutions of later chapters are never among them, so no chapter can use what comes after it.
#
# Nearly everything is in headers. If a chapter's solution also has rt/NAME.cpp, the same rule decides: the
# first folder of the list that has an rt/NAME.cpp provides the one that is compiled. Only the chapter's own
# targets compile it. A learner's .cpp may still lack its definition. To link anyway, the learner's targets
# get a library of chapters/NN_topic/missing/*.cpp, definitions that throw rt::todo. From a library, a linker
# takes only what is undefined after all other files.

set(course_chapters "")   # all chapters so far
set(course_solutions "")  # their solution folders
set(course_sources "")    # the NAME.cpp that the solution of the chapter at hand has in rt/

# course_of_learner(targets...): marks targets that compile the learner's code, and so may fail to compile.
function(course_of_learner)
  set_target_properties(${ARGN} PROPERTIES COURSE_OF_LEARNER ON)
  # A forgotten return may pass in one precision and crash in the other.
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE -Werror=return-type)
  endforeach()
endfunction()

# course_long_tests(targets...): programs that only the tests with COURSE_ALL_TESTS run.
function(course_long_tests)
  if(NOT COURSE_ALL_TESTS)
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# course_sources_of(out folders...): for each rt/NAME.cpp of the chapter at hand, the one that counts.
function(course_sources_of out)
  set(sources "")
  foreach(name ${course_sources})
    foreach(folder ${ARGN})
      get_source_file_property(is_made ${folder}/rt/${name} GENERATED)
      if(is_made OR EXISTS ${folder}/rt/${name})
        list(APPEND sources ${folder}/rt/${name})
        # It is compiled as it is, without headers that it does not name.
        set_source_files_properties(${folder}/rt/${name} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
        if(name MATCHES "^parallel_")
          set_source_files_properties(${folder}/rt/${name} PROPERTIES
            COMPILE_OPTIONS "${course_parallel_options}"
            COMPILE_DEFINITIONS "${course_parallel_definitions}")
        endif()
        break()
      endif()
    endforeach()
  endforeach()
  set(${out} "${sources}" PARENT_SCOPE)
endfunction()

# course_compile_options(source option): for one file, which then cannot use headers precompiled without it.
function(course_compile_options source option)
  set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS ${option} SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# course_executable(target real sources... INCLUDE folders...): a program on common, in one precision.
function(course_executable target real)
  cmake_parse_arguments(arg "" "" "INCLUDE" ${ARGN})
  course_sources_of(sources ${arg_INCLUDE})
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS} ${sources})
  target_include_directories(${target} PRIVATE ${arg_INCLUDE})
  target_link_libraries(${target} PRIVATE common_${real})
  if(sources)
    target_link_libraries(${target} PRIVATE course_parallel)
  endif()
endfunction()

# course_program(target real sources... INCLUDE folders...): the same, and the standard library's headers
# are read once for all such programs.
function(course_program target real)
  course_executable(${target} ${real} ${ARGN})
  target_precompile_headers(${target} REUSE_FROM common_${real})
endfunction()

# course_own_program(target sources... INCLUDE folders...): exercise 00.1 is a program of its own,
# first.cpp of the first of these folders that has it. Where its checkpoint is among the sources, this
# compiles it as the learner does by hand, without the course's headers and flags, for the checkpoint
# to run.
function(course_own_program target)
  cmake_parse_arguments(arg "" "" "INCLUDE" ${ARGN})
  if(NOT arg_UNPARSED_ARGUMENTS MATCHES "/00\\.1_")
    return()
  endif()
  foreach(folder ${arg_INCLUDE})
    get_source_file_property(is_made ${folder}/first.cpp GENERATED)
    if(is_made OR EXISTS ${folder}/first.cpp)
      add_executable(${target}.first EXCLUDE_FROM_ALL ${folder}/first.cpp)
      target_compile_options(${target}.first PRIVATE -O2 -Wall -Wextra)
      set_target_properties(${target}.first PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/check)
      add_dependencies(${target} ${target}.first)
      target_compile_definitions(${target} PRIVATE
        COURSE_FIRST_PROGRAM="$<TARGET_FILE:${target}.first>")
      return()
    endif()
  endforeach()
endfunction()

# course_executable with Catch2's main: a program of test cases. The kind is double, float, or unoptimized,
# which is double.
function(course_checkpoint target kind)
  string(REPLACE unoptimized double real ${kind})
  course_executable(${target} ${real} ${ARGN})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support)
  target_link_libraries(${target} PRIVATE checkpoint_${kind} catch_main)
  target_precompile_headers(${target} REUSE_FROM checkpoint_${kind})
  course_own_program(${target} ${ARGN})
endfunction()

# course_checkpoint_kind(out chapter): how its checkpoints are compiled in double. What counts is the time for
# compiling and running them together: they are optimized only if they compute for long.
function(course_checkpoint_kind out chapter)
  if(chapter MATCHES "^0[04]_" OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
    set(${out} double PARENT_SCOPE)
  else()
    set(${out} unoptimized PARENT_SCOPE)
  endif()
endfunction()

# course_exercise_tests(checkpoint label ids...): one test per exercise, and one for its hard cases.
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

# The checkpoints on the learner's code: a program check.NN.k for each exercise, so that one that does not
# compile or crashes leaves the others alone; and NN_topic_checkpoint with all of them. The learner waits for
# these after every change: compiling them quickly matters more than their speed. PREFIX goes before the names
# of all targets, for tests that put other code in place of the learner's.
function(course_learners_checkpoints chapter)
  cmake_parse_arguments(arg "" "PREFIX" "INCLUDE;SOURCES" ${ARGN})
  set(objects "")
  course_checkpoint_kind(kind ${chapter})
  set(libraries checkpoint_${kind} catch_main)
  if(TARGET ${chapter}_missing)
    list(PREPEND libraries ${chapter}_missing)
  endif()
  course_sources_of(sources ${arg_INCLUDE})
  set(learners "")
  set(answers "")
  set(targets "")
  if(sources)
    foreach(whose learners answers)
      if(whose STREQUAL "answers")
        course_sources_of(sources ${course_solutions})
      endif()
      set(objects_${whose} ${arg_PREFIX}${chapter}_${whose})
      add_library(${objects_${whose}} OBJECT ${sources})
      target_include_directories(${objects_${whose}} PRIVATE ${arg_INCLUDE})
      target_link_libraries(${objects_${whose}} PRIVATE common_double course_parallel)
      set(${whose} $<TARGET_OBJECTS:${objects_${whose}}>)
    endforeach()
    list(APPEND libraries course_parallel)
    list(APPEND targets ${objects_learners})
  endif()
  foreach(source ${arg_SOURCES})
    get_filename_component(name ${source} NAME)
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
    set(tests ${arg_PREFIX}tests.${id})
    set(check ${arg_PREFIX}check.${id})
    add_library(${tests} OBJECT ${source})
    target_include_directories(${tests} PRIVATE ${arg_INCLUDE} ${CMAKE_SOURCE_DIR}/tests/support)
    target_link_libraries(${tests} PRIVATE checkpoint_${kind})
    target_precompile_headers(${tests} REUSE_FROM checkpoint_${kind})
    course_own_program(${tests} ${source} INCLUDE ${arg_INCLUDE})
    # The learner's NAME.cpp belongs to the exercise of tests/NN_topic/NN.k_NAME.cpp.
    set(linked ${answers})
    foreach(file ${course_sources})
      if(name STREQUAL "${id}_${file}")
        set(linked ${learners})
      endif()
    endforeach()
    add_executable(${check} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${tests}> ${linked})
    target_link_libraries(${check} PRIVATE ${libraries})
    set_target_properties(${check} PROPERTIES
      RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/check)
    list(APPEND targets ${tests} ${check})
    # The same in float, which the companion asks for when it has given its verdict.
    if(NOT TARGET ${chapter}_missing)
      set(course_sources_here ${course_sources})
      set(course_sources "")
      course_checkpoint(${check}.float float ${source} ${linked} INCLUDE ${arg_INCLUDE})
      set(course_sources ${course_sources_here})
      target_link_libraries(${check}.float PRIVATE course_parallel)
      set_target_properties(${check}.float PROPERTIES EXCLUDE_FROM_ALL ON
        RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/check)
      list(APPEND targets ${check}.float)
    endif()
    list(APPEND objects $<TARGET_OBJECTS:${tests}>)
  endforeach()
  add_executable(${arg_PREFIX}${chapter}_checkpoint ${objects} ${learners})
  target_link_libraries(${arg_PREFIX}${chapter}_checkpoint PRIVATE ${libraries})
  if(NOT arg_PREFIX)
    course_of_learner(${targets} ${chapter}_checkpoint)
  endif()
endfunction()

# What `course certify` measures of a chapter: on the solution, and on the learner's own code of all
# chapters up to this one.
function(course_certificate chapter)
  set(source ${CMAKE_SOURCE_DIR}/tests/certify/${chapter}.cpp)
  if(NOT EXISTS ${source})
    return()
  endif()
  list(TRANSFORM course_solutions REPLACE "/solutions/" "/exercises/" OUTPUT_VARIABLE exercises)
  course_program(certify.${chapter} double ${source} INCLUDE ${exercises} ${course_solutions}
                 ${CMAKE_SOURCE_DIR}/tests/support)
  course_program(certify.${chapter}_solution double ${source}
                 INCLUDE ${course_solutions} ${CMAKE_SOURCE_DIR}/tests/support)
  set_target_properties(certify.${chapter} PROPERTIES EXCLUDE_FROM_ALL ON)
  course_of_learner(certify.${chapter})
  course_long_tests(certify.${chapter}_solution)
  if(COURSE_ALL_TESTS)
    # Other tests run at the same time: speeds say nothing.
    add_test(NAME certify.${chapter} COMMAND certify.${chapter}_solution --no-timing)
    set_tests_properties(certify.${chapter} PROPERTIES LABELS solution TIMEOUT 300
      FAIL_REGULAR_EXPRESSION "FAILS")
    if(COURSE_MISTAKES)
      course_mistake_certificates(${chapter} ${source})
    endif()
  endif()
endfunction()

# course_small_picture_test(name chapter precision): the solution still draws the same bytes. An emulator
# runs programs for other processors, which CMake does for a test only where the test is the program.
function(course_small_picture_test name chapter precision)
  string(REGEX REPLACE "_double$" "" program ${chapter}_solution_${precision})
  add_test(NAME ${name}
    COMMAND sh ${CMAKE_SOURCE_DIR}/tests/app/small_picture.sh ${chapter} ${precision}
            ${CMAKE_CROSSCOMPILING_EMULATOR} $<TARGET_FILE:${program}>)
  set_tests_properties(${name} PROPERTIES LABELS solution TIMEOUT 300)
endfunction()

function(course_chapter chapter)
  set(root ${CMAKE_SOURCE_DIR})
  list(APPEND course_chapters ${chapter})
  list(APPEND course_solutions ${root}/solutions/${chapter})
  set(course_chapters ${course_chapters} PARENT_SCOPE)
  set(course_solutions ${course_solutions} PARENT_SCOPE)

  file(GLOB program CONFIGURE_DEPENDS ${root}/chapters/${chapter}/*.cpp)
  foreach(source ${program})
    if(source MATCHES "_fast_math\\.cpp$")  # measured beside the same code without
      course_compile_options(${source} -ffast-math)
    endif()
    # The same code for narrower registers, measured beside that for this machine's.
    if(RT_NATIVE AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
      if(source MATCHES "/lanes_16\\.cpp$")
        course_compile_options(${source} -mno-avx)
      elseif(source MATCHES "/lanes_32\\.cpp$")
        course_compile_options(${source} -mno-avx512f)
      endif()
    endif()
    if(source MATCHES "/study\\.cpp$" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # A study holds many loops, each of which is timed: g++ would stop inlining once the file has grown by
      # 40 %, and the loops after that would be slower than they are in a program.
      course_compile_options(${source} --param=inline-unit-growth=200)
    endif()
  endforeach()
  file(GLOB course_sources RELATIVE ${root}/solutions/${chapter}/rt CONFIGURE_DEPENDS
       ${root}/solutions/${chapter}/rt/*.cpp)
  # A source that the learner takes away or brings back changes which one is compiled.
  file(GLOB learners CONFIGURE_DEPENDS
       ${root}/exercises/${chapter}/*.cpp ${root}/exercises/${chapter}/rt/*.cpp)
  set(ids ${course_ids_${chapter}})
  set(checkpoints "")
  foreach(id ${ids})
    file(GLOB source CONFIGURE_DEPENDS ${root}/tests/${chapter}/${id}_*.cpp)
    list(LENGTH source count)
    if(NOT count EQUAL 1)
      message(FATAL_ERROR "course.json names exercise ${id}: it needs one tests/${chapter}/${id}_NAME.cpp")
    endif()
    list(APPEND checkpoints ${source})
  endforeach()
  set(learner ${root}/exercises/${chapter} ${course_solutions})

  file(GLOB missing CONFIGURE_DEPENDS ${root}/chapters/${chapter}/missing/*.cpp)
  if(missing)
    add_library(${chapter}_missing STATIC ${missing})
    target_include_directories(${chapter}_missing PRIVATE ${course_solutions})
    target_link_libraries(${chapter}_missing PUBLIC common_double)
  endif()

  course_program(${chapter} double ${program} INCLUDE ${learner})
  course_of_learner(${chapter})
  course_program(${chapter}_solution double ${program} INCLUDE ${course_solutions})
  course_program(${chapter}_solution_float float ${program} INCLUDE ${course_solutions})
  course_learners_checkpoints(${chapter} INCLUDE ${learner} SOURCES ${checkpoints})
  course_checkpoint_kind(kind ${chapter})
  course_checkpoint(${chapter}_checkpoint_solution ${kind} ${checkpoints}
                    INCLUDE ${course_solutions})
  course_checkpoint(${chapter}_checkpoint_solution_float float ${checkpoints}
                    INCLUDE ${course_solutions})

  course_program(${chapter}_mine double ${program} INCLUDE ${COURSE_YOURS} ${course_solutions})
  course_program(${chapter}_mine_float float ${program} INCLUDE ${COURSE_YOURS} ${course_solutions})
  course_of_learner(${chapter}_mine ${chapter}_mine_float)
  set_target_properties(${chapter}_mine ${chapter}_mine_float PROPERTIES EXCLUDE_FROM_ALL ON)

  if(missing)
    foreach(target ${chapter} ${chapter}_mine)
      target_link_libraries(${target} PRIVATE ${chapter}_missing)
    endforeach()
  endif()

  course_exercise_tests(${chapter}_checkpoint exercise ${ids})
  course_exercise_tests(${chapter}_checkpoint_solution solution ${ids})
  course_long_tests(${chapter}_checkpoint_solution_float)
  if(COURSE_ALL_TESTS)
    course_exercise_tests(${chapter}_checkpoint_solution_float solution ${ids})
  endif()

  if(COURSE_CHECK_STUBS)
    foreach(id ${ids})
      # Every single test case must end by saying what is still to be written: none may pass.
      add_test(NAME shipped.${id} COMMAND ${chapter}_checkpoint "[${id}]")
      set_tests_properties(shipped.${id} PROPERTIES LABELS shipped TIMEOUT 20
        PASS_REGULAR_EXPRESSION "is still to be written.*test cases: +[0-9]+ \\|( +0 passed \\|)? +[0-9]+ failed"
        FAIL_REGULAR_EXPRESSION "SIG[A-Z]+")
    endforeach()
  endif()

  course_edit_mistakes(${chapter})
  if(COURSE_ALL_TESTS AND COURSE_MISTAKES)
    course_mistake_tests(${chapter})
  endif()
  if(COURSE_MISTAKE_PICTURES)
    course_mistake_pictures(${chapter} ${program})
  endif()

  course_certificate(${chapter})

  # What a chapter gives beyond its exercises has tests of its own, and so have the program's parts.
  file(GLOB given CONFIGURE_DEPENDS ${root}/tests/${chapter}/given/*.cpp)
  set(parts ${program})
  list(FILTER parts EXCLUDE REGEX "/(main|study|narrowest_renderer)\\.cpp$")
  if(given)
    foreach(real double float)
      course_checkpoint(${chapter}_given_${real} ${real} ${given} ${parts}
                        INCLUDE ${course_solutions} ${root}/chapters/${chapter})
      target_compile_definitions(${chapter}_given_${real} PRIVATE COURSE_ROOT="${root}")
      if(real STREQUAL "float")
        course_long_tests(${chapter}_given_float)
      endif()
      if(real STREQUAL "double" OR COURSE_ALL_TESTS)
        add_test(NAME ${chapter}_given_${real} COMMAND ${chapter}_given_${real})
        set_tests_properties(${chapter}_given_${real} PROPERTIES LABELS "solution;hard" TIMEOUT 600)
      endif()
    endforeach()
  endif()

  # Scripts that check what the text says.
  file(GLOB scripts CONFIGURE_DEPENDS ${root}/tests/${chapter}/*.sh)
  foreach(script ${scripts})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME ${chapter}.${name} COMMAND sh ${script} ${root})
    set_tests_properties(${chapter}.${name} PROPERTIES LABELS solution TIMEOUT 120
                         SKIP_RETURN_CODE 77)
  endforeach()

  # The program still draws its picture, and refuses what it should.
  course_small_picture_test(${chapter}.small_picture ${chapter} double)
  add_test(NAME ${chapter}.bad_input
    COMMAND sh ${root}/tests/app/bad_input.sh $<TARGET_FILE:${chapter}_solution>)
  set_tests_properties(${chapter}.bad_input PROPERTIES LABELS solution TIMEOUT 300)
  course_long_tests(${chapter}_solution_float)
  if(COURSE_ALL_TESTS)
    course_small_picture_test(${chapter}.small_picture_in_float ${chapter} float)
    # It is the picture that the text shows.
    add_test(NAME ${chapter}.image
      COMMAND sh ${root}/tests/app/same_image.sh $<TARGET_FILE:${chapter}_solution>
              $<TARGET_FILE:image_compare> ${root}/docs/images/${chapter}.png)
    add_test(NAME ${chapter}.float_program
      COMMAND ${chapter}_solution_float --quiet --width 192 --height 108
              --out ${CMAKE_BINARY_DIR}/${chapter}_float.png)
    # `course compare` does not call right code wrong; see tests/support/compare_programs.cpp for
    # more runs. A still picture takes one.
    add_test(NAME ${chapter}.compare
      COMMAND compare_programs alarms 1 $<TARGET_FILE:${chapter}_solution>)
    set_tests_properties(${chapter}.image ${chapter}.float_program ${chapter}.compare
                         PROPERTIES LABELS solution TIMEOUT 600)
  endif()
endfunction()

# Once after the last chapter: targets over all of them.
function(course_finish)
  set(programs ${course_chapters})
  list(TRANSFORM programs APPEND _solution OUTPUT_VARIABLE solutions)
  list(TRANSFORM programs APPEND _solution_float OUTPUT_VARIABLE float_solutions)
  list(TRANSFORM programs APPEND _checkpoint_solution OUTPUT_VARIABLE checkpoints)
  list(TRANSFORM programs APPEND _checkpoint_solution_float OUTPUT_VARIABLE float_checkpoints)
  set(mine ${course_chapters})
  list(TRANSFORM mine APPEND _mine)
  add_custom_target(solution_programs DEPENDS ${solutions} 09_own_solution)
  add_custom_target(study_programs DEPENDS ${solutions} ${float_solutions})
  add_custom_target(solution_checkpoints_double DEPENDS ${checkpoints})
  add_custom_target(solution_checkpoints DEPENDS solution_checkpoints_double ${float_checkpoints})
  add_custom_target(mine DEPENDS ${mine})
  # All that the tests run, and nothing that a learner may have left half-written. The stubs as
  # shipped are code of the project.
  set(tested "")
  foreach(folder ${CMAKE_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/common ${CMAKE_SOURCE_DIR}/companion
          ${CMAKE_SOURCE_DIR}/tests)
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
      get_target_property(kind ${target} TYPE)
      get_target_property(of_learner ${target} COURSE_OF_LEARNER)
      get_target_property(left_out ${target} EXCLUDE_FROM_ALL)
      if(kind MATCHES "EXECUTABLE|MODULE" AND NOT left_out AND (COURSE_CHECK_STUBS OR NOT of_learner))
        list(APPEND tested ${target})
      endif()
    endforeach()
  endforeach()
  add_custom_target(project_tests DEPENDS ${tested})
  # To run after a stub has changed: what it writes belongs to the sources.
  add_custom_target(shipped_stubs COMMAND stub_tool ${course_chapters})
  if(COURSE_ALL_TESTS AND COURSE_MISTAKES)
    course_mistakes_verified()
  endif()
endfunction()
