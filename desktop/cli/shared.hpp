// What nearly every subcommand includes, precompiled (CMakeLists.txt).
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <tl/expected.hpp>
