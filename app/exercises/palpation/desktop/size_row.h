// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>

class QLabel;

namespace chiron::desktop {

/// The size of a finding: its diameter in whole millimetres, set by minus and plus, with a circle of that
/// size beside the pad of a finger, both to the same scale.
/// Thread: GUI.
class SizeRow final : public QWidget {
    Q_OBJECT
public:
    static constexpr int kLeast_mm = 2;
    static constexpr int kMost_mm = 40;
    static constexpr int kFirst_mm = 10; ///< first value set by minus and plus

    SizeRow(const Theme& theme, const QLocale& locale, double padRadius_m, QWidget* parent = nullptr);

    void setRadius(double radius_m); ///< 0: not said
    void step(int by_mm);            ///< reports the next size; kFirst_mm if there is none yet
    QString words() const;           ///< "Size: 14 mm across"

signals:
    void sized(unsigned tenths_mm); ///< radius, in the unit of a report word

protected:
    void changeEvent(QEvent* event) override;

private:
    QLocale m_locale;
    QLabel* m_title;
    QWidget* m_circle;
    double m_radius_m = -1.0;
    int m_across_mm = 0; ///< 0: not said
};

} // namespace chiron::desktop
