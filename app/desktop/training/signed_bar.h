// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <cmath>

namespace chiron::desktop {

/// One component of a force or torque: a bar from nothing in the middle to a quarter more than the limit at either side,
/// both limits as lines; beyond them it is hatched and says so in words. Bar and number each only where the level allows
/// them. GUI thread.
class SignedBar final : public QWidget {
    Q_OBJECT
public:
    struct Quantity {
        QString sign;       ///< short, on the screen: "Fx"
        QString name;       ///< for a screen reader: "Force along x"
        QString unit;       ///< for a screen reader; the heading above says it on the screen
        double limit = 1.0; ///< in that unit
        int decimals = 2;
    };
    SignedBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool bar, bool number, QWidget* parent = nullptr);

    void setValue(double value); ///< in the quantity's unit
    double value() const noexcept { return m_value; }
    bool isOver() const noexcept { return std::abs(m_value) > m_quantity.limit; }
    void speak(); ///< writes the present value for a screen reader; not each frame
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString numberText() const;
    void paintBar(QPainter& painter, int top) const;

    const Theme& m_theme;
    QLocale m_locale;
    Quantity m_quantity;
    bool m_bar;
    bool m_number;
    double m_value = 0.0;
};

} // namespace chiron::desktop
