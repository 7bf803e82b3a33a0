// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "session_report/tool_words.h"
#include "app/exercises/palpation/session_report/finger_words.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// Words for what is found, the same in training, playback and debrief. Pure, all of these.
QString hardnessWord(int rating);   ///< 1 "soft" .. 5 "stony"; 0: "not said"
QString confidenceWord(int rating); ///< 1 "a guess" .. 5 "certain"; 0: "not said"
QString sizeText(double radius_m, const QLocale& locale); ///< "14 mm across"; 0: "not said"
/// "Finding 2: 14 mm across, firm, sure", of what the level asks; parts not said are named as such.
QString findingText(int finding, const simulation::PalpationCues& cues, const QLocale& locale);
/// What is still to be said of the findings: "Finding 2: size, confidence", one each; empty when all is said.
QStringList missingRatings(const simulation::PalpationCues& cues, const QLocale& locale);
int findingCount(const simulation::PalpationCues& cues);
/// keysInWords() of a palpation, with how findings are told; `rates`: a level asks for more than the place.
QString palpationKeysInWords(bool ownHand, int hands, bool rates, bool pinches = false);
/// Which hand the mouse and the keyboard move: 0 the right one.
QString activeHandInWords(int hand);
using session_report::fingerName;

} // namespace chiron::desktop
