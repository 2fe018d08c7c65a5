# The tests of the program `exact` run it.
add_dependencies(common_exact_tests exact_program)
target_compile_definitions(common_exact_tests PRIVATE EXACT_PROGRAM="$<TARGET_FILE:exact_program>")
