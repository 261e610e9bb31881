# What `cmake --install` puts where, and the Debian package that CPack makes (scripts/package).
include(GNUInstallDirs)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # tests are not installed, so nobody waits for them
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
    GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(KERF_CONTACT "Kerf maintainers <maintainers@kerf.invalid>" CACHE STRING
    "Name and address of who answers for the packages")

find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(sources ${PROJECT_SOURCE_DIR}/scripts/packaging)
set(made ${PROJECT_BINARY_DIR}/packaging)
file(MAKE_DIRECTORY ${made})

# What the program itself says is its manual page and its completion.
add_custom_command(
  OUTPUT ${made}/kerf.1.gz ${made}/kerf.bash
  COMMAND ${Python3_EXECUTABLE} -B ${sources}/make_pages.py $<TARGET_FILE:kerf> ${made}
  DEPENDS kerf ${sources}/make_pages.py VERBATIM)
add_custom_command(
  OUTPUT ${made}/kerf.svg
  COMMAND ${Python3_EXECUTABLE} -B ${sources}/make_icon.py ${made}/kerf.svg
  DEPENDS ${sources}/make_icon.py VERBATIM)
# Files that Debian asks for. The package is for the release that it is built on, which its version
# names: 0.1.0-1~debian12 is followed by 0.1.0-1~debian13 where that release is upgraded.
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(KERF_PACKAGE_RELEASE "1~${system_ID}${system_VERSION_ID}")
configure_file(${sources}/changelog.Debian.in ${made}/changelog.Debian @ONLY)
add_custom_command(
  OUTPUT ${made}/changelog.gz ${made}/changelog.Debian.gz
  COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${made}/changelog.gz
  COMMAND gzip -9nc ${made}/changelog.Debian > ${made}/changelog.Debian.gz
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${made}/changelog.Debian VERBATIM)
add_custom_target(kerf_package_files ALL
  DEPENDS ${made}/kerf.1.gz ${made}/kerf.bash ${made}/kerf.svg ${made}/changelog.gz)

install(TARGETS kerf RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS kerf-import RUNTIME DESTINATION libexec/kerf)  # Kerf alone starts it
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders ${PROJECT_SOURCE_DIR}/assets
        DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf
        PATTERN "*.py" EXCLUDE PATTERN "__pycache__" EXCLUDE PATTERN "README.md" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/docs/session.schema.json
              ${PROJECT_SOURCE_DIR}/docs/material.schema.json
        DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf/docs)
if(KERF_PYTHON)
  set(KERF_PYTHON_DIR lib/python3/dist-packages CACHE STRING
      "Where the Python module is installed, below the prefix")
  install(TARGETS kerf_python LIBRARY DESTINATION ${KERF_PYTHON_DIR}/kerf)
  install(FILES ${kerf_python_sources} DESTINATION ${KERF_PYTHON_DIR}/kerf)
endif()
install(FILES ${made}/kerf.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${made}/kerf.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME kerf)
install(FILES ${made}/kerf.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES ${sources}/kerf.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${sources}/kerf.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
install(FILES ${sources}/kerf.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${sources}/copyright ${made}/changelog.gz ${made}/changelog.Debian.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/kerf)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR Kerf)
set(CPACK_PACKAGE_CONTACT ${KERF_CONTACT})
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})
set(CPACK_PACKAGE_FILE_NAME
    kerf-${PROJECT_VERSION}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${KERF_PACKAGE_RELEASE})
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg")
if(KERF_PYTHON)
  set(CPACK_DEBIAN_PACKAGE_PROVIDES "python3-kerf")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3-numpy")
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")  # a module is for one minor version
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor})")
endif()
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "cut soft 3D models while they move")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Kerf is a desktop editor in which a blade is dragged through an ordinary
triangle mesh. The mesh opens while the blade moves, its pieces sag and
fall, and it is closed after every step. What was done is saved as a
session, a text file that is replayed without a display to the same bits.

It needs OpenGL 4.5, which Mesa also gives without a graphics card.")
include(CPack)
