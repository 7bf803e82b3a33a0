// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <QCoreApplication>
#include <QString>
#include <string_view>

namespace chiron::session_report {

/// The translation context of what is said of marks.
struct MarkTexts {
    Q_DECLARE_TR_FUNCTIONS(PlaybackMarks)
};

/// What a trial's end, and damage, are called in an exercise. None is anybody's default.
struct EndWords {
    QString marked;
    QString completed;
    QString timedOut;
    QString failed;
    QString damaged;
};

/// Of the exercise with this id; of one that is not known, empty. A new kind adds its line in app/exercises/report_catalogue.cpp. In the
/// program's language, as the next.
EndWords endWords(std::string_view exercise);

/// What a level's tool is called where its tools are told apart: "Right instrument", "Middle finger". `tools`: how many there are.
QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools);

} // namespace chiron::session_report
