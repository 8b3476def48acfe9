# A file that is dated in the future, such as one unpacked in another time zone, is newer than all that is built: it
# would be compiled, and CMake would configure, again and again. So it gets the current time.
set(now ${CMAKE_BINARY_DIR}/now)
file(TOUCH ${now})
if(NOT ${now} IS_NEWER_THAN ${CMAKE_ROOT}/Modules/CMakeCXXInformation.cmake)
  string(TIMESTAMP date "%Y-%m-%d")
  message(FATAL_ERROR " course: this machine's clock says ${date}, but CMake is newer: set the clock")
endif()
file(GLOB_RECURSE sources ${CMAKE_SOURCE_DIR}/chapters/* ${CMAKE_SOURCE_DIR}/cmake/* ${CMAKE_SOURCE_DIR}/common/*
     ${CMAKE_SOURCE_DIR}/companion/* ${CMAKE_SOURCE_DIR}/exercises/* ${CMAKE_SOURCE_DIR}/solutions/*
     ${CMAKE_SOURCE_DIR}/tests/*)
set(of_future "")
foreach(file ${CMAKE_SOURCE_DIR}/CMakeLists.txt ${CMAKE_SOURCE_DIR}/course.json ${sources})
  if(NOT ${now} IS_NEWER_THAN ${file})
    list(APPEND of_future ${file})
  endif()
endforeach()
if(of_future)
  list(LENGTH of_future count)
  list(GET of_future 0 first)
  file(RELATIVE_PATH first ${CMAKE_SOURCE_DIR} ${first})
  message(STATUS "Dated in the future, and now given the current time: ${count} files, such as ${first}")
  file(TOUCH_NOCREATE ${of_future})
endif()
