# SPDX-FileCopyrightText: 2026 The Girdle authors
# SPDX-License-Identifier: Apache-2.0
#
# Finds the MuJoCo C library and makes the imported target mujoco::mujoco.
#
# It takes the first of these that holds the version asked for:
#   root      the folder in MUJOCO_ROOT (CMake variable, else environment). It
#             may be an unpacked release (include/, lib/libmujoco.so*), the
#             `mujoco` folder of the Python wheel (include/, libmujoco.so.X.Y.Z)
#             or a folder that holds such a `mujoco` folder. If it is set,
#             nothing else is looked at: what it names is used or is an error.
#   package   the CMake package of an installed release
#   fetched   build/engine, where scripts/setup puts it; of several the newest
#   python    the `mujoco` of the python3 on PATH
#
# It sets MuJoCo_FOUND, MuJoCo_VERSION, MuJoCo_INCLUDE_DIR, MuJoCo_LIBRARY and
# MuJoCo_SOURCE (one of the four words above). None of them is cached: looking
# is cheap, and a cached answer would outlive the library it names.

include(FindPackageHandleStandardArgs)

# Looks for a MuJoCo in `folder` and `folder`/mujoco. Sets in the caller
# MuJoCo_INCLUDE_DIR, MuJoCo_LIBRARY and MuJoCo_VERSION, or, when there is none,
# only _mujoco_reason.
function(_mujoco_look_in folder)
  set(_mujoco_reason "${folder} has no include/mujoco/mujoco.h" PARENT_SCOPE)
  foreach(base IN ITEMS "${folder}" "${folder}/mujoco")
    set(header "${base}/include/mujoco/mujoco.h")
    if(NOT EXISTS "${header}")
      continue()
    endif()

    # 4000001 is 4.0.1. Releases before 4 wrote 337 for 3.3.7.
    file(STRINGS "${header}" line REGEX "^#define mjVERSION_HEADER +[0-9]+" LIMIT_COUNT 1)
    string(REGEX REPLACE "^#define mjVERSION_HEADER +([0-9]+).*" "\\1" number "${line}")
    if(NOT number MATCHES "^[0-9]+$")
      set(_mujoco_reason "${header} does not say which version it is" PARENT_SCOPE)
      continue()
    endif()
    if(number LESS 1000)
      math(EXPR major "${number} / 100")
      math(EXPR minor "${number} / 10 % 10")
      math(EXPR patch "${number} % 10")
    else()
      math(EXPR major "${number} / 1000000")
      math(EXPR minor "${number} / 1000 % 1000")
      math(EXPR patch "${number} % 1000")
    endif()
    set(version "${major}.${minor}.${patch}")

    # The name with the version first: the plain one is a link to some version,
    # or a copy of it.
    set(name "libmujoco.so.${version}")
    foreach(file IN ITEMS "lib/${name}" "${name}" "lib/libmujoco.so" "libmujoco.so")
      if(NOT EXISTS "${base}/${file}")
        continue()
      endif()
      file(REAL_PATH "${base}/${file}" library)
      cmake_path(GET library FILENAME real_name)
      if(NOT real_name STREQUAL name AND NOT real_name STREQUAL "libmujoco.so")
        set(_mujoco_reason
            "${base} has the headers of MuJoCo ${version}, but its library is ${real_name}"
            PARENT_SCOPE)
        continue()
      endif()
      set(MuJoCo_INCLUDE_DIR "${base}/include" PARENT_SCOPE)
      set(MuJoCo_LIBRARY "${library}" PARENT_SCOPE)
      set(MuJoCo_VERSION "${version}" PARENT_SCOPE)
      set(_mujoco_reason "" PARENT_SCOPE)
      return()
    endforeach()
    if(NOT DEFINED real_name)
      set(_mujoco_reason
          "${base} has the headers of MuJoCo ${version}, but neither lib/${name} nor ${name}"
          PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Unsets the three result variables again if their version is not the one
# asked for, so that the next source gets its chance.
macro(_mujoco_drop_wrong_version)
  if(MuJoCo_LIBRARY)
    find_package_check_version("${MuJoCo_VERSION}" _mujoco_suits HANDLE_VERSION_RANGE)
    if(NOT _mujoco_suits)
      string(APPEND _mujoco_passed_over "\n      MuJoCo ${MuJoCo_VERSION} in ${MuJoCo_LIBRARY}")
      unset(MuJoCo_INCLUDE_DIR)
      unset(MuJoCo_LIBRARY)
      unset(MuJoCo_VERSION)
    endif()
  endif()
endmacro()

unset(MuJoCo_INCLUDE_DIR)
unset(MuJoCo_LIBRARY)
unset(MuJoCo_VERSION)
unset(MuJoCo_SOURCE)
set(_mujoco_reason "")
set(_mujoco_passed_over "")

set(_mujoco_root "${MUJOCO_ROOT}")
set(_mujoco_root_is "the CMake variable MUJOCO_ROOT")
if(_mujoco_root STREQUAL "")
  set(_mujoco_root "$ENV{MUJOCO_ROOT}")
  set(_mujoco_root_is "the environment variable MUJOCO_ROOT")
endif()

if(NOT _mujoco_root STREQUAL "")
  set(MuJoCo_SOURCE root)
  cmake_path(ABSOLUTE_PATH _mujoco_root BASE_DIRECTORY "${CMAKE_SOURCE_DIR}" NORMALIZE)
  _mujoco_look_in("${_mujoco_root}")
  if(NOT MuJoCo_LIBRARY)
    set(_mujoco_reason "${_mujoco_root_is} is set, but ${_mujoco_reason}.\n    \
Set it to the folder of an unpacked MuJoCo release (with include/ and lib/) or \
to a wheel's mujoco folder, or unset it and run scripts/setup.")
  else()
    set(_mujoco_reason "It is the one that ${_mujoco_root_is} names.")
  endif()
else()
  # A call before this one may have made the target already, from any source.
  if(NOT TARGET mujoco::mujoco)
    set(_mujoco_exact "")
    if(MuJoCo_FIND_VERSION_EXACT)
      set(_mujoco_exact EXACT)
    endif()
    # MuJoCo_FIND_VERSION_COMPLETE may be a range, and is empty if none was asked for.
    find_package(mujoco ${MuJoCo_FIND_VERSION_COMPLETE} ${_mujoco_exact} CONFIG QUIET)
    mark_as_advanced(mujoco_DIR)
  endif()
  if(mujoco_FOUND)
    get_target_property(MuJoCo_INCLUDE_DIR mujoco::mujoco INTERFACE_INCLUDE_DIRECTORIES)
    get_target_property(MuJoCo_LIBRARY mujoco::mujoco LOCATION)
    set(MuJoCo_VERSION "${mujoco_VERSION}")
    set(MuJoCo_SOURCE package)
  else()
    foreach(_mujoco_other IN ZIP_LISTS mujoco_CONSIDERED_VERSIONS mujoco_CONSIDERED_CONFIGS)
      string(APPEND _mujoco_passed_over
             "\n      MuJoCo ${_mujoco_other_0} in ${_mujoco_other_1}")
    endforeach()
  endif()

  if(NOT MuJoCo_LIBRARY AND NOT mujoco_FOUND)
    # Since 4 the wheel with the library is called mujoco-core.
    file(GLOB _mujoco_folders LIST_DIRECTORIES TRUE
         "${PROJECT_SOURCE_DIR}/build/engine/mujoco-core-*")
    file(GLOB _mujoco_older_folders LIST_DIRECTORIES TRUE
         "${PROJECT_SOURCE_DIR}/build/engine/mujoco-[0-9]*")
    list(SORT _mujoco_folders COMPARE NATURAL ORDER DESCENDING)
    list(SORT _mujoco_older_folders COMPARE NATURAL ORDER DESCENDING)
    list(APPEND _mujoco_folders ${_mujoco_older_folders})
    foreach(_mujoco_folder IN LISTS _mujoco_folders)
      _mujoco_look_in("${_mujoco_folder}")
      _mujoco_drop_wrong_version()
      if(MuJoCo_LIBRARY)
        set(MuJoCo_SOURCE fetched)
        break()
      endif()
    endforeach()
  endif()

  if(NOT MuJoCo_LIBRARY AND NOT mujoco_FOUND)
    # The package is not imported, only asked for: importing it takes a second
    # and loads the library. The empty entry of the path is the current folder,
    # where a `mujoco` is not Python's own.
    execute_process(
      COMMAND python3 -c "import importlib.util, sys
sys.path = [entry for entry in sys.path if entry]
spec = importlib.util.find_spec('mujoco')
print(list(spec.submodule_search_locations)[0] if spec else '', end='')"
      OUTPUT_VARIABLE _mujoco_folder ERROR_QUIET RESULT_VARIABLE _mujoco_status)
    if(_mujoco_status STREQUAL "0" AND NOT _mujoco_folder STREQUAL "")
      _mujoco_look_in("${_mujoco_folder}")
      _mujoco_drop_wrong_version()
      if(MuJoCo_LIBRARY)
        set(MuJoCo_SOURCE python)
      endif()
    endif()
  endif()

  if(NOT MuJoCo_LIBRARY AND NOT mujoco_FOUND)
    set(_mujoco_reason "Run scripts/setup, which fetches it into build/engine, \
or set MUJOCO_ROOT to the folder of an unpacked MuJoCo release.")
    if(NOT _mujoco_passed_over STREQUAL "")
      string(APPEND _mujoco_reason "\n    Found, but of a version that does not fit:${_mujoco_passed_over}")
    endif()
  endif()
endif()

find_package_handle_standard_args(MuJoCo
  REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR
  VERSION_VAR MuJoCo_VERSION
  HANDLE_VERSION_RANGE
  REASON_FAILURE_MESSAGE "${_mujoco_reason}")

if(MuJoCo_FOUND AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES
    IMPORTED_LOCATION "${MuJoCo_LIBRARY}"
    IMPORTED_SONAME "libmujoco.so.${MuJoCo_VERSION}"
    INTERFACE_INCLUDE_DIRECTORIES "${MuJoCo_INCLUDE_DIR}")
endif()
if(NOT MuJoCo_FOUND)
  unset(MuJoCo_SOURCE)
endif()
