// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/worst_moment.h"

#include <QLocale>
#include <QString>
#include <string>

namespace chiron::desktop {

/// The sentence on the moment behind a missed pass mark: "You pressed hardest in trial 2, 0:05.0 after it
/// began: 3.20 N." `text` is that of the exercise's content (catalogue::Advice::moment) in the person's
/// language. Where it is empty, or asks for something that the moment does not have, the sentence is a
/// general one. Empty for the value of a session's only trial as a whole: the missed pass mark itself says
/// it. `several`: the session was planned with more than one trial.
/// Thread: GUI, because it translates.
QString momentSentence(const QString& text, const session::WorstMoment& moment, const std::string& exercise,
                       bool several, const QLocale& locale);

} // namespace chiron::desktop
