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

/// Sets how the hand's workspace maps to the scene (hand, scale, shift) and how the device's base is mounted.
/// It stays folded until it is opened.
/// Thread: GUI.
class WorkspaceBox final : public QFrame {
    Q_OBJECT
public:
    WorkspaceBox(const Theme& theme, const QLocale& locale, QWidget* parent = nullptr);

    void setChoice(const session::WorkspaceChoice& choice);
    session::WorkspaceChoice choice() const;
    /// A device with a base shows how the base is mounted; a pointer, which has none, shows the mapping of
    /// the hand's workspace.
    void setHasBase(bool has);

signals:
    void changed();

private:
    QWidget* handRow();
    QDoubleSpinBox* spin(const QString& name, const QString& title, const QString& suffix, double minimum,
                         double maximum, double step, class QGridLayout& grid);

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
