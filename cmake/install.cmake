# Where an installed Snug has its parts, and `cmake --install`'s components: cli (the command and the lessons), window,
# libraries (those that the programs need and a system may lack), development (the core for other programs).
include(GNUInstallDirs)
include(CheckLinkerFlag)

set(SNUG_DATA ${CMAKE_INSTALL_DATADIR}/snug)
set(SNUG_WINDOW_FOLDER ${CMAKE_INSTALL_LIBEXECDIR}/snug)
set(SNUG_LIBRARIES lib/snug)

# snug_way(OUT FROM TO): the way from one installed folder to another, wherever they are installed together.
function(snug_way out from to)
  foreach(end IN ITEMS from to)
    get_filename_component(${end} ${${end}} ABSOLUTE BASE_DIR ${CMAKE_INSTALL_PREFIX})
  endforeach()
  file(RELATIVE_PATH way ${from} ${to})
  set(${out} ${way} PARENT_SCOPE)
endfunction()
snug_way(SNUG_COMMAND_TO_DATA ${CMAKE_INSTALL_BINDIR} ${SNUG_DATA})
snug_way(SNUG_COMMAND_TO_WINDOW ${CMAKE_INSTALL_BINDIR} ${SNUG_WINDOW_FOLDER})
snug_way(SNUG_WINDOW_TO_DATA ${SNUG_WINDOW_FOLDER} ${SNUG_DATA})
snug_way(SNUG_COMMAND_TO_LIBRARIES ${CMAKE_INSTALL_BINDIR} ${SNUG_LIBRARIES})
snug_way(SNUG_WINDOW_TO_LIBRARIES ${SNUG_WINDOW_FOLDER} ${SNUG_LIBRARIES})

set(SNUG_STATIC_CXX -static-libstdc++ -static-libgcc)
check_linker_flag(CXX "${SNUG_STATIC_CXX}" SNUG_HAS_STATIC_CXX)
if(NOT SNUG_HAS_STATIC_CXX)
  set(SNUG_STATIC_CXX)
endif()
