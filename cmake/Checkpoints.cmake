# Checkpoints are compiled once, and each answer alone. For exercise NN.k there are, in both precisions,
#
#   check.NN.k    the program of its test cases, tests/NN_topic/NN.k_NAME.cpp
#   answer.NN.k   a library: an answer.cpp hands the solution's functions to the test cases, see cmake/Answers.cmake
#   yours.NN.k    the same library, of what the learner wrote
#
# and in float the same with .float at the end. check.NN.k finds other headers in place of the exercise's: these
# declare the library's functions. It is linked to answer.NN.k, and takes another library of that name from the folder
# that LD_LIBRARY_PATH names (PATH on Windows): the learner's, or that of a mistake.
include(Answers)

set(course_answers ${CMAKE_BINARY_DIR}/answers)  # in it: solution/double, yours/float and so on
if(APPLE)
  set(course_library_path DYLD_LIBRARY_PATH)
elseif(WIN32)
  set(course_library_path PATH)
else()
  set(course_library_path LD_LIBRARY_PATH)
endif()
include(CheckLinkerFlag)
# A linker that takes a third of the time of the usual one. Sanitizers know the usual one best, and it knows no
# other processors.
check_linker_flag(CXX -fuse-ld=gold RT_HAS_GOLD)
set(course_fast_linker "")
if(RT_HAS_GOLD AND NOT RT_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
  set(course_fast_linker -fuse-ld=gold)
endif()
check_linker_flag(CXX -Wl,--no-undefined RT_HAS_NO_UNDEFINED)
set(course_answer_linker ${course_fast_linker})
if(RT_HAS_NO_UNDEFINED AND NOT RT_SANITIZE)
  list(APPEND course_answer_linker -Wl,--no-undefined)
endif()
# An answer takes memory as its checkpoint does: see tests/support/windows/answer_memory.cpp.
set(course_answer_memory "")
if(WIN32)
  set(course_answer_memory -Wl,--wrap=_Znwy)
  list(APPEND course_answer_linker ${course_answer_memory})
endif()
# The folder that the environment names comes before the one that is written into the program.
check_linker_flag(CXX -Wl,--enable-new-dtags RT_HAS_NEW_DTAGS)
set(course_check_linker "")
if(RT_HAS_NEW_DTAGS)
  set(course_check_linker -Wl,--enable-new-dtags)
endif()

# course_of_learner(targets...): marks targets that compile the learner's code, and so may fail to compile.
function(course_of_learner)
  set_target_properties(${ARGN} PROPERTIES COURSE_OF_LEARNER ON)
  # A forgotten return may pass in one precision and crash in the other.
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE -Werror=return-type)
  endforeach()
endfunction()

# course_linked_with(target words...): what the linker gets for this target after the objects, in
# link/TARGET.txt, for those who compile it again with other headers: the companion and mistake_tool, which take
# the rest from compile_commands.json.
function(course_linked_with target)
  if(TARGET course_exact_math)
    list(APPEND ARGN "$<JOIN:$<TARGET_OBJECTS:course_exact_math>,\n>")
  endif()
  list(JOIN ARGN "\n" words)
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/link/${target}.txt CONTENT "${words}\n" NEWLINE_STYLE UNIX)
endfunction()

# course_as_answer(target real place chapter id folders...): makes a library an answer to this exercise, with the
# headers of these folders. It goes to answers/PLACE.
function(course_as_answer target real place chapter id)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:answer_${real}>)
  target_include_directories(${target} PRIVATE ${ARGN} ${CMAKE_SOURCE_DIR}/tests/${chapter}
                                               ${CMAKE_SOURCE_DIR}/tests/support
                                               ${CMAKE_SOURCE_DIR}/tests/support/${course_system})
  target_link_libraries(${target} PRIVATE answer_${real}_flags ${course_libraries_of_answer_${id}})
  target_link_options(${target} PRIVATE ${course_fast_linker})
  target_precompile_headers(${target} REUSE_FROM answer_${real})
  if(course_targets_of_answer_${id})
    add_dependencies(${target} ${course_targets_of_answer_${id}})
  endif()
  set_target_properties(${target} PROPERTIES OUTPUT_NAME answer.${id} DEFINE_SYMBOL ""
    LIBRARY_OUTPUT_DIRECTORY ${course_answers}/${place}
    # Where this is a DLL:
    PREFIX lib RUNTIME_OUTPUT_DIRECTORY ${course_answers}/${place} ARCHIVE_OUTPUT_DIRECTORY ${course_answers}/${place})
  course_linked_with(${target} -shared ${course_answer_linker}
                     "$<JOIN:$<FILTER:$<TARGET_OBJECTS:answer_${real}>,EXCLUDE,[.][gp]ch$>,\n>"
                     ${course_libraries_of_answer_${id}})
endfunction()

# course_answer(target real place chapter id folders...): the answer, from the first of these folders that
# has it. One that is a program of its own is compiled as the learner does by hand, without the course's headers and
# flags.
function(course_answer target real place chapter id)
  set(sources "")
  foreach(file ${course_files_${id}})
    foreach(folder ${ARGN})
      if(file MATCHES "[.]cpp$" AND EXISTS ${folder}/${file})
        list(APPEND sources ${folder}/${file})
        break()
      endif()
    endforeach()
  endforeach()
  if(NOT course_call_${id})
    add_executable(${target} ${sources})
    target_compile_options(${target} PRIVATE -O2 -Wall -Wextra)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME answer.${id}
      RUNTIME_OUTPUT_DIRECTORY ${course_answers}/${place})
    course_linked_with(${target})
    return()
  endif()
  add_library(${target} SHARED ${course_call_${id}} ${sources})
  course_as_answer(${target} ${real} ${place} ${chapter} ${id} ${ARGN})
endfunction()

# course_with_answers(test place): the test runs a checkpoint on the answer in answers/PLACE.
function(course_with_answers test place)
  set(folder ${course_answers}/${place})
  set_tests_properties(${test} PROPERTIES ENVIRONMENT_MODIFICATION
    "${course_library_path}=path_list_prepend:${folder};COURSE_ANSWER=set:${folder}")
endfunction()

# course_checkpoint(target real [SANITIZED] sources... INCLUDE folders...): a program of test cases on common.
# SANITIZED if what it tests is in headers.
function(course_checkpoint target real)
  cmake_parse_arguments(arg "SANITIZED" "" "" ${ARGN})
  course_executable(${target} ${real} ${arg_UNPARSED_ARGUMENTS})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support)
  target_link_libraries(${target} PRIVATE checkpoint_${real} catch_main)
  if(arg_SANITIZED AND RT_SANITIZE)
    target_precompile_headers(${target} PRIVATE ${CMAKE_SOURCE_DIR}/tests/support/catch.hpp)
  else()
    set_target_properties(${target} PROPERTIES COURSE_UNSANITIZED ON)
    target_precompile_headers(${target} REUSE_FROM checkpoint_${real})
  endif()
endfunction()

# course_exercise(chapter id): all of these targets, and their tests.
function(course_exercise chapter id)
  file(GLOB source CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${chapter}/${id}_*.cpp)
  list(LENGTH source count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "course.json names exercise ${id}: it needs one tests/${chapter}/${id}_NAME.cpp")
  endif()
  course_bridge(${chapter} ${id})
  set(folders ${course_folders_${chapter}})
  foreach(real double float)
    set(float "")
    if(real STREQUAL "float")
      set(float .float)
    endif()
    set(check check.${id}${float})
    set(answer answer.${id}${float})
    set(yours yours.${id}${float})
    course_answer(${answer} ${real} solution/${real} ${chapter} ${id} ${folders})
    course_answer(${yours} ${real} yours/${real} ${chapter} ${id} ${CMAKE_SOURCE_DIR}/exercises/${chapter} ${folders})
    course_of_learner(${yours})
    # A fraction that is dropped unasked is told, as in `int c = dot(f, f)`.
    target_compile_options(${yours} PRIVATE -Wfloat-conversion)
    course_checkpoint(${check} ${real} ${source}
                      INCLUDE ${course_declared_${id}} ${folders})
    set_target_properties(${check} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/check
                                              LINK_DEPENDS_NO_SHARED ON)
    get_target_property(kind ${answer} TYPE)
    if(kind STREQUAL "EXECUTABLE")
      add_dependencies(${check} ${answer})
    else()
      target_link_libraries(${check} PRIVATE ${answer})
      target_link_options(${check} PRIVATE ${course_check_linker})
    endif()
    if(real STREQUAL "float")
      course_long_tests(${check} ${answer} ${yours})
      if(NOT COURSE_ALL_TESTS)
        continue()
      endif()
    endif()
    add_test(NAME checkpoint.${id}${float} COMMAND ${check} -w NoAssertions)
    # An exercise without a test case would pass unseen.
    set_tests_properties(checkpoint.${id}${float} PROPERTIES LABELS solution TIMEOUT 120
      FAIL_REGULAR_EXPRESSION "No tests ran")
    course_with_answers(checkpoint.${id}${float} solution/${real})
    if(COURSE_CHECK_STUBS)
      # Every single test case must end by saying what is still to be written: none may pass.
      add_test(NAME shipped.${id}${float} COMMAND ${check})
      course_with_answers(shipped.${id}${float} yours/${real})
      set_tests_properties(shipped.${id}${float} PROPERTIES LABELS shipped TIMEOUT 20
        PASS_REGULAR_EXPRESSION "is still to be written.*test cases: +[0-9]+ \\|( +0 passed \\|)? +[0-9]+ failed"
        FAIL_REGULAR_EXPRESSION "SIG[A-Z]+")
    endif()
  endforeach()

  # The plain answers of a chapter pass its cores.
  set(plain ${CMAKE_SOURCE_DIR}/tests/plain/${chapter})
  if(COURSE_ALL_TESTS AND EXISTS ${plain} AND course_call_${id})
    course_answer(plain.${id} double plain/double ${chapter} ${id} ${plain} ${folders})
    add_test(NAME plain.${id} COMMAND check.${id} "[${id}]~[hard]")
    set_tests_properties(plain.${id} PROPERTIES LABELS solution TIMEOUT 120 FAIL_REGULAR_EXPRESSION "No tests ran")
    course_with_answers(plain.${id} plain/double)
  endif()

  # For those who do without ./course.
  foreach(part core stars)
    set(tags "[${id}]~[hard]")
    if(part STREQUAL "stars")
      set(tags "[${id}][hard]")
    endif()
    add_test(NAME yours.${id}.${part} COMMAND check.${id} ${tags})
    set_tests_properties(yours.${id}.${part} PROPERTIES LABELS exercise TIMEOUT 120)
    course_with_answers(yours.${id}.${part} yours/double)
  endforeach()
endfunction()
