// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/agreement.h"
#include "psychophysics/study/study_design.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// The answers of one participant, by item id: a number (likert 1..scale, number, choice from 0) or text.
/// Missing answers are not in the map.
struct QuestionnaireReply {
    std::map<std::string, double> numbers;
    std::map<std::string, std::string> texts;
    /// Any measure of performance that is to be compared with the answers.
    double performance = std::numeric_limits<double>::quiet_NaN();
};

struct LikertSummary {
    std::string item;
    std::string construct;
    int scale = 0;
    std::vector<int> counts; ///< of 1..scale
    int answered = 0;
    int missing = 0; ///< not answered, or outside 1..scale
    double median = std::numeric_limits<double>::quiet_NaN();
    double lowerQuartile = std::numeric_limits<double>::quiet_NaN(); ///< quantiles of type 7 (R's default)
    double upperQuartile = std::numeric_limits<double>::quiet_NaN();
    /// Share of answers above the scale's middle (4 and 5 of 5; 3 and 4 of 4).
    double agreement = std::numeric_limits<double>::quiet_NaN();
    double agreementLow = std::numeric_limits<double>::quiet_NaN(); ///< 95 % Wilson
    double agreementHigh = std::numeric_limits<double>::quiet_NaN();
    /// Item-level content validity index (Lynn 1986): the same share, for experts as participants; and its
    /// kappa against chance (Polit, Beck & Owen 2007).
    double contentValidityIndex = std::numeric_limits<double>::quiet_NaN();
    double contentValidityKappa = std::numeric_limits<double>::quiet_NaN();
    RankCorrelation withPerformance; ///< τ-b of the answer with the performance
    std::vector<std::string> warnings;
};

/// Summary of the items of one construct ("face", "content").
struct ConstructSummary {
    std::string construct;
    int items = 0;
    int answers = 0;
    double median = std::numeric_limits<double>::quiet_NaN(); ///< of all answers, if all items have the same
                                                              ///< scale
    double agreement = std::numeric_limits<double>::quiet_NaN(); ///< share of all answers, as above
    /// 95 % Wilson over answers, although the answers of one person are not independent.
    double agreementLow = std::numeric_limits<double>::quiet_NaN();
    double agreementHigh = std::numeric_limits<double>::quiet_NaN();
    /// S-CVI/Ave: mean of the items' indices.
    double contentValidityAverage = std::numeric_limits<double>::quiet_NaN();
    /// S-CVI/UA: share of the items on which all participants agree.
    double contentValidityUniversal = std::numeric_limits<double>::quiet_NaN();
};

struct NumberSummary {
    std::string item;
    int answered = 0;
    double mean = std::numeric_limits<double>::quiet_NaN();
    double sd = std::numeric_limits<double>::quiet_NaN();
    double median = std::numeric_limits<double>::quiet_NaN();
    std::vector<int> choiceCounts;   ///< for a choice item
    RankCorrelation withPerformance; ///< for a number item
};

struct TextAnswers {
    std::string item;
    std::vector<std::string> answers; ///< unchanged, in the order of the replies; empty ones are left out
};

struct QuestionnaireSummary {
    int replies = 0;
    std::vector<LikertSummary> likert;
    std::vector<ConstructSummary> constructs; ///< in order of first appearance
    std::vector<NumberSummary> numbers;
    std::vector<TextAnswers> texts;
    std::vector<std::string> warnings; ///< no_replies, few_replies
};

QuestionnaireSummary summariseQuestionnaire(const Questionnaire& questionnaire,
                                            const std::vector<QuestionnaireReply>& replies);

} // namespace chiron::psychophysics
