// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/demo_site.h"

#include <QString>
#include <string>
#include <vector>

namespace chiron::cli {

/// What the demonstration draws.
struct DemoPictures {
    std::vector<QString> reports; ///< PDF
    std::vector<QString> pictures;
};

/// The exercises of these sessions, in the order in which they were done first.
std::vector<std::string> exercisesOf(const std::vector<session::DemoResult>& results);

/// Draws into `folder` what each exercise shows of itself (session::Demonstration), and the study's report. Needs a QApplication.
core::Result<DemoPictures> drawDemo(database::Database& database, const session::DemoSite& made, const QString& folder);

} // namespace chiron::cli
