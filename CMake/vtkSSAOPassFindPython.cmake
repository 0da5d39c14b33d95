# SPDX-License-Identifier: BSD-3-Clause
#[==[
Included before the module is built, which writes what the wrapping reads if VTK's tools are there.

Sets SSAO_WRAPS_PYTHON, and SSAO_PYTHON to the interpreter whose VTK is the one the module is built
with. Where there are several interpreters, -D Python3_EXECUTABLE=... names one.
#]==]
set(SSAO_WRAPS_PYTHON OFF)
if (NOT BUILD_SHARED_LIBS)
  message(STATUS "Python module: off, it needs BUILD_SHARED_LIBS")
  return ()
elseif (CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  message(STATUS "Python module: off, the interpreter has no sanitizer")
  return ()
endif ()

# The first python3 of the path may not be the one that VTK was wrapped for.
set(SSAO_PYTHON)
find_program(SSAO_PYTHON_OF_PATH python3)
mark_as_advanced(SSAO_PYTHON_OF_PATH)
foreach (python IN ITEMS "${Python3_EXECUTABLE}" "${SSAO_PYTHON_OF_PATH}" /usr/bin/python3)
  if (NOT SSAO_PYTHON AND EXISTS "${python}")
    execute_process(
      COMMAND "${python}" -c "from vtkmodules.vtkCommonCore import vtkVersion as v; \
print(v.GetVTKMajorVersion(), v.GetVTKMinorVersion(), sep='.')"
      OUTPUT_VARIABLE python_vtk OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if (python_vtk STREQUAL "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
      set(SSAO_PYTHON "${python}")
    endif ()
  endif ()
endforeach ()
if (NOT SSAO_PYTHON)
  message(STATUS "Python module: off, no python3 with VTK ${VTK_VERSION} was found "
    "(Debian and Ubuntu: python3-vtk9)")
  return ()
endif ()

# VTK looks for Python3 too, and has to find the same.
set(Python3_EXECUTABLE "${SSAO_PYTHON}")
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module)
if (NOT Python3_Development.Module_FOUND)
  message(STATUS "Python module: off, the headers of ${SSAO_PYTHON} were not found "
    "(Debian and Ubuntu: libpython3-dev)")
  return ()
endif ()
find_package(VTK ${VTK_VERSION} EXACT QUIET
  OPTIONAL_COMPONENTS Python WrappingPythonCore WrappingTools)
foreach (target IN ITEMS Python WrappingPythonCore WrapHierarchy WrapPython)
  if (NOT TARGET VTK::${target})
    message(STATUS "Python module: off, this VTK has no VTK::${target}")
    return ()
  endif ()
endforeach ()
message(STATUS "Python module: for ${SSAO_PYTHON}, Python ${Python3_VERSION}")
set(SSAO_WRAPS_PYTHON ON)
