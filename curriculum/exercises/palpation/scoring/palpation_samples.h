// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact_bits.h"
#include "curriculum/exercises/palpation/scoring/palpation_answer.h"
#include "curriculum/exercises/palpation/scoring/palpation_reasons.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace chiron::scoring {

/// The judgements of all trials, or the reason why there is no value. One trial without a judgement makes the
/// whole value undefined, because a session's value must not silently leave a trial out.
struct JudgedTrials {
    std::vector<PalpationAnswer> answers;
    std::optional<Measurement> undefined;
};

inline JudgedTrials judged(std::span<const PreparedTrial> trials) {
    JudgedTrials out;
    if (trials.empty())
        out.undefined = Measurement::undefined(reasons::kNoTrials);
    for (const PreparedTrial& trial : trials) {
        JudgedTrial one = judgePalpation(*trial.trial);
        if (!one.answer) {
            out.undefined = Measurement::undefined(one.reason);
            return out;
        }
        out.answers.push_back(std::move(*one.answer));
    }
    return out;
}

/// Returns whether any finger pressed harder than the limit within reach of the lump's position (horizontal
/// distance), or broke tissue there.
inline bool isForced(const PreparedTrial& trial, const PalpationTruth& truth, const LumpTruth& lump) {
    const double reach_m = std::max(truth.hitRadius_m, lump.radius_m);
    for (const ToolTrace& tool : trial.trial->tools)
        for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
            const bool broken =
                i < tool.contact.size() && (tool.contact[i] & core::contact_bits::kThrough) != 0;
            if (tool.paused[i] == 0 && (broken || tool.tissue_N[i].norm() > trial.forceLimit_N) &&
                (tool.p_WT_m[i] - lump.place_W).head<2>().norm() <= reach_m)
                return true;
        }
    return false;
}

/// Returns the same as judged(), except that a lump that was pressed harder than the limit counts as not
/// found, whatever was reported about it. In a patient the pain ends the examination, and a lump that is felt
/// by crushing it says nothing about the sense of touch. Findings of such a lump count for no region.
inline JudgedTrials judgedSafely(std::span<const PreparedTrial> trials) {
    JudgedTrials out = judged(trials);
    for (std::size_t t = 0; t < out.answers.size(); ++t) {
        PalpationAnswer& answer = out.answers[t];
        bool changed = false;
        for (FindingMatch& match : answer.matches)
            if (match.hit() &&
                isForced(trials[t], answer.truth, answer.truth.lumps[static_cast<std::size_t>(match.lump)])) {
                match.lump = match.region = FindingMatch::kNone;
                changed = true;
            }
        if (changed)
            answer.regions = regionsOf(answer.truth, answer.findings, answer.matches);
    }
    return out;
}

inline int lumpsOf(const std::vector<PalpationAnswer>& answers) {
    int lumps = 0;
    for (const PalpationAnswer& answer : answers)
        lumps += static_cast<int>(answer.truth.lumps.size());
    return lumps;
}

/// Returns the counts of the regions of all trials, pooled. Introduction trials are left out.
inline core::DetectionCounts countsOf(const std::vector<PalpationAnswer>& answers) {
    core::DetectionCounts counts;
    for (const PalpationAnswer& answer : answers)
        if (!answer.truth.introduction)
            counts += countsOf(answer.regions);
    return counts;
}

/// Returns the reason why d′, c and the area under the ROC would be meaningless for so few regions.
inline Measurement tooFewRegions(const core::DetectionCounts& n) {
    return Measurement::undefined(
        reasons::kTooFewRegions,
        {static_cast<int>(n.ofSignal), static_cast<int>(n.ofNoise), core::kUsableCounts});
}

/// Returns `measure` of the regions of all trials if there are enough of them.
template <class Measure> Measurement ofRegions(const JudgedTrials& trials, Measure&& measure) {
    const auto& [answers, undefined] = trials;
    if (undefined)
        return *undefined;
    const core::DetectionCounts counts = countsOf(answers);
    return core::isUsable(counts) ? Measurement::of(measure(counts)) : tooFewRegions(counts);
}

/// Calls visit(force on the tissue in N, start in s, end in s) for each unpaused sample of each finger that
/// presses (more than 0.02 N). The force of a sample holds until the next sample of the same finger.
template <class Visit> void forEachPress(const PreparedTrial& trial, Visit&& visit) {
    for (const ToolTrace& tool : trial.trial->tools)
        for (std::size_t i = 0; i + 1 < tool.t_s.size(); ++i)
            if (const double force_N = tool.tissue_N[i].norm();
                tool.paused[i] == 0 && force_N > kContactForce_N)
                visit(force_N, tool.t_s[i], tool.t_s[i + 1]);
}

} // namespace chiron::scoring
