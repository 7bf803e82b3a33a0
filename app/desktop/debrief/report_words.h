// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_data.h"

namespace chiron::desktop {

/// Who, what and on what, as the screen says it.
struct ReportNames {
    QString person;
    QString exercise;
    QString device;
};

/// The printed report in the language of the screen: the data come with stored tokens and English names. GUI thread.
void translateReport(report::ReportData& data, const ReportNames& names);

} // namespace chiron::desktop
