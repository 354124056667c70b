# What CTest runs: `ctest -j3 --test-dir build/release`, or one of them with -R core.fit, those of a label with -L desktop.
# Labels: native, wasm or sanitize; command, desktop, page, browser; alone: beside no other.
if(EMSCRIPTEN)
  set(kind wasm)
elseif(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(kind sanitize)
else()
  set(kind native)
endif()
get_filename_component(preset ${PROJECT_BINARY_DIR} NAME)

# snug_suite(NAME COMMAND words... [LABELS label...]): its log is build/logs/PRESET-NAME.log. One that hangs is ended after
# forty minutes and fails alone.
function(snug_suite name)
  cmake_parse_arguments(PARSE_ARGV 1 suite "" "" "COMMAND;LABELS")
  add_test(NAME ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMAND ${PROJECT_SOURCE_DIR}/tests/suite.sh ${preset}-${name} ${suite_COMMAND})
  set_tests_properties(${name} PROPERTIES LABELS "${kind};${suite_LABELS}" TIMEOUT 2400)
endfunction()

# snug_suites(PREFIX LABEL MEASURING names... FILES files... LAUNCHER words...): each file is a suite, run by what launches
# it. Three share two cores, for each waits nearly half of the time; those that measure are alone.
function(snug_suites prefix label)
  cmake_parse_arguments(PARSE_ARGV 2 suites "" "" "MEASURING;FILES;LAUNCHER")
  foreach(file IN LISTS suites_FILES)
    get_filename_component(name ${file} NAME_WE)
    snug_suite(${prefix}.${name} LABELS ${label} COMMAND ${suites_LAUNCHER} ${file})
    if(name IN_LIST suites_MEASURING)
      set_tests_properties(${prefix}.${name} PROPERTIES RUN_SERIAL ON LABELS "${kind};${label};alone")
    endif()
  endforeach()
endfunction()

# The core's, room by room.
if(EMSCRIPTEN) # Emscripten 3.1.6 mistakes Node for a browser when it finds fetch
  set(core ${SNUG_NODE} --no-experimental-fetch $<TARGET_FILE:snug_tests>)
else()
  set(core $<TARGET_FILE:snug_tests>)
endif()
file(GLOB rooms RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/core ${CMAKE_CURRENT_SOURCE_DIR}/core/*/)
foreach(room IN LISTS rooms)
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/core/${room})
    snug_suite(core.${room} COMMAND ${core} --no-colors=1 --source-file=*core/${room}/*)
  endif()
endforeach()

# A minute each, but where CI is set a quarter of it, for its hour is full; for longer, and led by what the code does:
# ./run test --fuzz.
if(kind STREQUAL sanitize AND NOT SNUG_FUZZ)
  set(seconds 60)
  if(DEFINED ENV{CI})
    set(seconds 15)
  endif()
  file(GLOB files CONFIGURE_DEPENDS fuzz/*.cpp)
  foreach(file IN LISTS files)
    get_filename_component(name ${file} NAME_WE)
    if(NOT TARGET fuzz_${name})
      continue()
    endif()
    snug_suite(fuzz.${name} LABELS fuzz COMMAND tests/fuzz/fuzz.sh ${name} ${seconds} sanitize)
  endforeach()
endif()

set(screen ${CMAKE_CURRENT_SOURCE_DIR}/screen.sh)
set(node_test ${SNUG_NODE} --test --test-reporter=tap)
if(kind STREQUAL native)
  snug_suite(app COMMAND $<TARGET_FILE:snug_app_tests> --no-colors=1)
  snug_suite(format COMMAND tests/format.sh)
  snug_suite(subjects COMMAND tests/subjects.sh)
  snug_suite(javascript COMMAND tests/javascript.sh)
  file(GLOB files CONFIGURE_DEPENDS page/*.test.mjs) # what of the page needs neither a browser nor the program
  snug_suites(page page FILES ${files} LAUNCHER ${node_test})
  snug_suite(course_pictures COMMAND ${SNUG_PYTHON} assets/course_pictures.py)
  file(GLOB files CONFIGURE_DEPENDS command/*.test.mjs)
  snug_suites(command command MEASURING cost_table FILES ${files} LAUNCHER ${node_test})
  file(GLOB files CONFIGURE_DEPENDS desktop/*.test.sh)
  snug_suites(desktop desktop MEASURING cost_lesson criteria idle preview working FILES ${files} LAUNCHER ${screen} bash)
  snug_suite(installed LABELS desktop COMMAND ${screen} tests/installed.sh ${PROJECT_BINARY_DIR})
elseif(kind STREQUAL wasm)
  snug_suite(trace_hash COMMAND tests/trace_hash.sh)
  snug_suite(transfer COMMAND ${SNUG_PYTHON} web/size_report.py ${PROJECT_BINARY_DIR}/site)
  file(GLOB files CONFIGURE_DEPENDS browser/*.test.mjs)
  snug_suites(browser browser MEASURING cost cost_chart field FILES ${files} LAUNCHER ${node_test})
  # Neither Firefox nor WebKit draws the stage without a screen.
  file(GLOB files CONFIGURE_DEPENDS browser/engines/*.test.mjs)
  snug_suites(engines browser FILES ${files} LAUNCHER dbus-run-session -- ${screen} ${node_test})
  # The longest begin first, or one of them would end alone.
  set_tests_properties(engines.engines engines.package browser.axe browser.look browser.demo PROPERTIES COST 100)
endif()
