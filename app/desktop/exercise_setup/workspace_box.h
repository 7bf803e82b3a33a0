// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "session/station.h"

#include <QFrame>
#include <QLocale>
#include <array>

class QDoubleSpinBox;
class QRadioButton;

namespace chiron::desktop {

/// How the hand's workspace lies in the field: hand, scale, shift; how a device's base is mounted; folded away until somebody wants it. GUI thread.
class WorkspaceBox final : public QFrame {
    Q_OBJECT
public:
    WorkspaceBox(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);

    void setChoice(const session::WorkspaceChoice& choice);
    session::WorkspaceChoice choice() const;
    /// A device with a base shows how that is mounted; a pointer, which has none, how the hand's workspace lies.
    void setHasBase(bool has);

signals:
    void changed();

private:
    QWidget* handRow();
    QDoubleSpinBox* spin(const QString& name, const QString& title, const QString& suffix, double minimum, double maximum, double step,
                         class QGridLayout& grid);

    const Theme& m_theme;
    QLocale m_locale;
    QRadioButton* m_right = nullptr;
    QRadioButton* m_left = nullptr;
    QDoubleSpinBox* m_scale = nullptr;
    std::array<QDoubleSpinBox*, 3> m_origin{};
    std::array<QDoubleSpinBox*, 3> m_turn{};
    QWidget* m_handPart = nullptr;
    QWidget* m_basePart = nullptr;
};

} // namespace chiron::desktop
