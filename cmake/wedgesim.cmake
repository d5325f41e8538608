# How every target of the house is compiled: one library a folder, warnings are errors.
add_library(wedgesim_options INTERFACE)
target_include_directories(wedgesim_options INTERFACE ${PROJECT_SOURCE_DIR})
# No fused multiply-add: a plane value must be the same bits in scalar and SIMD code.
target_compile_options(wedgesim_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off)
if(WEDGESIM_SANITIZE)
  target_compile_options(wedgesim_options INTERFACE
    -fsanitize=${WEDGESIM_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
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

# wedgesim_test(base/counter_test.cpp LABELS unit LINKS wedgesim::base [SECONDS 60])
# makes one test program of one file of tests/; each label answers one question (docs/testing.md).
function(wedgesim_test source)
  cmake_parse_arguments(ARG "" "SECONDS" "LABELS;LINKS" ${ARGN})
  if(NOT ARG_SECONDS)
    set(ARG_SECONDS 120)
  endif()
  string(REGEX REPLACE "\\.cpp$" "" target ${source})
  string(REPLACE "/" "." target ${target})
  add_executable(${target} ${PROJECT_SOURCE_DIR}/tests/${source})
  target_link_libraries(${target} PRIVATE wedgesim_options ${ARG_LINKS} GTest::gtest_main)
  target_compile_definitions(${target} PRIVATE
    WEDGESIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" WEDGESIM_BINARY_DIR="${PROJECT_BINARY_DIR}")
  add_test(NAME ${target} COMMAND ${target})
  set_tests_properties(${target} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${ARG_SECONDS})
endfunction()
