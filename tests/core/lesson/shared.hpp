// What most tests of lessons include beyond what most tests do (core/shared.hpp), read once for all of them.
#pragma once

#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"
#include "core/shared.hpp"
#include "lesson/subjects.hpp"
