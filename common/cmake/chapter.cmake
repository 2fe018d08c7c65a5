# add_chapter(): the program of the chapter folder it is called in, named after the folder.
function(add_chapter)
    get_filename_component(name ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    string(SUBSTRING ${name} 0 2 number)
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.hpp scenes/*.cpp scenes/*.hpp figures/*.cpp figures/*.hpp)
    list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
    # Figures only draw: what computes, and is timed, stands in scenes/.
    file(GLOB figures CONFIGURE_DEPENDS figures/*.cpp)
    set_source_files_properties(${figures} main.cpp PROPERTIES COMPILE_OPTIONS -O1)
    # The figures' metadata name the source that computed them: a digest that changes with the chapter's files.
    set(revision ${CMAKE_CURRENT_BINARY_DIR}/revision.hpp)
    add_custom_command(
        OUTPUT ${revision}
        COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_CURRENT_SOURCE_DIR} -DOUTPUT=${revision}
                -P ${CMAKE_SOURCE_DIR}/common/cmake/revision.cmake
        DEPENDS ${sources} ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp
        VERBATIM)
    add_library(chapter_${number} STATIC ${sources})
    set_target_properties(chapter_${number} PROPERTIES LINKER_LANGUAGE CXX)
    precompile(chapter_${number} chapter)
    target_link_libraries(chapter_${number} PUBLIC project_options core report plot app exact)
    add_executable(${name} main.cpp ${revision})
    precompile(${name} chapter)
    target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
    target_link_libraries(${name} PRIVATE chapter_${number})
endfunction()
