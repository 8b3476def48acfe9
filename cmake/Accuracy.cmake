# The study of docs/accuracy.md, which takes longer than those of the chapters. Include after the chapters.
set(source ${CMAKE_SOURCE_DIR}/chapters/11_samples/accuracy/main.cpp)
course_program(accuracy_study double ${source} INCLUDE ${course_solutions})
course_program(accuracy_study_float float ${source} INCLUDE ${course_solutions})
set_target_properties(accuracy_study accuracy_study_float PROPERTIES EXCLUDE_FROM_ALL ON)
course_compile_options(${source} --param=inline-unit-growth=200)
