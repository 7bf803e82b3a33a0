// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <cmath>

namespace chiron::desktop {

/// Shows one component of a force or torque: a bar from zero in the middle to a quarter above the limit on
/// either side, with both limits as lines. Beyond them it is hatched and says so in words. Bar and number
/// each appear only if the level allows them.
/// Thread: GUI.
class SignedBar final : public QWidget {
    Q_OBJECT
public:
    struct Quantity {
        QString sign;       ///< short form on the screen: "Fx"
        QString name;       ///< for screen readers: "Force along x"
        QString unit;       ///< for screen readers; on the screen the heading shows it
        double limit = 1.0; ///< in that unit
        int decimals = 2;
    };
    SignedBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool bar, bool number,
              QWidget* parent = nullptr);

    void setValue(double value); ///< in the quantity's unit
    double value() const noexcept { return m_value; }
    bool isOver() const noexcept { return std::abs(m_value) > m_quantity.limit; }
    void speak(); ///< sets the present value for screen readers; not every frame
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
