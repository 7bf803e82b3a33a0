// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_track.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// The one clock by which screens tell a moment of a recording: the trial, and the time since it began, as the training screen counted it.
/// (A recording begins before its first trial; its own time is nobody's.)
class MomentWords {
    Q_DECLARE_TR_FUNCTIONS(MomentWords)
public:
    MomentWords() = default;
    /// `several`: the session was to have more than one trial, so that each moment names its trial.
    MomentWords(std::vector<session::PlaybackTrial> trials, bool several, QLocale locale)
        : m_trials(std::move(trials)), m_several(several), m_locale(std::move(locale)) {}

    QString at(double t_s) const; ///< "Trial 2, 0:05.0"; "0:05.0" where there is one trial; t_s: the recording's time

private:
    std::vector<session::PlaybackTrial> m_trials; ///< by time
    bool m_several = false;
    QLocale m_locale;
};

} // namespace chiron::desktop
