# The facts of course.json. course_names: the chapters of exercises in their order; course_electives: those of them that
# are not part of the core. For each chapter course_ids_NN_topic, its exercises; course_files_NN.k, the files that the
# learner writes for one; course_text_NN_topic, the file of its text; course_given_NN_topic, the folders of what
# is given: the chapter's own and, where there are several kinds of headers, those in it that have an rt/; and
# course_folders_NN_topic, the include folders of its solution: what is given and the answers, of all chapters up to
# this one, so that no chapter can use what comes after it.
# course_needs_NN_topic names what else a chapter needs. If that is missing here, the chapter is left out, and
# course_missing names it.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/course.json)
file(READ ${CMAKE_SOURCE_DIR}/course.json course_json)

# course_fact(out GET|LENGTH keys...): a value in the file, or the length of a list in it.
function(course_fact out mode)
  string(JSON value ERROR_VARIABLE error ${mode} "${course_json}" ${ARGN})
  if(error)
    message(FATAL_ERROR "course.json needs a value at: ${ARGN} (${error})")
  endif()
  set(${out} ${value} PARENT_SCOPE)
endfunction()

set(course_names "")
set(course_electives "")
set(course_missing "")
set(folders "")
course_fact(chapters LENGTH chapters)
math(EXPR last_chapter "${chapters} - 1")
foreach(chapter RANGE ${last_chapter})
  course_fact(name GET chapters ${chapter} name)
  string(JSON scene ERROR_VARIABLE has_exercises GET "${course_json}" chapters ${chapter} scene)
  if(NOT has_exercises)
    continue()
  endif()
  string(JSON needs ERROR_VARIABLE needs_nothing GET "${course_json}" chapters ${chapter} needs)
  if(needs_nothing)
    set(needs "")
  elseif(NOT COURSE_HAS_${needs})
    list(APPEND course_missing ${needs})
    continue()
  endif()
  set(course_needs_${name} ${needs})
  course_fact(course_text_${name} GET chapters ${chapter} text)
  file(GLOB kinds CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/chapters/${name}/*/rt)
  list(TRANSFORM kinds REPLACE "/rt$" "")
  set(course_given_${name} ${CMAKE_SOURCE_DIR}/chapters/${name} ${kinds})
  list(APPEND folders ${course_given_${name}} ${CMAKE_SOURCE_DIR}/solutions/${name})
  set(course_folders_${name} ${folders})
  course_fact(exercises LENGTH chapters ${chapter} exercises)
  math(EXPR last_exercise "${exercises} - 1")
  set(course_ids_${name} "")
  foreach(exercise RANGE ${last_exercise})
    course_fact(id GET chapters ${chapter} exercises ${exercise} id)
    list(APPEND course_ids_${name} ${id})
    set(course_files_${id} "")
    course_fact(files LENGTH chapters ${chapter} exercises ${exercise} files)
    math(EXPR last_file "${files} - 1")
    foreach(number RANGE ${last_file})
      course_fact(file GET chapters ${chapter} exercises ${exercise} files ${number})
      list(APPEND course_files_${id} ${file})
      # Used until the companion puts the learner's files there. All exist from the start: a build that found a
      # header in another folder would not look here again.
      if(file MATCHES "^rt/" AND NOT EXISTS ${CMAKE_BINARY_DIR}/yours/${file})
        file(COPY ${CMAKE_SOURCE_DIR}/solutions/${name}/${file} DESTINATION ${CMAKE_BINARY_DIR}/yours/rt)
      endif()
    endforeach()
  endforeach()
  list(APPEND course_names ${name})
  course_fact(is_core GET chapters ${chapter} core)
  if(NOT is_core)
    list(APPEND course_electives ${name})
  endif()
endforeach()
set(course_folders ${folders})  # of all chapters
