// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/answer_events.h"

#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"
#include "app/exercises/palpation/session/palpation_marks.h"

#include <algorithm>
#include <optional>

namespace chiron::session {

namespace {

/// An event whose tick or whose time is still to be read from the frames.
struct Wanted {
    std::optional<std::uint64_t> tick;
    double from_s = 0.0; ///< without a tick: the first frame that is not earlier
    bool placed = false;
    database::EventRecord event;
};

class AnswerEvents {
public:
    void add(const scoring::TrialTrace& trial, const database::TrialRecord& record) {
        if (trial.apex)
            addApex(trial, record);
        else if (const auto judged = scoring::judgePalpation(trial); judged.answer)
            addPalpation(trial, record, *judged.answer);
    }
    bool empty() const noexcept { return m_wanted.empty(); }

    void place(const FrameTime& frame) {
        constexpr double kSameTime_s = 0.6e-6; // traces hold whole microseconds
        for (Wanted& wanted : m_wanted) {
            const bool here = wanted.tick ? frame.tick >= *wanted.tick : frame.t_s + kSameTime_s >= wanted.from_s;
            if (wanted.placed || !here)
                continue;
            wanted.placed = true;
            wanted.event.tick = frame.tick;
            wanted.event.time_s = std::max(0.0, frame.t_s);
        }
    }

    std::vector<database::EventRecord> take() {
        std::vector<database::EventRecord> events;
        for (Wanted& wanted : m_wanted)
            if (wanted.placed)
                events.push_back(std::move(wanted.event));
        return events;
    }

private:
    Wanted& want(const char* kind, int trial) {
        Wanted wanted;
        wanted.event.kind = kind;
        wanted.event.detailJson = "{\"trial\":" + std::to_string(trial) + "}";
        m_wanted.push_back(std::move(wanted));
        return m_wanted.back();
    }

    void addApex(const scoring::TrialTrace& trial, const database::TrialRecord& record) {
        if (!trial.marked || trial.tools.empty())
            return; // what was not marked is an event already
        scoring::PreparedTrial prepared; // of which the answer reads position and truth alone
        prepared.trial = &trial;
        prepared.tool = &trial.tools.front();
        if (const auto answer = scoring::apexAnswer(prepared); answer && answer->miss)
            want("missed", trial.trial).tick = record.lastTick;
    }

    void addPalpation(const scoring::TrialTrace& trial, const database::TrialRecord& record, const scoring::PalpationAnswer& answer) {
        for (const std::size_t report : falseAlarmReports(answer)) {
            Wanted& alarm = want("false_alarm", trial.trial);
            alarm.from_s = answer.reports[report].t_s;
            alarm.event.detailJson = "{\"trial\":" + std::to_string(trial.trial) + ",\"finding\":" + std::to_string(answer.reports[report].finding + 1) + "}";
        }
        if (!trial.completed && !trial.timedOut)
            return; // of a search that was broken off nobody knows what it would have found
        for (std::size_t lump = 0; lump < answer.truth.lumps.size(); ++lump)
            if (scoring::foundBy(answer.matches, static_cast<int>(lump)) == nullptr)
                want("lump_missed", trial.trial).tick = record.lastTick;
    }

    std::vector<Wanted> m_wanted;
};

} // namespace

std::vector<database::EventRecord> answerEvents(std::span<const FrameTime> frames, const scoring::SessionTrace& trace,
                                                std::span<const database::TrialRecord> trials) {
    AnswerEvents events;
    for (std::size_t i = 0; i < std::min(trace.trials.size(), trials.size()); ++i)
        events.add(trace.trials[i], trials[i]);
    if (events.empty())
        return {};
    for (const FrameTime& frame : frames)
        events.place(frame);
    return events.take();
}

} // namespace chiron::session
