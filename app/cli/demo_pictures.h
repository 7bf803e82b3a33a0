// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/demo_site.h"

#include <QString>
#include <vector>

namespace chiron::cli {

/// What the demonstration draws: of each exercise a report of one session and its operators beside each other; plots of one session.
struct DemoPictures {
    std::vector<QString> reports; ///< PDF
    std::vector<QString> pictures;
};

/// Draws into `folder`. The sessions shown are the expert's sphere found by touch alone, plots too, and its cystoscopy; the study's report. Needs a
/// QApplication.
core::Result<DemoPictures> drawDemo(database::Database& database, const session::DemoSite& made, const QString& folder);

} // namespace chiron::cli
