// The chart of costs for the page: what its controls and its table show, and results as files.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "app/app.hpp"

namespace snug::web {

/// What is known of this program; the processor is the page's to say, as far as a browser tells.
[[nodiscard]] cost::Provenance web_provenance(const std::string& processor);

/// {shown, running, progress, ready, total, size, rows: [{title, time, size, points, of, front, trusted}], then}; null
/// where the lesson has no chart.
[[nodiscard]] emscripten::val costs_object(app::App& app);

/// What was measured: "csv" or "json".
[[nodiscard]] std::string costs_file(app::App& app, const std::string& format);

/// Lays a result over the present one. "" or why it cannot be read.
[[nodiscard]] std::string lay_over(app::App& app, const std::string& csv, const std::string& name);

}  // namespace snug::web
