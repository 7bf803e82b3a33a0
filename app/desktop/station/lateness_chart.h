// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "session/loop_report.h"

#include <QLocale>
#include <QWidget>
#include <vector>

namespace chiron::desktop {

/// Shows how late the ticks of a run started, one line per bin with its share as a bar and as a number. Late
/// bins are marked by colour and by a word. Screen readers get every line from the accessible description.
class LatenessChart final : public QWidget {
    Q_OBJECT
public:
    LatenessChart(const Theme& theme, QLocale locale, QWidget* parent = nullptr);
    void setBins(const session::LatenessBins& bins);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override; ///< room for the whole text and a short bar

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Line {
        QString range;
        QString share;
        double fraction = 0.0;
        bool late = false;
    };
    int widest(QString Line::*text) const;

    const Theme& m_theme;
    QLocale m_locale;
    std::vector<Line> m_lines;
};

} // namespace chiron::desktop
