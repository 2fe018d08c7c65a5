# What every target of this project is compiled with: link it with `project_options`.
add_library(project_options INTERFACE)
target_compile_features(project_options INTERFACE cxx_std_20)
target_include_directories(project_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(project_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(SPH_WARNINGS_AS_ERRORS)
    target_compile_options(project_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # False alarms of gcc 12: the deliberately undefined registers of its own AVX-512 intrinsics (gcc bug 105593),
    # std::string's operator+ (gcc bug 105651), and std::string's copies behind precompiled headers.
    target_compile_options(project_options INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized -Wno-restrict
                                                     -Wno-stringop-overflow)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    target_compile_options(project_options INTERFACE -Wno-unknown-pragmas) # GCC ivdep
endif()
# No -ffast-math: checks for NaN must work. These two are safe and let loops with square roots and
# comparisons be vectorised.
target_compile_options(project_options INTERFACE -fno-math-errno -fno-trapping-math)
if(NOT SPH_PORTABLE)
    target_compile_options(project_options INTERFACE -march=native)
endif()
if(SPH_SANITIZE)
    target_compile_definitions(project_options INTERFACE SPH_SANITIZED)  # gcc and clang have no macro in common
    target_compile_options(project_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                     -fno-omit-frame-pointer)
    target_link_options(project_options INTERFACE -fsanitize=address,undefined)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")
set(CMAKE_CXX_EXTENSIONS OFF)
