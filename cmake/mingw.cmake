# Programs for Windows, made on Debian by g++-mingw-w64-x86-64-posix and run by wine64:
#
#   cmake --preset release -B build-mingw -DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw.cmake
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
get_filename_component(platforms ${CMAKE_CURRENT_LIST_DIR}/../tests/platforms ABSOLUTE)
set(CMAKE_CROSSCOMPILING_EMULATOR ${platforms}/wine.sh)
# The compiler's own linker and archiver take a hundred times as long as those of LLVM.
find_program(COURSE_LLD ld.lld)
if(COURSE_LLD)
  foreach(kind EXE SHARED)
    set(CMAKE_${kind}_LINKER_FLAGS_INIT "-wrapper ${platforms}/lld.sh")
  endforeach()
endif()
find_program(CMAKE_AR NAMES llvm-ar x86_64-w64-mingw32-ar)
find_program(CMAKE_RANLIB NAMES llvm-ranlib x86_64-w64-mingw32-ranlib)

# Of the system's libraries, those that are headers alone, and nothing else of /usr.
set(CMAKE_FIND_ROOT_PATH ${CMAKE_BINARY_DIR}/headers /usr/x86_64-w64-mingw32)
foreach(kind INCLUDE LIBRARY PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
get_property(is_trying GLOBAL PROPERTY IN_TRY_COMPILE)
if(is_trying)
  return()
endif()
# CMake does not recognize what the wrapper prints.
set(OpenMP_CXX_FLAGS -fopenmp)
set(OpenMP_CXX_LIB_NAMES gomp)
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libgomp.dll.a OUTPUT_VARIABLE OpenMP_gomp_LIBRARY
                OUTPUT_STRIP_TRAILING_WHITESPACE)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers/include)
foreach(header catch2 CLI nlohmann stb tiny_obj_loader.h)
  if(EXISTS /usr/include/${header})
    file(CREATE_LINK /usr/include/${header} ${CMAKE_BINARY_DIR}/headers/include/${header} SYMBOLIC)
  endif()
endforeach()
# Catch2's own main(), which is not linked; but it must be there.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers/lib)
file(TOUCH ${CMAKE_BINARY_DIR}/headers/lib/libCatch2WithMain.a)
foreach(package lib/cmake/Catch2 share/cmake/CLI11 share/cmake/nlohmann_json)
  if(EXISTS /usr/${package})
    get_filename_component(folder ${package} DIRECTORY)
    file(COPY /usr/${package} DESTINATION ${CMAKE_BINARY_DIR}/headers/${folder})
  endif()
endforeach()
