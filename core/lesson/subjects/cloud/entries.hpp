// The entries of all facts that fitters report.
#pragma once

#include "lesson/subjects/cloud/entries_box.hpp"
#include "lesson/subjects/cloud/entries_calls.hpp"
#include "lesson/subjects/cloud/entries_hull.hpp"
#include "lesson/subjects/cloud/entries_naive.hpp"
#include "lesson/subjects/cloud/entries_sphere.hpp"
