// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/bar_head.h"

#include <QLocale>
#include <QWidget>

namespace chiron::desktop {

/// A bar with a target: a band (between two lines, hatched) or a limit (one line, hatched beyond). A text
/// says whether the value lies below, in or above the target; the number appears only if the level allows
/// numbers.
/// Thread: GUI.
class TargetBar final : public QWidget {
    Q_OBJECT
public:
    struct Quantity {
        QString name;     ///< "Tension"
        QString unit;     ///< "N"
        double end = 1.0; ///< end of the scale, > 0
        int decimals = 2;
    };
    TargetBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool numbers,
              QWidget* parent = nullptr);

    void setBand(double low, double high); ///< both 0: none
    void setLimit(double limit);           ///< 0: none
    void setValue(double value);
    QString words() const; ///< "1.12 N, in the band"
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int place() const; ///< -1 below, 0 in, 1 above the band; 2 over the limit; 3 no target
    QString placeText(int at) const;
    QString wordsAt(double value, int at) const;
    void say();
    void fit(); ///< the head to the width

    const Theme& m_theme;
    QLocale m_locale;
    Quantity m_quantity;
    BarHead m_head;
    bool m_numbers;
    double m_low = 0.0;
    double m_high = 0.0;
    double m_limit = 0.0;
    double m_value = 0.0;
};

} // namespace chiron::desktop
