# Tests that are no programs of this build: how the sources are written, the unit tests again under
# the sanitizers, a minute of fuzzing. From an optimized build only; docs/testing.md has the labels.
if(WEDGESIM_SANITIZE OR WEDGESIM_FUZZ OR NOT CMAKE_BUILD_TYPE STREQUAL "Release")
  return()
endif()

add_test(NAME style.format
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
          -P ${PROJECT_SOURCE_DIR}/tests/format_check.cmake)
add_test(NAME style.house
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}
          -P ${PROJECT_SOURCE_DIR}/tests/house_check.cmake)
add_test(NAME style.scripts WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMAND shellcheck -x run test .ci/run .ci/setup.sh)
set_tests_properties(style.format style.house style.scripts PROPERTIES LABELS style TIMEOUT 120)

wedgesim_nested_build(sanitize.build asan sanitized_tests)
add_test(NAME sanitize.unit WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMAND ${CMAKE_CTEST_COMMAND} --preset asan -L ^sanitized$ --no-tests=error)
set_tests_properties(sanitize.build sanitize.unit PROPERTIES LABELS sanitize)
set_tests_properties(sanitize.unit PROPERTIES FIXTURES_REQUIRED sanitize.build TIMEOUT 1800)

# The fuzzer keeps the inputs that reached new code between runs, beside those it starts from.
set(fuzz_folder ${PROJECT_SOURCE_DIR}/build/fuzz/tests/traces)
wedgesim_nested_build(fuzz.build fuzz trace_fuzz)
add_test(NAME fuzz.trace WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMAND sh -c
  "cd ${fuzz_folder} && mkdir -p found && ./trace_fuzz -max_total_time=60 -timeout=10 \
     -rss_limit_mb=2048 -verbosity=0 -print_final_stats=1 found trace_corpus")
set_tests_properties(fuzz.trace PROPERTIES LABELS fuzz FIXTURES_REQUIRED fuzz.build TIMEOUT 180)
