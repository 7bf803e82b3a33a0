// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/report_data.h"

#include <QFrame>
#include <QLocale>

namespace chiron::desktop {

/// One of the at most three main numbers of a debrief: name, value, position on the scale, and the pass mark
/// and benchmark as text.
/// Thread: GUI.
class HeadlineCard : public QFrame {
    Q_OBJECT
public:
    HeadlineCard(const Theme& theme, const report::MetricRow& row, const QLocale& locale,
                 QWidget* parent = nullptr);
};

} // namespace chiron::desktop
