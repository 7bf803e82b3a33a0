// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"
#include "session/playback_mark.h"
#include "session_report/tool_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <memory>
#include <span>
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

/// The words for one kind of mark, in the program's language.
struct MarkWords {
    session::PlaybackMarkKind kind;
    QString (*say)(const session::PlaybackMark& mark, const QLocale& locale) = nullptr;
};

/// The words for the beginning of a stage or step.
struct StageWords {
    std::string_view stage; ///< PlaybackMark::detail
    const char* text = "";  ///< English, marked for translation in the context PlaybackMarks
};

/// What printed reports and playback say that is specific to one exercise. A new exercise adds a derived
/// class and a line in app/exercises/exercise_catalogue.h. Stateless. Texts are in the program's language.
class ExerciseReporter {
public:
    ExerciseReporter() = default;
    ExerciseReporter(const ExerciseReporter&) = delete;
    ExerciseReporter& operator=(const ExerciseReporter&) = delete;
    virtual ~ExerciseReporter() = default;

    virtual std::string_view id() const noexcept = 0;
    /// The exercise's own section of a session's report; null if there is none. Pure function.
    virtual std::shared_ptr<const report::ReportSection> section(const scoring::SessionTrace&,
                                                                 const catalogue::ExerciseLevel&) const {
        return nullptr;
    }
    virtual EndWords ends() const = 0;
    /// The words for its own kinds of marks (session::mark_kinds in its folder).
    virtual std::span<const MarkWords> marks() const noexcept { return {}; }
    /// The words for the stages or steps of its task.
    virtual std::span<const StageWords> stages() const noexcept { return {}; }
    /// The name of a level's tool, for levels with several tools: "Right instrument", "Middle finger".
    /// `tools`: number of tools.
    virtual QString toolName(const catalogue::ExerciseLevel&, int tool, int tools) const {
        return instrumentName(tool, tools);
    }
};

/// The reporter of the exercise with this id; null if the exercise is not known.
const ExerciseReporter* exerciseReporter(std::string_view id) noexcept;

/// ExerciseReporter::section of the level's exercise; null if the exercise is not known.
std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace,
                                                               const catalogue::ExerciseLevel& level);
/// ExerciseReporter::ends of the exercise with this id; empty if the exercise is not known.
EndWords endWords(std::string_view exercise);
/// ExerciseReporter::toolName of the level's exercise; an instrument if the exercise is not known.
QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools);

} // namespace chiron::session_report
