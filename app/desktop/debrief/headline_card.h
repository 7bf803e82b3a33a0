// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QFrame>
#include <QLocale>

namespace chiron::desktop {

/// One of the at most three numbers that a debrief begins with: name, value, its place on the scale, pass mark and benchmark in
/// words. GUI thread.
class HeadlineCard : public QFrame {
    Q_OBJECT
public:
    HeadlineCard(const Theme& theme, const report::MetricRow& row, const QLocale& locale, QWidget* parent = nullptr);
};

} // namespace chiron::desktop
