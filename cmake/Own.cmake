# Chapter 09: a program from an empty folder, in one file that includes nothing of the course. Include
# after the chapters.
add_executable(09_own_solution ${CMAKE_SOURCE_DIR}/solutions/09_own/main.cpp)
target_link_libraries(09_own_solution PRIVATE course_flags Threads::Threads)
