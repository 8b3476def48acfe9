# How all code of the course is compiled: link to course_flags.

# What real.hpp refuses is said now, and not by each file that is compiled.
string(TOUPPER "CMAKE_CXX_FLAGS_${CMAKE_BUILD_TYPE}" of_type)
separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_COMPILER_ARG1} ${CMAKE_CXX_FLAGS} ${${of_type}}")
execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${flags} -E -x c++ ${CMAKE_SOURCE_DIR}/common/rt/real.hpp
                OUTPUT_QUIET ERROR_VARIABLE said)
if(said MATCHES "the course cannot be compiled[^\n]*")
  unset(CMAKE_CXX_FLAGS CACHE)  # otherwise they stay when CXXFLAGS has changed
  message(FATAL_ERROR " course: ${CMAKE_MATCH_0}")
endif()

add_library(course_flags INTERFACE)
target_compile_options(course_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow
  # Rounding stays as the source has it: the same picture from every compiler, machine and inlining.
  -ffp-contract=off
  # std::sqrt need not set errno, which nobody reads: so no call and no branch after each
  # root. This changes no result.
  -fno-math-errno
  # "#pragma omp simd" before a loop takes effect; it needs no library.
  -fopenmp-simd)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 and 13 warn about "text" + std::string where nothing is wrong (GCC bug 105651).
  target_compile_options(course_flags INTERFACE -Wno-restrict)
  # With -O1 alone, it does not clear the upper halves of vector registers before it calls the standard library, whose
  # functions then are slow: some checkpoints take more than twice as long.
  target_compile_options(course_flags INTERFACE -fexpensive-optimizations)
endif()
# What systems do differently is in folders of these names.
set(course_system posix)
if(WIN32)
  set(course_system windows)
  # GNU's linker takes many seconds for a program there. Some compilers take this option and ignore it.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -fuse-ld=lld -Wl,--version OUTPUT_VARIABLE linker ERROR_QUIET)
  if(linker MATCHES "LLD")
    target_link_options(course_flags INTERFACE -fuse-ld=lld)
  endif()
  # As much stack as programs have elsewhere.
  target_link_options(course_flags INTERFACE -Wl,--stack,8388608)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # There g++ aligns variables on the stack to 16 bytes and believes that they are aligned to 32 (GCC bug 54412).
    target_compile_options(course_flags INTERFACE -Wa,-muse-unaligned-vector-move)
  endif()
  # MinGW's own std::fma and std::sqrt round twice.
  add_library(course_exact_math OBJECT ${CMAKE_SOURCE_DIR}/common/app/windows/exact_math.cpp)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_sources(course_exact_math PRIVATE ${CMAKE_SOURCE_DIR}/common/app/windows/utf8_names.cpp)
  endif()
  target_include_directories(course_exact_math PRIVATE ${CMAKE_SOURCE_DIR}/common)
  target_compile_options(course_exact_math PRIVATE -O2 -ffp-contract=off -fno-builtin)
  target_link_libraries(course_flags INTERFACE $<TARGET_OBJECTS:course_exact_math>)
endif()
if(RT_WERROR)
  target_compile_options(course_flags INTERFACE -Werror)
endif()
if(RT_NATIVE)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-march=native RT_HAS_NATIVE)
  if(RT_HAS_NATIVE)
    target_compile_options(course_flags INTERFACE -march=native)
    # Otherwise g++ computes the square roots of a pack of 64 bytes in two halves, by way of memory.
    check_cxx_compiler_flag(-mprefer-vector-width=512 RT_HAS_WIDE_VECTORS)
    if(RT_HAS_WIDE_VECTORS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT WIN32)
      target_compile_options(course_flags INTERFACE -mprefer-vector-width=512)
    endif()
  endif()
endif()
if(RT_SANITIZE)
  set(sanitize -fsanitize=${RT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Not in code that only tests, such as a checkpoint's test cases: it takes four times as long to compile. The
  # thread sanitizer must see both sides of a race, in which no tool takes part.
  set(unsanitized $<TARGET_PROPERTY:COURSE_UNSANITIZED>)
  if(RT_SANITIZE MATCHES "thread")
    set(unsanitized $<TARGET_PROPERTY:COURSE_TOOL>)
  endif()
  target_compile_options(course_flags INTERFACE "$<$<NOT:$<BOOL:${unsanitized}>>:${sanitize}>")
  target_compile_definitions(course_flags INTERFACE RT_SANITIZED)
  target_link_options(course_flags INTERFACE ${sanitize})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With sanitizers g++ finds uninitialized values in its own headers, where there are none.
    target_compile_options(course_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

# The two precisions: course_double is the default, course_float everything with rt::Real as float.
add_library(course_double INTERFACE)
target_link_libraries(course_double INTERFACE course_flags)
add_library(course_float INTERFACE)
target_link_libraries(course_float INTERFACE course_flags)
target_compile_definitions(course_float INTERFACE RT_REAL=float)
target_compile_options(course_float INTERFACE -Wdouble-promotion)
