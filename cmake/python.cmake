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

# kerf_python_module(TARGET INTERPRETER): the compiled module, for that version of Python alone.
function(kerf_python_module target interpreter)
  execute_process(
    COMMAND ${interpreter} -c "from sysconfig import get_path, get_config_var as variable
print(get_path('include'), variable('EXT_SUFFIX'), sep=';', end='')"
    OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY)
  list(POP_FRONT found headers suffix)
  if(NOT EXISTS ${headers}/Python.h)
    message(FATAL_ERROR "${headers}/Python.h is not there: install python3-dev, or what has the "
                        "headers of ${interpreter}.")
  endif()
  add_library(${target} MODULE ${native_sources})
  kerf_own_code(${target})
  kerf_lightly_optimised(${target})
  target_include_directories(${target} SYSTEM PRIVATE ${headers})
  target_compile_definitions(${target} PRIVATE KERF_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${target} PRIVATE kerf_app nlohmann_json::nlohmann_json pybind11::headers)
  # Nothing else of it is seen by other modules, which may have libraries of the same names in them.
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME _native PREFIX "" SUFFIX ${suffix}
                        CXX_VISIBILITY_PRESET hidden LIBRARY_OUTPUT_DIRECTORY ${kerf_python_folder})
  add_dependencies(${target} kerf)  # reads the models
endfunction()

kerf_python_module(kerf_python ${Python_EXECUTABLE})
# Those of the wheel for further Pythons (scripts/package), which no other target builds.
set(KERF_MORE_PYTHONS "" CACHE STRING "Further interpreters, to be built by kerf_more_pythons")
add_custom_target(kerf_more_pythons)
foreach(interpreter IN LISTS KERF_MORE_PYTHONS)
  cmake_path(GET interpreter FILENAME name)
  kerf_python_module(kerf_${name} ${interpreter})
  set_target_properties(kerf_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(kerf_more_pythons kerf_${name})
endforeach()

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
