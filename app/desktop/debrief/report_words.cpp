// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/report_words.h"

#include "session_report/metric_words.h"

namespace chiron::desktop {

void translateReport(report::ReportData& data, const ReportNames& names) {
    data.person = names.person;
    data.exerciseTitle = names.exercise;
    data.device = names.device;
    for (report::MetricRow& row : data.metrics) {
        row.name = session_report::metricTitle(row.id, row.trials);
        if (row.unit != QLatin1String("count")) // stays a token, because it makes numbers appear as integers
            row.unit = session_report::unitText(row.unit);
        if (!row.reason.isEmpty())
            row.reason = session_report::metricReason(row.reason);
        if (!row.bandSource.isEmpty())
            row.bandSource = session_report::bandSourceText(row.bandSource);
    }
}

} // namespace chiron::desktop
