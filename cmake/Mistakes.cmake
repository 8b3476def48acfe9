# The known mistakes: tests/mistakes/NN_topic/NN.k.md has those of one exercise, each as edits of the
# solution. companion/model/mistakes.hpp describes the format and reads it; the build itself takes from these
# files only the names, the files that are edited and the optional lines.

set(course_mistake_lines
    "changes picture|compiler warns|certificate fails|address sanitizer reports|data race in")

# course_mistake_folder(out name): where the edited files of a mistake are, in rt/.
function(course_mistake_folder out name)
  set(${out} ${CMAKE_BINARY_DIR}/mistakes/edited/${name} PARENT_SCOPE)
endfunction()

# course_mistakes_with(out chapter line): the mistakes of a chapter that have this optional line. Its value is
# the global property "NAME LINE".
function(course_mistakes_with out chapter line)
  set(found "")
  get_property(names GLOBAL PROPERTY "mistakes of ${chapter}")
  foreach(name ${names})
    get_property(has_it GLOBAL PROPERTY "${name} ${line}" SET)
    if(has_it)
      list(APPEND found ${name})
    endif()
  endforeach()
  set(${out} "${found}" PARENT_SCOPE)
endfunction()

# course_edit_mistakes(chapter): the edited files, with a target mistakes.edited.NN.k for each exercise.
function(course_edit_mistakes chapter)
  set(solution ${CMAKE_SOURCE_DIR}/solutions/${chapter})
  file(GLOB solution_files CONFIGURE_DEPENDS ${solution}/*.cpp ${solution}/rt/*)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/mistakes/${chapter}/*.md)
  foreach(file ${files})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(id ${file} NAME_WLE)
    set(name "")
    set(edited "")
    file(STRINGS ${file} lines REGEX "^(## |Replace in `|(${course_mistake_lines}): )")
    foreach(line ${lines})
      if(line MATCHES "^## (.*)$")
        set(name ${CMAKE_MATCH_1})
        course_mistake_folder(folder ${name})
        set_property(GLOBAL APPEND PROPERTY "mistakes of ${chapter}" ${name})
      elseif(line MATCHES "^Replace in `(.*)`$")
        list(APPEND edited ${folder}/${CMAKE_MATCH_1})
      elseif(line MATCHES "^(${course_mistake_lines}): (.*)$")
        set_property(GLOBAL PROPERTY "${name} ${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
      endif()
    endforeach()
    list(REMOVE_DUPLICATES edited)
    set(done ${CMAKE_BINARY_DIR}/mistakes/edited/${id}.done)
    file(RELATIVE_PATH short ${CMAKE_SOURCE_DIR} ${file})
    add_custom_command(OUTPUT ${done} BYPRODUCTS ${edited}
      COMMAND edit_mistakes ${short} solutions/${chapter} ${CMAKE_BINARY_DIR}/mistakes/edited
      COMMAND ${CMAKE_COMMAND} -E touch ${done}
      DEPENDS edit_mistakes ${file} ${solution_files}
      WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
      COMMENT "Editing the mistakes of ${id}" VERBATIM)
    add_custom_target(mistakes.edited.${id} DEPENDS ${done})
  endforeach()
endfunction()

# course_mistake_target(target name): a program that is compiled with a mistake's files.
function(course_mistake_target target name)
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
  add_dependencies(${target} mistakes.edited.${id})
  set_target_properties(${target} PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/mistakes)
endfunction()

# course_mistake(name chapter): the program mistake.NAME, the exercise's checkpoints on the mistake.
function(course_mistake name chapter)
  string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
  file(GLOB source ${CMAKE_SOURCE_DIR}/tests/${chapter}/${id}_*.cpp)
  course_mistake_folder(folder ${name})
  set(target mistake.${name})
  course_sources_of(edited ${folder} ${course_solutions})
  add_executable(${target} ${source} ${edited})
  target_include_directories(${target} PRIVATE
    ${folder} ${course_solutions} ${CMAKE_SOURCE_DIR}/tests/support)
  course_checkpoint_kind(kind ${chapter})
  target_link_libraries(${target} PRIVATE checkpoint_${kind} catch_main course_parallel)
  target_precompile_headers(${target} REUSE_FROM checkpoint_${kind})
  course_own_program(${target} ${source} INCLUDE ${folder})
  course_mistake_target(${target} ${name})
  get_property(warned GLOBAL PROPERTY "${name} compiler warns")
  if(warned)
    target_compile_options(${target} PRIVATE -w)  # the learner is told; here it is on purpose
  endif()
endfunction()

# course_mistakes_hash(out chapter id): a hash of everything that decides how the mistakes
# of an exercise turn out.
function(course_mistakes_hash out chapter id)
  set(tests ${CMAKE_SOURCE_DIR}/tests)
  file(GLOB files ${tests}/mistakes/${chapter}/${id}.md ${tests}/mistakes/${chapter}/signatures.json
       ${tests}/${chapter}/${id}_*.cpp ${tests}/${chapter}/*.hpp ${tests}/support/*
       ${CMAKE_SOURCE_DIR}/common/rt/*)
  foreach(solution ${course_solutions})
    file(GLOB_RECURSE more ${solution}/*)
    list(APPEND files ${more})
  endforeach()
  set(hashes "")
  foreach(file ${files})
    file(SHA256 ${file} hash)
    string(APPEND hashes ${hash})
  endforeach()
  string(SHA256 hash "${hashes}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${out} ${hash} PARENT_SCOPE)
endfunction()

# course_chosen_mistakes(out chapter names...): which of these mistakes are to be tried. With CHANGED,
# exercises that are as verified.txt knows them are skipped, except for a quarter of them; which quarter it
# is changes with that file.
function(course_chosen_mistakes out chapter)
  set(record ${CMAKE_SOURCE_DIR}/tests/mistakes/verified.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${record})
  file(READ ${record} verified)
  set(chosen "")
  foreach(name ${ARGN})
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
    if(NOT DEFINED is_chosen_${id})
      course_mistakes_hash(hash ${chapter} ${id})
      set_property(GLOBAL APPEND_STRING PROPERTY "mistakes verified" "${id} ${hash}\n")
      string(SHA256 lot "${id} ${verified}")
      if(COURSE_MISTAKES STREQUAL "CHANGED" AND verified MATCHES "${id} ${hash}\n" AND lot MATCHES "^[4-9a-f]")
        set(is_chosen_${id} OFF)
      else()
        set(is_chosen_${id} ON)
      endif()
    endif()
    if(is_chosen_${id})
      list(APPEND chosen ${name})
    endif()
  endforeach()
  set(${out} "${chosen}" PARENT_SCOPE)
endfunction()

# The target mistakes_verified tries all mistakes that are built, and writes verified.txt if none fails.
function(course_mistakes_verified)
  if(COURSE_MISTAKES STREQUAL "CHANGED")
    return()
  endif()
  get_property(lines GLOBAL PROPERTY "mistakes verified")
  file(WRITE ${CMAKE_BINARY_DIR}/mistakes/verified.txt "${lines}")
  add_custom_target(mistakes_verified
    COMMAND ${CMAKE_CTEST_COMMAND} -R "^mistakes[.]" --no-tests=error --output-on-failure
    COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_BINARY_DIR}/mistakes/verified.txt
            ${CMAKE_SOURCE_DIR}/tests/mistakes/verified.txt VERBATIM)
endfunction()

# course_mistake_tests(chapter): each mistake is caught by the test case that it names, and recognized by what
# fails; one test for each exercise. And the target mistake_signatures.NN_topic, to run after a mistake or a
# checkpoint has changed: what it writes belongs to the sources.
function(course_mistake_tests chapter)
  get_property(names GLOBAL PROPERTY "mistakes of ${chapter}")
  course_chosen_mistakes(names ${chapter} ${names})
  set(ids "")
  set(targets "")
  foreach(name ${names})
    course_mistake(${name} ${chapter})
    list(APPEND targets mistake.${name})
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
    list(APPEND ids ${id})
  endforeach()
  list(REMOVE_DUPLICATES ids)
  foreach(id ${ids})
    add_test(NAME mistakes.${id}
      COMMAND signature_tool --check ${CMAKE_BINARY_DIR}/mistakes ${chapter} ${id})
    set_tests_properties(mistakes.${id} PROPERTIES LABELS mistakes TIMEOUT 300)
  endforeach()
  add_custom_target(mistake_signatures.${chapter}
    COMMAND signature_tool --write ${CMAKE_BINARY_DIR}/mistakes ${chapter} DEPENDS ${targets})
  if(NOT TARGET mistake_signatures)
    add_custom_target(mistake_signatures)
  endif()
  add_dependencies(mistake_signatures mistake_signatures.${chapter})
endfunction()

# course_mistake_pictures(chapter sources...): `course compare` must see each mistake that changes the
# picture.
function(course_mistake_pictures chapter)
  course_mistakes_with(names ${chapter} "changes picture")
  if(NOT TARGET mistake_pictures)
    add_custom_target(mistake_pictures DEPENDS compare_programs)
  endif()
  foreach(name ${names})
    set(target picture.${name})
    course_mistake_folder(folder ${name})
    course_program(${target} double ${ARGN} INCLUDE ${folder} ${course_solutions})
    course_mistake_target(${target} ${name})
    add_dependencies(mistake_pictures ${target})
    add_test(NAME ${target} COMMAND compare_programs differ $<TARGET_FILE:${target}>
                                    $<TARGET_FILE:${chapter}_solution>)
    set_tests_properties(${target} PROPERTIES LABELS pictures TIMEOUT 600)
  endforeach()
endfunction()

# course_mistake_certificates(chapter source): what `course certify` measures, on some mistakes, each
# of which must make the right line fail.
function(course_mistake_certificates chapter source)
  course_mistakes_with(names ${chapter} "certificate fails")
  foreach(name ${names})
    set(target certify.mistake.${name})
    course_mistake_folder(folder ${name})
    course_program(${target} double ${source}
                   INCLUDE ${folder} ${course_solutions} ${CMAKE_SOURCE_DIR}/tests/support)
    course_mistake_target(${target} ${name})
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" id ${name})
    add_test(NAME ${target} COMMAND ${target} --no-timing)
    set_tests_properties(${target} PROPERTIES LABELS mistakes TIMEOUT 120
      PASS_REGULAR_EXPRESSION "FAILS\t${id}")
  endforeach()
endfunction()
