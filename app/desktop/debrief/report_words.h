// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_data.h"

namespace chiron::desktop {

/// The names of person, exercise and device as the screen shows them.
struct ReportNames {
    QString person;
    QString exercise;
    QString device;
};

/// Translates the printed report into the language of the screen. Before the call the data contain stored
/// tokens and English names.
/// Thread: GUI.
void translateReport(report::ReportData& data, const ReportNames& names);

} // namespace chiron::desktop
