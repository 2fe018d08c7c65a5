# Headers that many files read, read once, and small files compiled together: half of the build's time. A file still
# names what it includes; clang-tidy in .ci/run reads it by itself, and shows where one does not.
option(SPH_FAST_BUILD "Precompile common headers and compile small files together" ON)

set(precompiled_std <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory>
    <numbers> <optional> <random> <set> <span> <sstream> <stdexcept> <string> <string_view> <tuple> <utility> <vector>)
set(precompiled_engine ${precompiled_std} "${CMAKE_SOURCE_DIR}/common/core/boundary.hpp"
    "${CMAKE_SOURCE_DIR}/common/core/integrated.hpp" "${CMAKE_SOURCE_DIR}/common/core/neighbours.hpp"
    "${CMAKE_SOURCE_DIR}/common/core/pass.hpp")
set(precompiled_chapter ${precompiled_engine} "${CMAKE_SOURCE_DIR}/common/plot/looks.hpp"
    "${CMAKE_SOURCE_DIR}/common/report/chapter.hpp" "${CMAKE_SOURCE_DIR}/common/report/method.hpp")
set(precompiled_test ${precompiled_std} <catch2/catch.hpp>)
set(precompiled_engine_test ${precompiled_engine} <catch2/catch.hpp>)

# precompile(target set): the headers of one of the sets above, which all targets that name it share.
function(precompile target set)
    # gcc 13 and later refuse headers that were precompiled at -O3 where -O1 uses them.
    if(NOT SPH_FAST_BUILD OR
       (CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13))
        return()
    endif()
    if(NOT TARGET precompiled_${set}_headers)
        file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/precompiled_${set}.cpp CONTENT "")
        add_library(precompiled_${set}_headers OBJECT ${CMAKE_BINARY_DIR}/precompiled_${set}.cpp)
        target_link_libraries(precompiled_${set}_headers PRIVATE project_options)
        if(set MATCHES "test")
            target_link_libraries(precompiled_${set}_headers PRIVATE catch_main)
        endif()
        target_precompile_headers(precompiled_${set}_headers PRIVATE ${precompiled_${set}})
    endif()
    target_precompile_headers(${target} REUSE_FROM precompiled_${set}_headers)
endfunction()

# compile_together(target files): the target's files in units of so many. Names of unnamed namespaces must differ.
function(compile_together target files)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${SPH_FAST_BUILD} UNITY_BUILD_BATCH_SIZE ${files})
endfunction()
