// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/demo_site.h"

#include <QString>
#include <vector>

namespace chiron::cli {

/// What the demonstration draws: report and plots of one session, and the operators beside each other.
struct DemoPictures {
    QString reportPdf;
    std::vector<QString> pictures;
};

/// Draws into `folder`. The session shown is the expert's on the level that is felt alone. Needs a QApplication.
core::Result<DemoPictures> drawDemo(database::Database& database, const std::vector<session::DemoResult>& results,
                                    const QString& folder);

} // namespace chiron::cli
