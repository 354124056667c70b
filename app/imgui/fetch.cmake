# Finds Dear ImGui's sources and sets SNUG_IMGUI_DIR: the user's own, else the copy in .cache,
# else upstream's archive, else Debian's source package. imgui.sha256 pins each file that is
# compiled, so it does not matter which of these they came from.
set(imgui_version 1.92.2b)
set(SNUG_IMGUI_DIR "" CACHE PATH "Dear ImGui ${imgui_version}'s sources, if you have them")
if(SNUG_IMGUI_DIR)
  return()
endif()

# snug_imgui_pinned(FOLDER OUT): whether FOLDER holds just the files that we pinned.
function(snug_imgui_pinned folder out)
  file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/imgui.sha256 lines)
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^([0-9a-f]+)  (.+)$" unused "${line}")
    set(hash "none")
    if(EXISTS ${folder}/${CMAKE_MATCH_2})
      file(SHA256 ${folder}/${CMAKE_MATCH_2} hash)
    endif()
    if(NOT hash STREQUAL CMAKE_MATCH_1)
      set(${out} FALSE PARENT_SCOPE)
      return()
    endif()
  endforeach()
  set(${out} TRUE PARENT_SCOPE)
endfunction()

set(cache ${PROJECT_SOURCE_DIR}/.cache)
set(SNUG_IMGUI_DIR ${cache}/imgui-${imgui_version})
file(MAKE_DIRECTORY ${cache})
file(LOCK ${cache}/imgui.lock GUARD FILE TIMEOUT 300) # two presets may configure at once
snug_imgui_pinned(${SNUG_IMGUI_DIR} pinned)

if(NOT pinned)
  message(STATUS "Fetching Dear ImGui ${imgui_version}")
  set(archive ${cache}/imgui.tar)
  file(DOWNLOAD https://github.com/ocornut/imgui/archive/refs/tags/v${imgui_version}.tar.gz
    ${archive} TIMEOUT 60 INACTIVITY_TIMEOUT 8 STATUS status)
  list(GET status 0 failed)
  if(NOT failed)
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${cache})
    snug_imgui_pinned(${SNUG_IMGUI_DIR} pinned)
  endif()
endif()
if(NOT pinned)
  message(STATUS "Upstream cannot be reached from here: trying Debian's source package")
  execute_process(COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/fetch_debian.sh
    ${imgui_version} ${cache}/imgui-debian ${archive} RESULT_VARIABLE failed)
  if(NOT failed)
    file(ARCHIVE_EXTRACT INPUT ${archive} DESTINATION ${cache})
    snug_imgui_pinned(${SNUG_IMGUI_DIR} pinned)
  endif()
endif()
file(REMOVE ${cache}/imgui.tar)
if(NOT pinned)
  message(FATAL_ERROR "Dear ImGui ${imgui_version} could not be fetched: connect to a network, "
    "or unpack that version yourself and pass -DSNUG_IMGUI_DIR=FOLDER.")
endif()
