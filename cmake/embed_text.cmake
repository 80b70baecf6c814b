# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0

# As a script (cmake -P), writes a C++ source whose functions return the texts of files:
#   -DOUTPUT=x.cpp -DHEADER=declares/them.hpp "-DFUNCTIONS=a=first.html;b=one.js,two.js" -DFOLDER=dir
# A function of several files returns them one after the other.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  set(source "// Written by cmake/embed_text.cmake.\n#include \"${HEADER}\"\n\nnamespace setsquare {\n")
  foreach(function IN LISTS FUNCTIONS)
    string(REGEX MATCH "^([^=]+)=(.*)$" function "${function}")
    set(name "${CMAKE_MATCH_1}")
    string(REPLACE "," ";" files "${CMAKE_MATCH_2}")
    string(APPEND source "\nstd::string ${name}() {\n  std::string text;\n")
    foreach(file IN LISTS files)
      file(READ "${FOLDER}/${file}" text)
      string(APPEND source "  text += R\"__text__(${text})__text__\";\n")
    endforeach()
    string(APPEND source "  return text;\n}\n")
  endforeach()
  file(WRITE "${OUTPUT}" "${source}\n}  // namespace setsquare\n")
  return()
endif()

set(setsquare_embed_text_script "${CMAKE_CURRENT_LIST_FILE}")

# setsquare_embed_text(OUTPUT HEADER FOLDER FUNCTIONS name=file,file ...)
# Has OUTPUT written as above, again whenever one of the files changes.
function(setsquare_embed_text output header folder)
  cmake_parse_arguments(arg "" "" "FUNCTIONS" ${ARGN})
  string(REGEX REPLACE "[^;=]*=" "" files "${arg_FUNCTIONS}")
  string(REPLACE "," ";" files "${files}")
  list(TRANSFORM files PREPEND "${folder}/")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DHEADER=${header}" "-DFOLDER=${folder}"
            "-DFUNCTIONS=${arg_FUNCTIONS}" -P "${setsquare_embed_text_script}"
    DEPENDS ${files} "${setsquare_embed_text_script}"
    COMMENT "Embedding ${header}"
    VERBATIM)
endfunction()
