// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/bar_head.h"

#include <QLocale>
#include <QWidget>

namespace chiron::desktop {

/// A bar from zero to a quarter above the limit, with the limit as a line. Above the limit it is hatched and
/// says so in words. It shows the number only if the level allows numbers.
/// Thread: GUI.
class ForceBar final : public QWidget {
    Q_OBJECT
public:
    struct Quantity {
        QString name;       ///< "Force"
        QString unit;       ///< "N"
        double limit = 4.0; ///< in that unit
        int decimals = 2;
    };
    ForceBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool numbers,
             QWidget* parent = nullptr);

    void setValue(double value); ///< in the quantity's unit, ≥ 0
    bool isOver() const noexcept { return isOver(m_value); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    bool isOver(double value) const noexcept { return value > m_quantity.limit; }
    QString words(double value) const; ///< what the bar says at this value

    const Theme& m_theme;
    QLocale m_locale;
    Quantity m_quantity;
    BarHead m_head;
    bool m_numbers;
    double m_value = 0.0;
};

} // namespace chiron::desktop
