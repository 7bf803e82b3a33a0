// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QPointF>
#include <QWidget>
#include <array>

namespace chiron::desktop {

/// How the platform under a fingertip leans, seen from above, the finger pointing up: a dot that goes where the platform leans, as the
/// lateral force does, in the field of what the platform can (30° in all, 20° sideways); at its limit the dot is a square and a word
/// says so. One dot a finger, numbered where there are several. GUI thread.
class LeanDial final : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kMost = 4;

    LeanDial(const Theme& theme, const QLocale& locale, int fingers, QWidget* parent = nullptr);

    /// Of one finger, rad; `saturated`: the force leans farther than the platform does.
    void setLean(int finger, double pitch_rad, double roll_rad, bool saturated);
    /// Where the dot is, rad, to the right and down as on the screen: roll = l·x_F, but pitch = −l·y_F (models.md §3), so a positive
    /// pitch leans towards the trainee and goes down. Within what the platform can. Pure.
    static QPointF dotOf(double pitch_rad, double roll_rad);
    QString words() const; ///< "Lean: 12°", "Lean: 30°, at its limit"; of several, each
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
