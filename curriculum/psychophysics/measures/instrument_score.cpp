// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/instrument_score.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace chiron::psychophysics {

namespace {

constexpr std::array<std::string_view, 4> kWords{"sus", "nasa_tlx_raw", "nasa_tlx_weighted",
                                                 "laterality_quotient"};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kSusItems = 10;
constexpr int kSusScale = 5;
constexpr int kTlxScale = 21;
constexpr std::size_t kTlxScales = 6;
constexpr double kTlxStep = 5.0;
constexpr std::size_t kHands = 5;

using Items = std::vector<QuestionnaireItem>;

bool isPair(const QuestionnaireItem& item) {
    return item.kind == QuestionnaireItem::Kind::choice && item.id.starts_with("pair_");
}

double answerNumber(const QuestionnaireReply& reply, const QuestionnaireItem& item) {
    const auto found = reply.numbers.find(item.id);
    return found == reply.numbers.end() ? kNone : found->second;
}

std::vector<const QuestionnaireItem*> scalesOf(const Items& items) {
    std::vector<const QuestionnaireItem*> scales;
    for (const QuestionnaireItem& item : items)
        if (item.kind == QuestionnaireItem::Kind::likert)
            scales.push_back(&item);
    return scales;
}

/// Returns the two scales that a pair names, in its order; empty if it names none.
std::pair<std::string, std::string> pairOf(const QuestionnaireItem& pair,
                                           const std::vector<const QuestionnaireItem*>& scales) {
    for (const QuestionnaireItem* a : scales)
        for (const QuestionnaireItem* b : scales)
            if (a != b && pair.id == "pair_" + a->id + "_" + b->id)
                return {a->id, b->id};
    return {};
}

double sus(const Items& items, const QuestionnaireReply& reply) {
    double sum = 0.0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const double answer = answerNumber(reply, items[i]);
        sum += i % 2 == 0 ? answer - 1.0 : 5.0 - answer;
    }
    return 2.5 * sum;
}

std::vector<InstrumentScore> workload(const Items& items, const QuestionnaireReply& reply, bool weighted) {
    const auto scales = scalesOf(items);
    std::map<std::string, double> weights;
    double chosen = weighted ? 0.0 : static_cast<double>(scales.size());
    for (const QuestionnaireItem& item : items) {
        if (!weighted || !isPair(item))
            continue;
        const auto [first, second] = pairOf(item, scales);
        const double answer = answerNumber(reply, item);
        chosen += std::isfinite(answer) ? 1.0 : kNone; // an unanswered pair makes the weights undefined
        weights[answer < 0.5 ? first : second] += 1.0;
    }
    std::vector<InstrumentScore> out{{"workload", 0.0}};
    double sum = 0.0;
    for (const QuestionnaireItem* scale : scales) {
        const double rating = kTlxStep * (answerNumber(reply, *scale) - 1.0);
        sum += (weighted ? weights[scale->id] : 1.0) * rating;
        out.push_back({scale->id, rating});
    }
    out.front().value = sum / chosen;
    return out;
}

double laterality(const Items& items, const QuestionnaireReply& reply) {
    constexpr std::array<double, kHands> kLeft{2, 1, 1, 0, 0};
    constexpr std::array<double, kHands> kRight{0, 0, 1, 1, 2};
    double left = 0.0, right = 0.0;
    for (const QuestionnaireItem& item : items) {
        const double answer = answerNumber(reply, item);
        if (!std::isfinite(answer) && !item.required)
            continue; // not everybody does each activity: the published form allows such a line to be left
                      // out
        if (!(answer >= 0.0 && answer < static_cast<double>(kHands)))
            return kNone;
        left += kLeft[static_cast<std::size_t>(answer)];
        right += kRight[static_cast<std::size_t>(answer)];
    }
    return 100.0 * (right - left) / (right + left);
}

std::string faultOf(const Items& items, bool (*good)(const QuestionnaireItem&), std::size_t count,
                    const char* expected) {
    const bool all = items.size() == count && std::all_of(items.begin(), items.end(), good);
    return all ? std::string() : std::string(expected);
}

std::string workloadFault(const Items& items, bool weighted) {
    const auto scales = scalesOf(items);
    std::size_t pairs = 0;
    for (const QuestionnaireItem& item : items)
        pairs += isPair(item) && item.choices.size() == 2 && !pairOf(item, scales).first.empty() ? 1 : 0;
    const bool rated = scales.size() == kTlxScales &&
                       std::all_of(scales.begin(), scales.end(),
                                   [](const QuestionnaireItem* scale) { return scale->scale == kTlxScale; });
    const std::size_t expected = weighted ? kTlxScales * (kTlxScales - 1) / 2 : 0;
    return rated && pairs == expected && items.size() == kTlxScales + expected ? std::string()
           : weighted ? std::string("six scales of 21 steps and their 15 pairs of two choices")
                      : std::string("six scales of 21 steps");
}

} // namespace

std::optional<ScoreRule> scoreRuleOf(const std::string& word) noexcept {
    const auto found = std::find(kWords.begin(), kWords.end(), word);
    return found == kWords.end() ? std::nullopt
                                 : std::optional(static_cast<ScoreRule>(found - kWords.begin()));
}

std::string scoreFault(const Questionnaire& questionnaire) {
    const auto rule = scoreRuleOf(questionnaire.score);
    if (questionnaire.score.empty() || !rule)
        return questionnaire.score.empty()
                   ? std::string()
                   : std::string("sus, nasa_tlx_raw, nasa_tlx_weighted or laterality_quotient");
    switch (*rule) {
    case ScoreRule::sus:
        return faultOf(
            questionnaire.items,
            [](const QuestionnaireItem& item) {
                return item.kind == QuestionnaireItem::Kind::likert && item.scale == kSusScale;
            },
            kSusItems, "ten statements of five steps");
    case ScoreRule::laterality:
        return faultOf(
            questionnaire.items,
            [](const QuestionnaireItem& item) {
                return item.kind == QuestionnaireItem::Kind::choice && item.choices.size() == kHands;
            },
            questionnaire.items.size(), "activities of five choices, from always left to always right");
    default:
        return workloadFault(questionnaire.items, *rule == ScoreRule::weightedTlx);
    }
}

std::vector<InstrumentScore> instrumentScores(const Questionnaire& questionnaire,
                                              const QuestionnaireReply& reply) {
    const auto rule = scoreRuleOf(questionnaire.score);
    if (!rule || !scoreFault(questionnaire).empty())
        return {};
    switch (*rule) {
    case ScoreRule::sus:
        return {{"sus", sus(questionnaire.items, reply)}};
    case ScoreRule::laterality:
        return {{"laterality_quotient", laterality(questionnaire.items, reply)}};
    default:
        return workload(questionnaire.items, reply, *rule == ScoreRule::weightedTlx);
    }
}

} // namespace chiron::psychophysics
