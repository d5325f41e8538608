# How every target of the house is compiled: one library a folder, warnings are errors.
add_library(wedgesim_options INTERFACE)
target_include_directories(wedgesim_options INTERFACE ${PROJECT_SOURCE_DIR})
# No fused multiply-add: a plane value must be the same bits in scalar and SIMD code.
target_compile_options(wedgesim_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off)
if(WEDGESIM_SANITIZE)
  target_compile_options(wedgesim_options INTERFACE
    -fsanitize=${WEDGESIM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Under instrumentation g++ 12 takes std::regex's own members for uninitialized.
    target_compile_options(wedgesim_options INTERFACE -Wno-maybe-uninitialized)
  endif()
  if(WEDGESIM_SANITIZE MATCHES undefined AND NOT WEDGESIM_FUZZ)
    # A third of the build's time: a null pointer ends in a report anyway, and alignment matters
    # where files are mapped, which is what the fuzzer reads.
    target_compile_options(wedgesim_options INTERFACE -fno-sanitize=null,alignment,vptr)
  endif()
  target_link_options(wedgesim_options INTERFACE -fsanitize=${WEDGESIM_SANITIZE})
endif()
find_program(MOLD mold)
if(MOLD)
  target_link_options(wedgesim_options INTERFACE -fuse-ld=mold)
endif()

# wedgesim_library(functional_scene SOURCES a.cpp b.cpp LINKS base glm::glm PRIVATE_LINKS assimp::assimp)
# makes the target wedgesim_functional_scene, known as wedgesim::functional_scene.
function(wedgesim_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(wedgesim_${name} STATIC ${ARG_SOURCES})
  add_library(wedgesim::${name} ALIAS wedgesim_${name})
  target_link_libraries(wedgesim_${name} PUBLIC wedgesim_options ${ARG_LINKS}
                        PRIVATE ${ARG_PRIVATE_LINKS})
endfunction()

# wedgesim_embed(out.cpp "a.toml;b.toml" HEADER x.h SPACE wedgesim::x TYPE File FUNCTION files)
# writes out.cpp, in which x::files() gives the files' stems and texts as a span of x::File.
function(wedgesim_embed output files)
  cmake_parse_arguments(ARG "" "HEADER;SPACE;TYPE;FUNCTION" "" ${ARGN})
  list(JOIN files "," list)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFILES=${list} -DHEADER=${ARG_HEADER} -DSPACE=${ARG_SPACE}
            -DTYPE=${ARG_TYPE} -DFUNCTION=${ARG_FUNCTION} -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    VERBATIM)
endfunction()

# The programs that ./test runs under the sanitizers: the unit tests of what reads traces, handles
# memory and computes in fixed point. All others, whose build is four times as long, run under them
# with ./test --sanitize.
add_custom_target(sanitized_tests)

# wedgesim_test(base/counter_test.cpp LABELS unit LINKS wedgesim::base [SECONDS 60])
# makes one test program of one file of tests/; each label answers one question (docs/testing.md).
# SECONDS is the time limit of an optimized build; slower builds get more.
function(wedgesim_test source)
  cmake_parse_arguments(ARG "" "SECONDS" "LABELS;LINKS" ${ARGN})
  if(NOT ARG_SECONDS)
    set(ARG_SECONDS 120)
  endif()
  if(WEDGESIM_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug")
    math(EXPR ARG_SECONDS "10 * ${ARG_SECONDS}")
  endif()
  string(REGEX REPLACE "\\.cpp$" "" target ${source})
  string(REPLACE "/" "." target ${target})
  add_executable(${target} ${PROJECT_SOURCE_DIR}/tests/${source})
  target_link_libraries(${target} PRIVATE wedgesim_test_options ${ARG_LINKS} GTest::gtest_main)
  target_precompile_headers(${target} REUSE_FROM wedgesim_test_headers)
  target_compile_definitions(${target} PRIVATE
    WEDGESIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" WEDGESIM_BINARY_DIR="${PROJECT_BINARY_DIR}")
  add_test(NAME ${target} COMMAND ${target})
  if("unit" IN_LIST ARG_LABELS AND source MATCHES "^(base|traces|model/datapath)/")
    list(APPEND ARG_LABELS sanitized)
    add_dependencies(sanitized_tests ${target})
  endif()
  set_tests_properties(${target} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_SECONDS})
endfunction()

# A test that configures another preset and builds one target there; named as a fixture, it runs
# before the tests that require it, and takes all processors.
function(wedgesim_nested_build name preset target)
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  add_test(NAME ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} COMMAND sh -c
    "${CMAKE_COMMAND} --preset ${preset} && ${CMAKE_COMMAND} --build --preset ${preset} --target ${target}")
  set_tests_properties(${name} PROPERTIES
    FIXTURES_SETUP ${name} PROCESSORS ${processors} TIMEOUT 1800 LABELS ${preset})
endfunction()
