// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace chiron::bench {

/// When a program said something: milliseconds since just before it was made, and its processor time until
/// then.
struct StartStep {
    double wall_ms = 0.0;
    double cpu_ms = 0.0;
};

/// Runs a program until it says "chiron-start <last> ..." on its standard error
/// (app/desktop/frame/start_trace.h), then ends it. Returns each such step; empty where the last one does not
/// come within ten seconds.
std::map<std::string, StartStep> startUntil(const std::vector<std::string>& command, const std::string& last);

} // namespace chiron::bench
