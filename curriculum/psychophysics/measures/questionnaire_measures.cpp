// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/questionnaire_measures.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/run_curve.h"
#include "psychophysics/measures/sample_moments.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

constexpr int kFewReplies = 5;

/// Answers to an item, with the performance of the people who gave them.
struct Answers {
    std::vector<double> value;
    std::vector<double> performance;
    int missing = 0;
};

Answers answersOf(const QuestionnaireItem& item, const std::vector<QuestionnaireReply>& replies) {
    Answers answers;
    for (const QuestionnaireReply& reply : replies) {
        const auto found = reply.numbers.find(item.id);
        const double value =
            found == reply.numbers.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
        const bool whole = std::floor(value) == value;
        const bool valid = item.kind == QuestionnaireItem::Kind::likert
                               ? whole && value >= 1.0 && value <= item.scale
                           : item.kind == QuestionnaireItem::Kind::choice
                               ? whole && value >= 0.0 && value < static_cast<double>(item.choices.size())
                               : std::isfinite(value);
        if (!valid) {
            ++answers.missing;
            continue;
        }
        answers.value.push_back(value);
        answers.performance.push_back(reply.performance);
    }
    return answers;
}

bool agrees(double value, int scale) {
    return 2.0 * value > scale + 1.0;
}

int agreeing(const std::vector<double>& values, int scale) {
    return static_cast<int>(
        std::count_if(values.begin(), values.end(), [=](double value) { return agrees(value, scale); }));
}

/// Returns the kappa of the share who agree against the probability that this many of n would agree by a coin
/// toss.
double validityKappa(double index, int agreed, int n) {
    const double chance = std::exp(logChoose(n, agreed) - n * std::log(2.0));
    return (index - chance) / (1.0 - chance);
}

LikertSummary likertOf(const QuestionnaireItem& item, const Answers& answers) {
    LikertSummary result;
    result.item = item.id;
    result.construct = item.construct;
    result.scale = std::max(0, item.scale);
    result.counts.assign(static_cast<std::size_t>(result.scale), 0);
    for (const double value : answers.value)
        ++result.counts[static_cast<std::size_t>(value) - 1];
    result.answered = static_cast<int>(answers.value.size());
    result.missing = answers.missing;
    if (result.answered == 0) {
        result.warnings.emplace_back("no_replies: nobody answered");
        return result;
    }
    std::vector<double> sorted = answers.value;
    std::sort(sorted.begin(), sorted.end());
    result.median = quantileOf(sorted, 0.5);
    result.lowerQuartile = quantileOf(sorted, 0.25);
    result.upperQuartile = quantileOf(sorted, 0.75);
    const int agreed = agreeing(answers.value, result.scale);
    const ProportionInterval interval = wilsonInterval(agreed, result.answered);
    result.agreement = result.contentValidityIndex = static_cast<double>(agreed) / result.answered;
    result.agreementLow = interval.low;
    result.agreementHigh = interval.high;
    result.contentValidityKappa = validityKappa(result.contentValidityIndex, agreed, result.answered);
    result.withPerformance = kendallTau(answers.value, answers.performance);
    if (result.answered < kFewReplies)
        result.warnings.push_back("few_replies: only " + std::to_string(result.answered) + " answers");
    return result;
}

NumberSummary numberSummaryOf(const QuestionnaireItem& item, const Answers& answers) {
    NumberSummary result;
    result.item = item.id;
    result.answered = static_cast<int>(answers.value.size());
    if (item.kind == QuestionnaireItem::Kind::choice) {
        result.choiceCounts.assign(item.choices.size(), 0);
        for (const double value : answers.value)
            ++result.choiceCounts[static_cast<std::size_t>(value)];
        return result;
    }
    const SampleMoments moments = momentsOf(answers.value);
    std::vector<double> sorted = answers.value;
    std::sort(sorted.begin(), sorted.end());
    result.mean = moments.mean;
    result.sd = moments.sd;
    result.median = quantileOf(sorted, 0.5);
    result.withPerformance = kendallTau(answers.value, answers.performance);
    return result;
}

TextAnswers textsOf(const QuestionnaireItem& item, const std::vector<QuestionnaireReply>& replies) {
    TextAnswers result{item.id, {}};
    for (const QuestionnaireReply& reply : replies)
        if (const auto found = reply.texts.find(item.id);
            found != reply.texts.end() && !found->second.empty())
            result.answers.push_back(found->second);
    return result;
}

ConstructSummary constructOf(const std::string& name, const std::vector<LikertSummary>& items) {
    ConstructSummary result;
    result.construct = name;
    std::vector<double> all;
    int agreed = 0;
    int scale = 0;
    bool oneScale = true;
    double indices = 0.0;
    int rated = 0;
    int universal = 0;
    for (const LikertSummary& item : items) {
        if (item.construct != name)
            continue;
        ++result.items;
        oneScale = oneScale && (scale == 0 || scale == item.scale);
        scale = item.scale;
        for (std::size_t i = 0; i < item.counts.size(); ++i)
            all.insert(all.end(), static_cast<std::size_t>(item.counts[i]), static_cast<double>(i) + 1.0);
        agreed += item.answered > 0 ? static_cast<int>(std::lround(item.agreement * item.answered)) : 0;
        rated += item.answered > 0 ? 1 : 0;
        indices += item.answered > 0 ? item.contentValidityIndex : 0.0;
        universal += item.answered > 0 && item.contentValidityIndex >= 1.0 ? 1 : 0;
    }
    result.answers = static_cast<int>(all.size());
    if (all.empty())
        return result;
    std::sort(all.begin(), all.end());
    result.median = oneScale ? quantileOf(all, 0.5) : std::numeric_limits<double>::quiet_NaN();
    const ProportionInterval interval = wilsonInterval(agreed, result.answers);
    result.agreement = static_cast<double>(agreed) / result.answers;
    result.agreementLow = interval.low;
    result.agreementHigh = interval.high;
    result.contentValidityAverage = indices / rated;
    result.contentValidityUniversal = static_cast<double>(universal) / rated;
    return result;
}

} // namespace

QuestionnaireSummary summariseQuestionnaire(const Questionnaire& questionnaire,
                                            const std::vector<QuestionnaireReply>& replies) {
    QuestionnaireSummary result;
    result.replies = static_cast<int>(replies.size());
    if (replies.empty())
        result.warnings.emplace_back("no_replies: nobody has answered");
    else if (result.replies < kFewReplies)
        result.warnings.push_back("few_replies: only " + std::to_string(result.replies) + " people answered");
    for (const QuestionnaireItem& item : questionnaire.items) {
        if (item.kind == QuestionnaireItem::Kind::text)
            result.texts.push_back(textsOf(item, replies));
        else if (item.kind == QuestionnaireItem::Kind::likert)
            result.likert.push_back(likertOf(item, answersOf(item, replies)));
        else
            result.numbers.push_back(numberSummaryOf(item, answersOf(item, replies)));
    }
    for (const LikertSummary& item : result.likert) {
        const auto known = [&](const ConstructSummary& construct) {
            return construct.construct == item.construct;
        };
        if (!item.construct.empty() &&
            std::none_of(result.constructs.begin(), result.constructs.end(), known))
            result.constructs.push_back(constructOf(item.construct, result.likert));
    }
    return result;
}

} // namespace chiron::psychophysics
