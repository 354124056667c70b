// What most tests of lessons include beyond what most tests do (core/shared.hpp), read once for all of them.
#pragma once

#include "core/lesson/small_lesson.hpp"
#include "core/shared.hpp"
#include "lesson/play.hpp"
#include "lesson/subjects.hpp"
