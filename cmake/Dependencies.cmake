# The libraries: from the system if it has them, otherwise fetched.
include(FetchContent)

find_package(Threads REQUIRED)

# Two more ways to use all cores, for chapter 06: each is skipped if it is missing. The thread sanitizer
# cannot see into these libraries and would report what is right.
if(RT_SANITIZE MATCHES "thread")
  message(STATUS "OpenMP and TBB are left out: the thread sanitizer cannot see into them")
else()
  find_package(OpenMP QUIET COMPONENTS CXX)
  if(NOT OpenMP_CXX_FOUND)
    message(STATUS "OpenMP is not installed: chapter 06 goes without it")
  endif()
  find_package(TBB QUIET CONFIG)
  if(NOT TBB_FOUND)
    message(STATUS "TBB is not installed: chapter 06 goes without std::execution::par")
  endif()
endif()
add_library(course_parallel INTERFACE)
set(course_parallel_options "")      # for the sources that use them, and no others
set(course_parallel_definitions "")
if(OpenMP_CXX_FOUND)
  separate_arguments(course_parallel_options UNIX_COMMAND "${OpenMP_CXX_FLAGS}")
  list(APPEND course_parallel_definitions RT_HAS_OPENMP)
  target_link_libraries(course_parallel INTERFACE ${OpenMP_CXX_LIBRARIES})
endif()
if(TBB_FOUND)
  list(APPEND course_parallel_definitions RT_HAS_TBB)
  target_link_libraries(course_parallel INTERFACE TBB::tbb)
endif()

# Many machines, for chapter 13, which is left out without it. No sanitizer can see into it.
set(COURSE_HAS_MPI OFF)
if(NOT RT_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
  set(MPI_CXX_SKIP_MPICXX ON)
  find_package(MPI QUIET COMPONENTS CXX)
  if(MPI_CXX_FOUND AND MPIEXEC_EXECUTABLE)
    set(COURSE_HAS_MPI ON)
    list(FILTER MPI_CXX_LIBRARIES EXCLUDE REGEX "mpi_cxx|mpicxx")
    add_library(course_mpi INTERFACE)
    target_include_directories(course_mpi SYSTEM INTERFACE ${MPI_CXX_INCLUDE_DIRS})
    target_link_libraries(course_mpi INTERFACE ${MPI_CXX_LIBRARIES})
  endif()
endif()
if(NOT COURSE_HAS_MPI)
  message(STATUS "MPI is not installed, or cannot be used: chapter 13 is left out")
endif()

# Catch2: version 3, or version 2 as older systems package it. course_catch says where it is;
# tests/support/catch.hpp hides the difference.
add_library(course_catch INTERFACE)
find_package(Catch2 3 QUIET)
if(NOT Catch2_FOUND)
  find_package(Catch2 2 QUIET)
endif()
if(NOT Catch2_FOUND)
  message(STATUS "Catch2 is not installed: fetching it")
  FetchContent_Declare(Catch2 GIT_REPOSITORY https://github.com/catchorg/Catch2.git
                              GIT_TAG v3.7.1 GIT_SHALLOW ON)
  FetchContent_MakeAvailable(Catch2)
  set(Catch2_VERSION 3)
endif()
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  target_link_libraries(course_catch INTERFACE Catch2::Catch2WithMain)
else()
  target_link_libraries(course_catch INTERFACE Catch2::Catch2)
endif()

find_package(CLI11 QUIET)
if(NOT CLI11_FOUND)
  message(STATUS "CLI11 is not installed: fetching it")
  FetchContent_Declare(CLI11 GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git
                             GIT_TAG v2.7.2 GIT_SHALLOW ON)
  FetchContent_MakeAvailable(CLI11)
endif()

# Scene files are JSON, and so is what the companion remembers.
find_package(nlohmann_json QUIET)
if(NOT nlohmann_json_FOUND)
  message(STATUS "nlohmann-json is not installed: fetching it")
  # The release's archive of headers: the repository is a thousand times as large.
  if(POLICY CMP0135)
    cmake_policy(SET CMP0135 NEW)  # unpacked files get the time of unpacking
  endif()
  set(JSON_SystemInclude ON)  # its warnings are not ours
  FetchContent_Declare(json
    URL https://github.com/nlohmann/json/releases/download/v3.11.3/json.tar.xz
    URL_HASH SHA256=d6c65aca6b1ed68e7a182f4757257b107ae403032760ed6ef121c9d55e81757d)
  FetchContent_MakeAvailable(json)
endif()

# A server, for the page that `watch` shows; without it, `watch` is the terminal alone. Packages that compile it have a
# library beside the header, and a .pc file that says with which definitions. No sanitizer can see into it.
add_library(course_httplib INTERFACE)
set(COURSE_HAS_HTTPLIB OFF)
if(NOT RT_SANITIZE AND NOT CMAKE_CROSSCOMPILING)
  find_path(HTTPLIB_INCLUDE_DIR httplib.h)
  find_library(HTTPLIB_LIBRARY cpp-httplib)
  if(HTTPLIB_INCLUDE_DIR)
    set(CMAKE_REQUIRED_INCLUDES ${HTTPLIB_INCLUDE_DIR})
    set(CMAKE_REQUIRED_LIBRARIES Threads::Threads)
    set(CMAKE_REQUIRED_DEFINITIONS "")
    if(HTTPLIB_LIBRARY)
      get_filename_component(folder ${HTTPLIB_LIBRARY} DIRECTORY)
      if(EXISTS ${folder}/pkgconfig/cpp-httplib.pc)
        file(STRINGS ${folder}/pkgconfig/cpp-httplib.pc flags REGEX "^Cflags:")
        string(REGEX MATCHALL "-DCPPHTTPLIB_[A-Z_]+" CMAKE_REQUIRED_DEFINITIONS "${flags}")
      endif()
      if(CMAKE_REQUIRED_DEFINITIONS MATCHES "OPENSSL")
        find_package(OpenSSL QUIET)
        list(APPEND CMAKE_REQUIRED_INCLUDES ${OPENSSL_INCLUDE_DIR})
      endif()
      list(APPEND CMAKE_REQUIRED_LIBRARIES ${HTTPLIB_LIBRARY})
    elseif(WIN32)
      list(APPEND CMAKE_REQUIRED_LIBRARIES ws2_32)
    endif()
    include(CheckCXXSourceCompiles)
    check_cxx_source_compiles("#include <httplib.h>\nint main() { return httplib::Server{}.bind_to_any_port(\"127.0.0.1\"); }" COURSE_LINKS_HTTPLIB)
    if(COURSE_LINKS_HTTPLIB)  # not with another standard library than its own
      set(COURSE_HAS_HTTPLIB ON)
      target_compile_definitions(course_httplib INTERFACE COURSE_HAS_HTTPLIB ${CMAKE_REQUIRED_DEFINITIONS})
      target_include_directories(course_httplib SYSTEM INTERFACE ${CMAKE_REQUIRED_INCLUDES})
      target_link_libraries(course_httplib INTERFACE ${CMAKE_REQUIRED_LIBRARIES})
    endif()
    unset(CMAKE_REQUIRED_INCLUDES)
    unset(CMAKE_REQUIRED_LIBRARIES)
    unset(CMAKE_REQUIRED_DEFINITIONS)
  endif()
endif()
if(NOT COURSE_HAS_HTTPLIB)
  message(STATUS "cpp-httplib is not installed, or cannot be used: `watch` shows no page")
endif()

# stb's image headers: course_stb says where they are.
add_library(course_stb INTERFACE)
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb)
if(NOT STB_INCLUDE_DIR)
  message(STATUS "stb is not installed: fetching it")
  # It has no releases, hence a commit.
  FetchContent_Declare(stb GIT_REPOSITORY https://github.com/nothings/stb.git
                           GIT_TAG 31c1ad37456438565541f4919958214b6e762fb4)
  FetchContent_MakeAvailable(stb)
  set(STB_INCLUDE_DIR ${stb_SOURCE_DIR})
endif()
# As system headers: their warnings are not ours.
target_include_directories(course_stb SYSTEM INTERFACE ${STB_INCLUDE_DIR})

# The reader of the material files of OBJ meshes (chapter 12), one header: course_tinyobj says where it is.
add_library(course_tinyobj INTERFACE)
find_path(TINYOBJ_INCLUDE_DIR tiny_obj_loader.h)
if(NOT TINYOBJ_INCLUDE_DIR)
  message(STATUS "tinyobjloader is not installed: fetching it")
  FetchContent_Declare(tinyobj GIT_REPOSITORY https://github.com/tinyobjloader/tinyobjloader.git
                               GIT_TAG v2.0.0rc10 GIT_SHALLOW ON SOURCE_SUBDIR none)  # only the header
  FetchContent_MakeAvailable(tinyobj)
  set(TINYOBJ_INCLUDE_DIR ${tinyobj_SOURCE_DIR})
endif()
target_include_directories(course_tinyobj SYSTEM INTERFACE ${TINYOBJ_INCLUDE_DIR})
target_compile_definitions(course_tinyobj INTERFACE TINYOBJLOADER_USE_DOUBLE)

# COURSE_PYTHON, for the tests that read C++ with libclang, if COURSE_PYTHON_HAS_CLANG: /usr/bin/python3 may have the
# libclang that another python3 lacks.
set(COURSE_PYTHON_HAS_CLANG OFF)
find_package(Python3 QUIET COMPONENTS Interpreter)
foreach(candidate ${Python3_EXECUTABLE} /usr/bin/python3)
  if(NOT COURSE_PYTHON_HAS_CLANG)
    set(COURSE_PYTHON ${candidate})
    execute_process(COMMAND ${candidate} -c "import clang.cindex" RESULT_VARIABLE lacks_clang
                    OUTPUT_QUIET ERROR_QUIET)
    if(lacks_clang EQUAL 0)
      set(COURSE_PYTHON_HAS_CLANG ON)
    endif()
  endif()
endforeach()
