// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QPointF>
#include <QWidget>
#include <array>

namespace chiron::desktop {

/// The inclination of the platform under a fingertip, seen from above with the finger pointing up. A dot
/// moves in the direction in which the platform leans, which is that of the lateral force, within the
/// platform's range (30° in all, 20° sideways). At the limit the dot becomes a square and a word says so.
/// There is one dot per finger, numbered if there are several.
/// Thread: GUI.
class LeanDial final : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kMost = 4;

    LeanDial(const Theme& theme, const QLocale& locale, int fingers, QWidget* parent = nullptr);

    /// Sets the inclination of one finger, rad. `saturated`: the force leans farther than the platform can.
    void setLean(int finger, double pitch_rad, double roll_rad, bool saturated);
    /// The position of the dot, rad, to the right and down as on the screen: roll = l·x_F, but pitch = −l·y_F
    /// (models.md §3), so a positive pitch leans towards the trainee and moves the dot down. The result is
    /// within the platform's range. Pure function.
    static QPointF dotOf(double pitch_rad, double roll_rad);
    QString words() const; ///< "Lean: 12°", "Lean: 30°, at its limit"; for several fingers, each one
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Lean {
        double pitch_rad = 0.0;
        double roll_rad = 0.0;
        bool saturated = false;
        double angle_deg() const;
    };
    void paintField(QPainter& painter, const QRectF& field) const;

    const Theme& m_theme;
    QLocale m_locale;
    int m_fingers;
    std::array<Lean, kMost> m_lean{};
};

} // namespace chiron::desktop
