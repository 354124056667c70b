// The cost chart for the page: the data of its controls and its table, and results as files.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "app/app.hpp"

namespace snug::web {

/// The provenance of this program; the page provides the processor, as far as a browser tells.
[[nodiscard]] cost::Provenance web_provenance(const std::string& processor);

/// {chart: "accuracy", "growth" or "turn", shown, running, progress, ready, decided, size, of, then, rows}; null if the
/// lesson has no chart. A row is an algorithm {algorithm, title, time, size, points, of, front, trusted}, of growth
/// {algorithm, title, points, time, trusted, exponent, theory, bound, tight, stopped}, or of a turn an update {volume,
/// strategy, title, angles, least, most, time}.
[[nodiscard]] emscripten::val costs_object(app::App& app);

/// The shown chart's measurement as a file. format: "csv" or "json".
[[nodiscard]] std::string costs_file(app::App& app, const std::string& format);

/// Shows an earlier result over the current one. Returns "" or why it cannot be read or shown.
[[nodiscard]] std::string lay_over(app::App& app, const std::string& csv, const std::string& name);

}  // namespace snug::web
