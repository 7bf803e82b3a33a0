// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/comparison_reporter.h"

#include "session/study/comparison_marks.h"
#include "session_report/mark_words.h"

namespace chiron::session_report {

namespace {

using session::PlaybackMark;
namespace mark_kinds = session::mark_kinds;

QString sayCameOff(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("The object came off the tool at %1")
        .arg(markValue(mark, QStringLiteral("N"), locale));
}

constexpr MarkWords kComparisonMarks[]{
    {mark_kinds::kCameOff, &sayCameOff},
};

} // namespace

EndWords ComparisonReporter::ends() const {
    return {MarkTexts::tr("Answered"), MarkTexts::tr("The comparison was completed"),
            MarkTexts::tr("Time was up without an answer"),
            MarkTexts::tr("The comparison could no longer be completed"),
            MarkTexts::tr("The object was damaged")};
}

std::span<const MarkWords> ComparisonReporter::marks() const noexcept {
    return kComparisonMarks;
}

} // namespace chiron::session_report
