// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session/palpation_marks.h"

#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/findings_trace.h"

#include <algorithm>

namespace chiron::session {

namespace {

PlaybackMark markAt(const PlaybackTrack& track, int trial, double t_s, const PlaybackMarkKind& kind) {
    PlaybackMark mark;
    mark.t_s = mark.end_s = t_s;
    mark.tick = track.tickAt(t_s);
    mark.trial = trial;
    mark.kind = kind;
    return mark;
}

/// True if the report started a finding that remained until the end and matched no lump.
bool isFalseAlarm(const scoring::PalpationAnswer& answer, std::size_t report) {
    const int finding = answer.reports[report].finding;
    if (answer.reports[report].field != simulation::ReportField::found)
        return false;
    for (std::size_t later = report + 1; later < answer.reports.size(); ++later)
        if (answer.reports[later].finding == finding &&
            answer.reports[later].field == simulation::ReportField::found)
            return false; // taken back, and its number was reused
    return std::any_of(
        answer.matches.begin(), answer.matches.end(),
        [finding](const scoring::FindingMatch& match) { return match.finding == finding && !match.hit(); });
}

void addReports(PlaybackTrack& track, const PalpationOutcome& record) {
    for (std::size_t i = 0; i < record.answer.reports.size(); ++i) {
        const scoring::TimedReport& report = record.answer.reports[i];
        if (report.field != simulation::ReportField::found && report.field != simulation::ReportField::remove)
            continue;
        const PlaybackMarkKind& kind = report.field == simulation::ReportField::remove
                                           ? mark_kinds::kTakenBack
                                       : isFalseAlarm(record.answer, i) ? mark_kinds::kFalseAlarm
                                                                        : mark_kinds::kFound;
        track.marks.push_back(markAt(track, record.trial, report.t_s, kind));
        track.marks.back().value = report.finding + 1;
    }
}

} // namespace

std::vector<std::size_t> falseAlarmReports(const scoring::PalpationAnswer& answer) {
    std::vector<std::size_t> reports;
    for (std::size_t i = 0; i < answer.reports.size(); ++i)
        if (isFalseAlarm(answer, i))
            reports.push_back(i);
    return reports;
}

void addPalpationMarks(PlaybackTrack& track, std::span<const PalpationOutcome> outcomes) {
    for (const PalpationOutcome& record : outcomes) {
        addReports(track, record);
        const PlaybackTrial* trial = track.trial(record.trial);
        if (trial == nullptr || !(record.completed || record.timedOut))
            continue; // for an aborted search, it is unknown what it would have found
        for (std::size_t lump = 0; lump < record.answer.truth.lumps.size(); ++lump)
            if (scoring::foundBy(record.answer.matches, static_cast<int>(lump)) == nullptr)
                track.marks.push_back(markAt(track, record.trial, trial->end_s, mark_kinds::kLumpMissed));
    }
    std::stable_sort(track.marks.begin(), track.marks.end(),
                     [](const auto& a, const auto& b) { return a.t_s < b.t_s; });
}

} // namespace chiron::session
