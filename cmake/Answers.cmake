# What a checkpoint and an answer know of each other: in build/generated/NN.k, rt/NAME.hpp declares the answer's
# functions for the test cases, and answer.cpp defines them by calling the answer's.
#
# They are made from the headers of an exercise, and from those that course_headers_of_answer_NN.k names: headers of
# earlier exercises, where the test cases need the answer's own functions, too. The solution's header says what there
# is: a learner may change the exercise's. Each of its functions that begins with `inline` is called, except those in
# course_helpers, which are the solution's alone. A parameter that is no reference is const, so that an answer that
# asks for a reference to change does not compile.
#
# A rt/NAME.hpp in tests/NN_topic/NN.k is used instead: it is needed where there are templates, operators or types of
# the exercise's own. The calls of what it declares are in the answer.cpp beside it.

# course_bridge(chapter id): makes these files. Sets course_call_NN.k to the source that calls the answer, and to
# nothing if the exercise is a program of its own; course_declared_NN.k to the folders with the headers for the test
# cases.
function(course_bridge chapter id)
  set(own ${CMAKE_SOURCE_DIR}/tests/${chapter}/${id})
  set(made ${CMAKE_BINARY_DIR}/generated/${id})
  file(GLOB stale ${made}/rt/*.hpp)
  set(included "")
  set(calls "")
  foreach(header ${course_files_${id}} ${course_headers_of_answer_${id}})
    if(NOT header MATCHES "^rt/.*[.]hpp$" OR EXISTS ${own}/${header})
      continue()
    endif()
    foreach(folder ${course_folders_${chapter}})
      if(EXISTS ${folder}/${header})
        set(solution ${folder}/${header})
      endif()
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${solution})
    file(READ ${solution} text)
    string(REGEX MATCHALL "\n#include [^\n]+" includes "${text}")
    string(REGEX MATCHALL "\ninline [^{};=]+\\) {" functions "${text}")
    set(declarations "")
    foreach(function IN LISTS functions)
      string(REPLACE "[[maybe_unused]] " "" function "${function}")
      string(REGEX REPLACE "[ \n]+" " " function "${function}")
      if(NOT function MATCHES "^ inline ([^(]+) ([a-z0-9_]+)\\((.*)\\) {$" OR CMAKE_MATCH_2 IN_LIST course_helpers)
        continue()
      endif()
      set(result ${CMAKE_MATCH_1})
      set(name ${CMAKE_MATCH_2})
      set(parameters "${CMAKE_MATCH_3}")
      string(APPEND declarations "${result} ${name}(${parameters});\n")
      set(plain "${parameters}")  # without commas inside of types
      while(plain MATCHES "<[^<>]*>")
        string(REPLACE "${CMAKE_MATCH_0}" "" plain "${plain}")
      endwhile()
      string(REGEX MATCHALL "[a-z0-9_]+(,|$)" arguments "${plain}")
      list(TRANSFORM arguments REPLACE "," "")
      foreach(argument ${arguments})
        string(REGEX REPLACE "([^&]) ${argument}(,|$)" "\\1 const ${argument}\\2" parameters "${parameters}")
      endforeach()
      list(JOIN arguments ", " arguments)
      set(return "return ")
      if(result STREQUAL "void")
        set(return "")
      endif()
      string(APPEND calls "\n${result} ${name}(${parameters}) {\n    ${return}rt::${name}(${arguments});\n}\n")
    endforeach()
    file(RELATIVE_PATH from ${CMAKE_SOURCE_DIR} ${solution})
    if(NOT declarations)
      set(declarations "#error no function in ${from} can be called by rule: \
write tests/${chapter}/${id}/${header} and answer.cpp\n")
    endif()
    list(JOIN includes "" includes)
    file(CONFIGURE OUTPUT ${made}/${header} @ONLY CONTENT "#pragma once
// Made from ${from}: see cmake/Answers.cmake.
${includes}

namespace rt {
inline namespace called {

${declarations}
}  // namespace called
}  // namespace rt
")
    list(REMOVE_ITEM stale ${made}/${header})
    string(APPEND included "#include <${header}>\n")
  endforeach()
  if(stale)
    file(REMOVE ${stale})
  endif()

  set(call "")
  if(included)
    set(call ${made}/answer.cpp)
    if(EXISTS ${own}/answer.cpp)
      string(PREPEND included "#include \"${id}/answer.cpp\"\n")
    endif()
    file(CONFIGURE OUTPUT ${call} @ONLY CONTENT "// Made by cmake/Answers.cmake.
#include <answer.hpp>
${included}
namespace rt {
namespace called EXPORTED {
${calls}
}  // namespace EXPORTED
}  // namespace rt
")
  elseif(course_files_${id} MATCHES "(^|;)rt/")
    set(call ${own}/answer.cpp)
  endif()
  set(course_call_${id} "${call}" PARENT_SCOPE)
  set(course_declared_${id} ${own} ${made} PARENT_SCOPE)
endfunction()
