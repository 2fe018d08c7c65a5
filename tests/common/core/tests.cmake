# A column that an effect names and the particles lack is a compile error that names both.
add_test(NAME "common/core: a missing column is a compile error that names it"
         COMMAND ${CMAKE_COMMAND} -DCOMPILER=${CMAKE_CXX_COMPILER} -DFILE=${CMAKE_CURRENT_LIST_DIR}/compile/missing_column.cpp
                 "-DFLAGS=-std=c++20 -I${CMAKE_SOURCE_DIR}"
                 "-DEXPECTED=Needs<sph::Particles<[^>]*>, sph::Pressure>.*the particles lack a column that an effect names"
                 -P ${CMAKE_CURRENT_LIST_DIR}/compile/check.cmake)
