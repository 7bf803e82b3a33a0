// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/questionnaire_measures.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// A published rule that turns an instrument's answers into a score. Questionnaire::score holds its word,
/// given here in quotes.
enum class ScoreRule {
    /// "sus": Brooke (1996), ten statements from 1 to 5: odd ones count as answer − 1, even ones as 5 −
    /// answer, their sum × 2.5; 0 to 100.
    sus,
    rawTlx, ///< "nasa_tlx_raw": the mean of the six scales, each from 0 to 100 (Hart 2006)
    /// "nasa_tlx_weighted": the mean weighted by how often each scale was chosen in the 15 pairs (Hart &
    /// Staveland 1988).
    weightedTlx,
    laterality, ///< "laterality_quotient": Oldfield (1971), 100 (R − L)/(R + L); −100 left to 100 right
};
std::optional<ScoreRule> scoreRuleOf(const std::string& word) noexcept;

/// One number computed from a participant's answers. Not a number if an answer that it needs is missing.
struct InstrumentScore {
    /// "sus", "workload", "laterality_quotient"; for the scales of the workload, the item's id.
    std::string id;
    double value = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the scores of one reply, the overall score first. Empty if the questionnaire has no rule, or one
/// that this version does not know.
///
/// Each rule expects certain items. sus: ten likert items with 5 steps, in their order. TLX: likert items
/// with 21 steps, from 0 to 100 in fives; for the weights also choice items "pair_A_B" with two choices, of
/// which choice 0 is the scale A and choice 1 the scale B. Laterality: choice items with five choices, from
/// "always left" over "either" to "always right" (++ left, + left, + each, + right, ++ right).
std::vector<InstrumentScore> instrumentScores(const Questionnaire& questionnaire,
                                              const QuestionnaireReply& reply);

/// Returns why a questionnaire cannot be scored by its rule; empty if it can, or has no rule.
std::string scoreFault(const Questionnaire& questionnaire);

} // namespace chiron::psychophysics
