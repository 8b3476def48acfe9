# Embree, with which chapter 10 is compared: tests/10_batches/peers/README.md. Include after the chapters. If
# Embree 3 is found there is a target embree_peer; nothing needs it.
find_path(RT_EMBREE_INCLUDE embree3/rtcore.h)
find_library(RT_EMBREE_LIBRARY embree3)
mark_as_advanced(RT_EMBREE_INCLUDE RT_EMBREE_LIBRARY)
if(RT_EMBREE_INCLUDE AND RT_EMBREE_LIBRARY)
  course_program(embree_peer float ${CMAKE_SOURCE_DIR}/tests/10_batches/peers/embree_peer.cpp
                 INCLUDE ${CMAKE_SOURCE_DIR}/solutions/10_batches ${course_solutions})
  target_include_directories(embree_peer SYSTEM PRIVATE ${RT_EMBREE_INCLUDE})
  target_link_libraries(embree_peer PRIVATE ${RT_EMBREE_LIBRARY})
  set_target_properties(embree_peer PROPERTIES EXCLUDE_FROM_ALL ON)
else()
  message(STATUS "Embree is not installed: the program that compares chapter 10 with it is left out")
endif()
