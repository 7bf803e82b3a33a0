// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session_report/finger_words.h"
#include "devices/driver.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "session_report/tool_words.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// The words for findings, the same in training, playback and debrief. All functions of this header are pure.
QString hardnessWord(int rating);                         ///< 1 "soft" .. 5 "stony"; 0: "not said"
QString confidenceWord(int rating);                       ///< 1 "a guess" .. 5 "certain"; 0: "not said"
QString sizeText(double radius_m, const QLocale& locale); ///< "14 mm across"; 0: "not said"
/// "Finding 2: 14 mm across, firm, sure": the ratings that the level asks for. Missing ratings are named as
/// such.
QString findingText(int finding, const simulation::PalpationCues& cues, const QLocale& locale);
/// The ratings still missing: "Finding 2: size, confidence", one entry per finding; empty if none is missing.
QStringList missingRatings(const simulation::PalpationCues& cues, const QLocale& locale);
int findingCount(const simulation::PalpationCues& cues);
/// keysInWords() of a palpation, including the keys that report findings. `rates`: the level asks for more
/// than the position.
QString palpationKeysInWords(bool ownHand, int hands, bool rates, bool pinches = false,
                             devices::HandKind hand = devices::HandKind::mouseAndKeyboard);
/// The hand that mouse and keyboard move, in words; 0 is the right one.
QString activeHandInWords(int hand);
using session_report::fingerName;

} // namespace chiron::desktop
