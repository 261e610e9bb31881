# The Python module: import kerf. It is for the system's own interpreter, whatever stands first in
# PATH; another one is named by -DPython_EXECUTABLE=FILE.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "The Python that imports kerf")
endif()
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
set(PYBIND11_FINDPYTHON ON)
find_package(pybind11 CONFIG)
if(NOT pybind11_FOUND)
  message(FATAL_ERROR "pybind11 is not there: install pybind11-dev, or build without the Python "
                      "module by -DKERF_PYTHON=OFF.")
endif()

set(kerf_python_folder ${PROJECT_BINARY_DIR}/python/kerf)
file(GLOB native_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/*.cpp
     ${PROJECT_SOURCE_DIR}/python/*.h)
pybind11_add_module(kerf_python MODULE NO_EXTRAS ${native_sources})
kerf_own_code(kerf_python)
kerf_lightly_optimised(kerf_python)
target_compile_definitions(kerf_python PRIVATE KERF_VERSION="${PROJECT_VERSION}")
target_link_libraries(kerf_python PRIVATE kerf_app nlohmann_json::nlohmann_json)
# Nothing else of it is seen by other modules, which may have libraries of the same names in them.
target_link_options(kerf_python PRIVATE -Wl,--exclude-libs,ALL)
set_target_properties(kerf_python PROPERTIES OUTPUT_NAME _native
                      LIBRARY_OUTPUT_DIRECTORY ${kerf_python_folder})
add_dependencies(kerf_python kerf)  # reads the models

# The part that is written in Python lies beside it, so that PYTHONPATH=build/python is all it takes.
file(MAKE_DIRECTORY ${kerf_python_folder})
file(GLOB kerf_python_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/kerf/*.py
     ${PROJECT_SOURCE_DIR}/python/kerf/*.pyi ${PROJECT_SOURCE_DIR}/python/kerf/py.typed)
foreach(source ${kerf_python_sources})
  get_filename_component(name ${source} NAME)
  file(CREATE_LINK ${source} ${kerf_python_folder}/${name} SYMBOLIC)
endforeach()

# The laboratory: `kerf experiment` starts it. Nothing that is installed needs it.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/kerf-lab @ONLY CONTENT [[
#!@Python_EXECUTABLE@ -B
import sys
sys.path[:0] = ["@PROJECT_BINARY_DIR@/python", "@PROJECT_SOURCE_DIR@/bench"]
from lab.start import main
sys.exit(main())
]])
file(CHMOD ${PROJECT_BINARY_DIR}/kerf-lab PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
     GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
