# The rules of a lesson, and the tests that hold the texts to them.
file(GLOB rules CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/rules/*.cpp)
add_library(lesson_rules STATIC ${rules})
target_link_libraries(lesson_rules PUBLIC project_options)
target_compile_options(lesson_rules PRIVATE -O1)
add_tests(lesson LIBRARIES lesson_rules)
