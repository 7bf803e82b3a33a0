// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace chiron::bench {

/// Runs a program until it says "chiron-start <last> <ns>" on its standard error, then ends it. Returns the milliseconds from
/// just before it was made to each such line; empty where the last one does not come within ten seconds.
std::map<std::string, double> startUntil(const std::vector<std::string>& command, const std::string& last);

} // namespace chiron::bench
