# What ctest reads: each suite of the test program ${program} is one test, in a process of its own
# and labelled by the room of its file below ${sources}, such as sim/cut. The tests of a suite share
# a context of OpenGL and what the driver has compiled for it. The driver draws without threads of
# its own, which takes a tenth less: tests run side by side.

# The longest start first, so that none of them runs alone at the end: seconds on two quiet cores.
set(cost_of_EditorKill 40)  # it waits most of the time
set(cost_of_EditorWindowTest 40)
set(cost_of_TestVerb 30)
set(cost_of_SimulationTest 20)
set(cost_of_KeptSessions 20)
set(cost_of_OwnLooksTest 20)
set(cost_of_FormatCorners 10)
# What says most about a driver: .ci/run has these on zink, too (label "driver"). The solver runs once
# more by the way of kernels that GPUs take. By night so do contact and cutting, which KernelWays
# compares by day.
set(suites_for_drivers ProgramTest NumbersTableTest GpuSolverTest DoctorTest)
set(suites_both_ways GpuSolverTest)
if(DEFINED ENV{KERF_NIGHTLY})
  list(APPEND suites_for_drivers UnfoldingTest ContactSolverTest BoxContactTest KernelWays
       CutAtRestTest SimulationTest)
  list(APPEND suites_both_ways UnfoldingTest ContactSolverTest BoxContactTest CutAtRestTest)
endif()
if(NOT EXISTS ${program})
  get_filename_component(name ${program} NAME)
  add_test(${name}_NOT_BUILT ${name}_NOT_BUILT)
  return()
endif()

get_filename_component(tests ${sources} DIRECTORY)
file(GLOB_RECURSE files ${sources}/*_test.cpp)
foreach(file ${files})
  get_filename_component(room ${file} DIRECTORY)
  file(RELATIVE_PATH room ${tests} ${room})
  file(STRINGS ${file} heads REGEX "^ *TEST(_F|_P)?\\(")
  foreach(head ${heads})
    string(REGEX REPLACE "^[^(]*\\(([A-Za-z0-9_]+).*" "\\1" suite "${head}")
    set(room_of_${suite} ${room})
  endforeach()
endforeach()

execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE lines RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} could not list its tests: ${status}")
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." lines "${lines}")
# add_suite(NAME SUITE LABELS VARIABLES): one test of ctest.
function(add_suite name suite labels variables)
  # A window whose driver has no threads stands still under Xvfb.
  if(NOT labels MATCHES "app/window")
    set(variables "${variables};LP_NUM_THREADS=0")
  endif()
  add_test(${name} ${program} --gtest_filter=${suite}.*)
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 LABELS "${labels}"
                       ENVIRONMENT "LIBGL_ALWAYS_SOFTWARE=1;LC_ALL=C${variables}")
endfunction()

foreach(line ${lines})
  string(REGEX REPLACE "[\n.]" "" suite "${line}")
  string(REGEX REPLACE "^.*/" "" name "${suite}")  # of tests with parameters: All/PaperSessions
  set(labels "${room_of_${name}}")
  list(FIND suites_for_drivers "${name}" place)  # ctest knows no IN_LIST
  if(NOT place EQUAL -1)
    list(APPEND labels driver)
  endif()
  add_suite(${suite} ${suite} "${labels}" "")
  if(cost_of_${name})
    set_tests_properties(${suite} PROPERTIES COST ${cost_of_${name}})
  endif()
  list(FIND suites_both_ways "${name}" place)
  if(NOT place EQUAL -1)
    add_suite(${suite}ByTheWayOfGpus ${suite} "${room_of_${name}}" ";KERF_KERNELS=shared")
  endif()
endforeach()
