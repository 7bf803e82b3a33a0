// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "haptics/display_state.h"

#include <QFrame>
#include <QLocale>

class QLabel;
class QPushButton;

namespace chiron::desktop {

/// Shows the exercise, the device, the current trial and the number of trials, and the time left.
/// Thread: GUI.
class HeaderBar final : public QFrame {
    Q_OBJECT
public:
    struct Titles {
        QString exercise;
        QString level;
        QString device;
        QString deviceIcon;
        int trials = 1;
        bool sound = false; ///< the level has sound cues that can be muted
        bool familiarisation = false;
    };
    HeaderBar(const Theme& theme, const QLocale& locale, const Titles& titles, QWidget* parent = nullptr);

    void show(const haptics::DisplayState& state);
    void setCompact(bool compact); ///< without the device, in smaller text, if the scene needs the height
    void setMuted(bool muted);
    void setSilent(const QString& why); ///< there is no sound output: says so once, unobtrusively

signals:
    void muteAsked();

private:
    const Theme& m_theme;
    QLocale m_locale;
    int m_trials;
    QLabel* m_device = nullptr;
    bool m_compact = false;
    QLabel* m_trial;
    QLabel* m_left;
    QPushButton* m_mute = nullptr;
    int m_shownTrial = -1;
    int m_shownLeft_s = -1;
};

} // namespace chiron::desktop
