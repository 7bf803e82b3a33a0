// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/moment_words.h"
#include "desktop/theme/theme.h"
#include "session/playback_mark.h"

#include <QLocale>
#include <QWidget>
#include <vector>

class QCheckBox;
class QListWidget;

namespace chiron::desktop {

/// Lists the events of a recording by time; choosing one seeks to it. The list can be limited to penalties.
/// Contacts are numerous and shown on demand.
/// Thread: GUI.
class MarkList : public QWidget {
    Q_OBJECT
public:
    MarkList(const Theme& theme, const QLocale& locale, std::vector<session::PlaybackMark> marks,
             const std::string& exercise, MomentWords moments, QWidget* parent = nullptr);

signals:
    void seekAsked(double t_s);

private:
    void fill();

    const Theme& m_theme;
    QLocale m_locale;
    std::vector<session::PlaybackMark> m_marks;
    std::string m_exercise; ///< selects the texts
    MomentWords m_moments;
    QCheckBox* m_penaltiesOnly;
    QCheckBox* m_contacts;
    QListWidget* m_list;
    class QLabel* m_none;
};

} // namespace chiron::desktop
