// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"

#include <QJsonArray>
#include <vector>

namespace chiron::session {

/// [{id, version, value, unit, passed}]; an undefined value is null and has a reason; `passed` is present
/// only for metrics with a pass mark.
QJsonArray metricsJson(const std::vector<scoring::MetricValue>& metrics);

} // namespace chiron::session
