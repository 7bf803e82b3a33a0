// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_track.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::desktop {

/// Formats a moment of a recording in the only way in which screens give it: the trial, and the time since
/// the trial started, as the training screen counted it. (A recording begins before its first trial, so its
/// own time means nothing to people.)
class MomentWords {
    Q_DECLARE_TR_FUNCTIONS(MomentWords)
public:
    MomentWords() = default;
    /// `several`: the session was planned with more than one trial, so each moment names its trial.
    MomentWords(std::vector<session::PlaybackTrial> trials, bool several, QLocale locale)
        : m_trials(std::move(trials)), m_several(several), m_locale(std::move(locale)) {}

    /// "Trial 2, 0:05.0", or "0:05.0" if there is one trial. `t_s` is on the recording's time.
    QString at(double t_s) const;

private:
    std::vector<session::PlaybackTrial> m_trials; ///< ordered by time
    bool m_several = false;
    QLocale m_locale;
};

} // namespace chiron::desktop
