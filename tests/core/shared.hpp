// What most tests include beyond what most of core does (cmake/shared.hpp), read once for all of them.
#pragma once

#include <doctest/doctest.h>

#include <map>
#include <set>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
