// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/questionnaire_summary.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// A rule by which an instrument's answers become a score, as it was published. Its word stands in Questionnaire::score.
enum class ScoreRule {
    sus,        ///< "sus": Brooke (1996), ten statements from 1 to 5: odd ones − 1, even ones 5 −, their sum × 2.5; 0 to 100
    rawTlx,     ///< "nasa_tlx_raw": the mean of the six scales, each from 0 to 100 (Hart 2006)
    weightedTlx,///< "nasa_tlx_weighted": the same weighted by how often each was chosen of the 15 pairs (Hart & Staveland 1988)
    laterality, ///< "laterality_quotient": Oldfield (1971), 100 (R − L)/(R + L); −100 left to 100 right
};
std::optional<ScoreRule> scoreRuleOf(const std::string& word) noexcept;

/// One figure of a participant's answers. Not a number where what it takes was not answered.
struct InstrumentScore {
    std::string id; ///< "sus", "workload", "laterality_quotient", and of the workload's scales the item's id
    double value = std::numeric_limits<double>::quiet_NaN();
};

/// The scores of one reply, the whole one first. Empty where the questionnaire has no rule, or one that this version does not know.
///
/// What a rule expects of the items: sus: ten likert items of 5 steps in their order; TLX: likert items of 21 steps from 0 to 100 in fives, and
/// for the weights choice items "pair_A_B" of two, whose choice 0 is the scale A and 1 the scale B; laterality: choice items of five, from
/// "always left" over "either" to "always right" (++ left, + left, + each, + right, ++ right).
std::vector<InstrumentScore> instrumentScores(const Questionnaire& questionnaire, const QuestionnaireReply& reply);

/// Why a questionnaire cannot be scored by its rule: empty where it can, or has none.
std::string scoreFault(const Questionnaire& questionnaire);

} // namespace chiron::psychophysics
