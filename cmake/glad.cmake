# The OpenGL loader is generated at build time, offline, by Debian's python3-glad.
find_program(GLAD_GENERATOR glad REQUIRED PATHS /usr/bin NO_DEFAULT_PATH)
set(glad_dir ${CMAKE_BINARY_DIR}/generated/glad)
add_custom_command(
  OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
  COMMAND ${GLAD_GENERATOR} --quiet --reproducible --api gl:core=4.5 --out-path ${glad_dir} c --loader
  COMMENT "Generating the OpenGL 4.5 core loader"
  VERBATIM)
add_library(kerf_glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h)
target_include_directories(kerf_glad SYSTEM PUBLIC ${glad_dir}/include)
target_link_libraries(kerf_glad PUBLIC ${CMAKE_DL_LIBS})
