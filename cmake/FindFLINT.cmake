# SPDX-License-Identifier: BSD-3-Clause
#
# Finds FLINT with its ball arithmetic (Arb), in either of the two forms in which distributions ship it:
#   FLINT 3               one library; the headers of Arb are <flint/arb.h>, ...
#   FLINT 2.9 + Arb 2.23  two libraries, flint and arb (called flint-arb by Debian); the headers of Arb are <arb.h>, ...
#
#   FLINT::FLINT       target; links Arb, MPFR and GMP
#   FLINT_VERSION      version of FLINT
#   FLINT_ARB_VERSION  version of Arb; that of FLINT when Arb is part of it
#
# The smallest versions accepted are 2.9 of FLINT and 2.23 of Arb. Another prefix is given by CMAKE_PREFIX_PATH or
# FLINT_ROOT.
include(FindPackageHandleStandardArgs)
include(CMakeFindDependencyMacro)
find_dependency(MPFR)

find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
set(FLINT_REQUIRED_VARIABLES FLINT_LIBRARY FLINT_INCLUDE_DIR)
unset(FLINT_VERSION)
unset(FLINT_ARB_VERSION)
unset(FLINT_REASON)

if(FLINT_INCLUDE_DIR)
  # FLINT 2 and 3: #define FLINT_VERSION "2.9.0"
  file(STRINGS "${FLINT_INCLUDE_DIR}/flint/flint.h" FLINT_VERSION_LINE REGEX "^#define[ \t]+FLINT_VERSION[ \t]+\"")
  if(FLINT_VERSION_LINE MATCHES "\"([0-9.]+)[^\"]*\"")
    set(FLINT_VERSION "${CMAKE_MATCH_1}")
  endif()
  unset(FLINT_VERSION_LINE)

  if(FLINT_VERSION AND FLINT_VERSION VERSION_LESS 2.9)
    string(APPEND FLINT_REASON "FLINT ${FLINT_VERSION} is too old, 2.9 is needed. ")
    set(FLINT_ACCEPTED FALSE)
    list(APPEND FLINT_REQUIRED_VARIABLES FLINT_ACCEPTED)
  endif()

  if(EXISTS "${FLINT_INCLUDE_DIR}/flint/arb.h")
    set(FLINT_ARB_VERSION "${FLINT_VERSION}")
  else()
    find_path(FLINT_ARB_INCLUDE_DIR arb.h)
    find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
    mark_as_advanced(FLINT_ARB_INCLUDE_DIR FLINT_ARB_LIBRARY)
    list(APPEND FLINT_REQUIRED_VARIABLES FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
    if(FLINT_ARB_INCLUDE_DIR)
      file(STRINGS "${FLINT_ARB_INCLUDE_DIR}/arb.h" FLINT_VERSION_LINE REGEX "^#define[ \t]+ARB_VERSION[ \t]+\"")
      if(FLINT_VERSION_LINE MATCHES "\"([0-9.]+)[^\"]*\"")
        set(FLINT_ARB_VERSION "${CMAKE_MATCH_1}")
      endif()
      unset(FLINT_VERSION_LINE)
      if(FLINT_ARB_VERSION AND FLINT_ARB_VERSION VERSION_LESS 2.23)
        string(APPEND FLINT_REASON "Arb ${FLINT_ARB_VERSION} is too old, 2.23 is needed. ")
        set(FLINT_ACCEPTED FALSE)
        list(APPEND FLINT_REQUIRED_VARIABLES FLINT_ACCEPTED)
      endif()
    else()
      string(APPEND FLINT_REASON "FLINT ${FLINT_VERSION} does not contain Arb; install Arb 2.23 beside it "
                                 "(libflint-arb-dev on Debian 12), or FLINT 3. ")
    endif()
  endif()
endif()

find_package_handle_standard_args(FLINT
  REQUIRED_VARS ${FLINT_REQUIRED_VARIABLES}
  VERSION_VAR FLINT_VERSION
  REASON_FAILURE_MESSAGE "${FLINT_REASON}")
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT UNKNOWN IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES
    IMPORTED_LOCATION "${FLINT_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES MPFR::MPFR)
  if(FLINT_ARB_LIBRARY)
    add_library(FLINT::Arb UNKNOWN IMPORTED)
    set_target_properties(FLINT::Arb PROPERTIES
      IMPORTED_LOCATION "${FLINT_ARB_LIBRARY}"
      INTERFACE_INCLUDE_DIRECTORIES "${FLINT_ARB_INCLUDE_DIR}"
      INTERFACE_LINK_LIBRARIES FLINT::FLINT)
    # Both ways round: a user of FLINT::FLINT gets Arb, and a static Arb is followed by the FLINT it needs.
    set_property(TARGET FLINT::FLINT APPEND PROPERTY INTERFACE_LINK_LIBRARIES FLINT::Arb)
  endif()
endif()
