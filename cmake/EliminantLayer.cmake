# SPDX-License-Identifier: BSD-3-Clause
#
# A layer is a folder and a target eliminant_<layer>. The target sees its own headers and those of the layers it links,
# and no others: its include root is a folder of the build tree that holds nothing but eliminant/<layer>, a link to the
# source folder. An include that goes against the order of the layers fails to compile.
include(GNUInstallDirs)

# The include root of a layer.
function(eliminant_layer_root layer result)
  set(root "${PROJECT_BINARY_DIR}/layers/${layer}")
  file(MAKE_DIRECTORY "${root}/eliminant")
  if(NOT EXISTS "${root}/eliminant/${layer}")
    file(CREATE_LINK "${PROJECT_SOURCE_DIR}/${layer}" "${root}/eliminant/${layer}" SYMBOLIC)
  endif()
  set(${result} "${root}" PARENT_SCOPE)
endfunction()

# Flags of our own code, never of our users.
function(eliminant_own_flags target)
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wpedantic;-Wconversion>)
  # GCC 12 and older warn of an overlap inside std::string's operator+ that cannot happen (GCC bug 105651).
  target_compile_options(${target} PRIVATE
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
  if(ELIMINANT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Werror>)
  endif()
  if(ELIMINANT_NATIVE)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-march=native>)
  endif()
endfunction()

# eliminant_layer(<layer> [IEEE] [LINK <target>...] [LINK_PRIVATE <target>...])
#   IEEE          no contraction of floating-point operations, here and wherever the headers of the layer are compiled:
#                 the error bounds count every rounding
#   LINK          what the headers of the layer include
#   LINK_PRIVATE  what only its sources include
function(eliminant_layer layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "IEEE" "" "LINK;LINK_PRIVATE")
  set(target eliminant_${layer})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${layer}/*.cpp")
  if(sources)
    list(SORT sources)
    add_library(${target} ${sources})
    set_target_properties(${target} PROPERTIES
      POSITION_INDEPENDENT_CODE ON
      VERSION ${PROJECT_VERSION}
      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE ${arg_LINK_PRIVATE})
    eliminant_own_flags(${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
    target_link_libraries(${target} INTERFACE ${arg_LINK_PRIVATE})
  endif()
  add_library(eliminant::${layer} ALIAS ${target})
  eliminant_layer_root(${layer} root)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} ${scope} cxx_std_20)
  target_link_libraries(${target} ${scope} ${arg_LINK})
  if(arg_IEEE)
    target_compile_options(${target} ${scope} $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${layer})
  install(TARGETS ${target} EXPORT eliminantTargets)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${layer}")
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/${layer}/"
      DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/eliminant/${layer}"
      FILES_MATCHING PATTERN "*.hpp" PATTERN eliminant.hpp EXCLUDE)
  endif()
endfunction()
