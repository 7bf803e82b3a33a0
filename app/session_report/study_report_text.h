// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace chiron::session_report {

/// The single translation context of a study's printed report.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyReport)
};

} // namespace chiron::session_report
