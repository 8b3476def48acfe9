# Chapter 09: a program from an empty folder, in one file that includes nothing of the course. Include
# after the chapters.
set(own_start ${CMAKE_SOURCE_DIR}/chapters/09_own/start)
set(own_solution ${CMAKE_SOURCE_DIR}/solutions/09_own)
add_executable(09_own_solution ${own_solution}/main.cpp)
target_link_libraries(09_own_solution PRIVATE course_flags Threads::Threads)
add_dependencies(companion_test 09_own_solution)  # which draws what the judge makes up

# It draws the three scenes, small: the same bytes as always; and the linear list draws the same.
course_small_picture_test(09_own.small_picture 09_own double)
add_test(NAME 09_own.small_pictures
  COMMAND sh ${CMAKE_SOURCE_DIR}/tests/09_own/small_pictures.sh $<TARGET_FILE:09_own_solution>
          ${own_start}/scenes)
set_tests_properties(09_own.small_pictures PROPERTIES LABELS solution TIMEOUT 300)
if(NOT COURSE_ALL_TESTS)
  return()
endif()

# The verdict on our answer, in a folder as a learner has it; and the picture of the text.
add_test(NAME 09_own.judge
  COMMAND own_mistakes $<TARGET_FILE:09_own_solution> ${own_start} ${own_solution})
add_test(NAME 09_own.image
  COMMAND sh ${CMAKE_SOURCE_DIR}/tests/09_own/same_image.sh $<TARGET_FILE:09_own_solution>
          $<TARGET_FILE:image_compare> ${own_start}/scenes/many.txt
          ${CMAKE_SOURCE_DIR}/docs/images/09_own.png)
set_tests_properties(09_own.judge 09_own.image PROPERTIES LABELS solution TIMEOUT 900)

# Wrong answers: each fails at the line of the verdict that is meant for it.
if(COURSE_MISTAKES)
  file(GLOB mistakes CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/mistakes/09_own/*.md)
  foreach(file ${mistakes})
    get_filename_component(name ${file} NAME_WE)
    add_test(NAME 09_own.mistakes.${name}
      COMMAND own_mistakes $<TARGET_FILE:09_own_solution> ${own_start} ${own_solution} ${file})
    set_tests_properties(09_own.mistakes.${name} PROPERTIES LABELS mistakes TIMEOUT 1200)
  endforeach()
  # Measuring times needs the machine for itself.
  set_tests_properties(09_own.judge 09_own.mistakes.speed PROPERTIES RUN_SERIAL ON)
endif()
