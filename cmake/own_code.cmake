# Flags for code that is ours: warnings are errors, and floating-point contraction is off because
# fused multiply-adds would change signs in the predicates that decide topology.
function(kerf_own_code target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         -Wno-sign-conversion -Wno-float-conversion -ffp-contract=off)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)  # GCC bug 105651: "text" + string
  endif()
  if(KERF_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(KERF_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                           -fno-omit-frame-pointer
                           -Wno-maybe-uninitialized)  # misfires on instrumented standard headers
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()

# kerf_library(FOLDER <link arguments>): every .cpp below FOLDER becomes one library, named after it:
# kerf_gpu, kerf_sim_mesh.
function(kerf_library folder)
  string(REPLACE / _ name kerf_${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp
       ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  list(FILTER sources EXCLUDE REGEX main.cpp$)  # of programs
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  kerf_own_code(${name})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/shaders)
  target_link_libraries(${name} ${ARGN})
endfunction()
