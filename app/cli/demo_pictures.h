// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/demo_site.h"

#include <QString>
#include <string>
#include <vector>

namespace chiron::cli {

/// The files that the demonstration draws.
struct DemoPictures {
    std::vector<QString> reports; ///< PDF
    std::vector<QString> pictures;
};

/// The exercises of these sessions, in the order of each exercise's first session.
std::vector<std::string> exercisesOf(const std::vector<session::DemoResult>& results);

/// Draws the pictures that each exercise offers for the demonstration (session::Demonstration), and the
/// report of the study, into `folder`. Needs a QApplication.
core::Result<DemoPictures> drawDemo(database::Database& database, const session::DemoSite& made,
                                    const QString& folder);

} // namespace chiron::cli
