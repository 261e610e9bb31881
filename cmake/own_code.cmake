# Sources of one room are compiled together, ten at a time, since most of the time of one alone goes
# into the headers that all of them read. A name that two of them give to something of their own is
# an error then: name it by what it is. -DKERF_TOGETHER=OFF compiles each alone.
function(kerf_compile_together target)
  if(NOT KERF_TOGETHER)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH room)
    if(NOT source MATCHES "^/.*[.]cpp$")  # programs have one source, named by hand
      continue()
    endif()
    string(MAKE_C_IDENTIFIER "${target}_${room}" key)
    list(APPEND of_${key} ${source})
    list(LENGTH of_${key} count)
    math(EXPR part "(${count} - 1) / 10")
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${room})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${name}/${part}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# Flags for code that is ours: warnings are errors, and floating-point contraction is off because
# fused multiply-adds would change signs in the predicates that decide topology.
function(kerf_own_code target)
  kerf_compile_together(${target})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         -Wno-sign-conversion -Wno-float-conversion -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC bug 105651: "text" + string, with precompiled headers in three ways
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow
                           -Wno-array-bounds -Wno-stringop-overread)
  elseif(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # Takes a key that is made for a look-up for what the look-up returns.
    target_compile_options(${target} PRIVATE -Wno-dangling-reference)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # GCC bug 80635: an empty std::optional that is copied; and CGAL and instrumented headers
    target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
  endif()
  if(KERF_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(KERF_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                           -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  kerf_prelude(${target})
endfunction()

# What every source of ours reads first; also for code to which our warnings don't apply.
# kerf_prelude(TARGET <FURTHER HEADER>)
function(kerf_prelude target)
  foreach(header ${PROJECT_SOURCE_DIR}/cmake/prelude.h ${ARGN})
    if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
      target_compile_options(${target} PRIVATE "SHELL:-include ${header}")
    else()
      target_precompile_headers(${target} PRIVATE ${header})
    endif()
  endforeach()
endfunction()

# For what nobody waits for when it runs, such as panels and command lines: a fifth less time to
# compile than with all optimisations.
function(kerf_lightly_optimised target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# What most of our sources read besides the prelude, compiled once: kerf_headers_once(TARGET <MORE
# HEADERS>) for the target, kerf_headers_of(TARGET OTHER) takes what was compiled for another one
# with the same flags. Sources include them all the same.
function(kerf_headers_once target)
  if(KERF_TOGETHER)
    target_precompile_headers(${target} PRIVATE <sstream> <unordered_map> <Eigen/Core>
                              <Eigen/Geometry> <spdlog/spdlog.h> <spdlog/fmt/fmt.h> ${ARGN})
  endif()
endfunction()

function(kerf_headers_of target other)
  if(KERF_TOGETHER)
    set_property(TARGET ${target} PROPERTY PRECOMPILE_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

# kerf_library(FOLDER <link arguments>): every .cpp below FOLDER becomes one library, named after it:
# kerf_gpu, kerf_sim_mesh.
function(kerf_library folder)
  string(REPLACE / _ name kerf_${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp
       ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER sources EXCLUDE REGEX main.cpp$)  # of programs
  if(folder STREQUAL app)
    list(FILTER sources EXCLUDE REGEX "/app/(files|import)/")  # libraries of their own
  endif()
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  kerf_own_code(${name})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/shaders)
  target_link_libraries(${name} ${ARGN})
endfunction()
