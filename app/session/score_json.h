// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"

#include <QJsonArray>
#include <vector>

namespace chiron::session {

/// [{id, version, value, unit, passed}]; a value that is not defined is null with its reason, passed only
/// where gated.
QJsonArray metricsJson(const std::vector<scoring::MetricValue>& metrics);

} // namespace chiron::session
