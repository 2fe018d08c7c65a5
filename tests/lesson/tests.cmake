# The rules of a lesson, for the tests and for the program that runs the commands of a chapter's exercises.
file(GLOB rules CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/rules/*.cpp)
add_library(lesson_rules STATIC ${rules})
target_link_libraries(lesson_rules PUBLIC project_options)
target_compile_options(lesson_rules PRIVATE -O1)
add_tests(lesson LIBRARIES lesson_rules)
add_executable(run_exercises ${CMAKE_CURRENT_LIST_DIR}/program/run_exercises.cpp)
target_link_libraries(run_exercises PRIVATE lesson_rules)
