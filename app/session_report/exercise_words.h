// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QCoreApplication>
#include <QString>
#include <string_view>

namespace chiron::session_report {

/// The translation context for the words of marks.
struct MarkTexts {
    Q_DECLARE_TR_FUNCTIONS(PlaybackMarks)
};

/// An exercise's words for the end of a trial and for damage. There are no defaults.
struct EndWords {
    QString marked;
    QString completed;
    QString timedOut;
    QString failed;
    QString damaged;
};

/// The words of the exercise with this id; empty if the exercise is not known. A new exercise adds its line
/// in app/exercises/report_catalogue.cpp. This function and the next use the program's language.
EndWords endWords(std::string_view exercise);

/// The name of a level's tool, for levels with several tools: "Right instrument", "Middle finger". `tools`:
/// number of tools.
QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools);

} // namespace chiron::session_report
