// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_mask.h"

#include "catalogue/study_json.h"

#include <algorithm>
#include <cctype>

namespace chiron::database {
namespace {

using psychophysics::Attribute;
using psychophysics::Condition;

// The attribute with the widest range accepts every table that any attribute accepts.
constexpr Attribute kWidest = Attribute::deformation;

bool oneAttribute(const std::vector<Condition>& conditions) {
    return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& each) {
        return each.stimulus.attribute == conditions.front().stimulus.attribute;
    });
}

// Returns a condition that is not one of the study's, for readers who may know only the number of trials.
// Whether the task is to find an apex is visible in every list of sessions anyway.
Condition plainCondition(bool apex) {
    Condition plain;
    plain.stimulus.attribute = apex ? Attribute::apex : kWidest;
    plain.stimulus.differences = {0.1};
    plain.task = apex ? psychophysics::Task::adjustment : psychophysics::Task::twoAfc;
    plain.procedures = {psychophysics::ConstantSpec{{0.1}, 1, true}};
    return plain;
}

// Returns the properties that the conditions share; the others have neutral values.
Condition shared(const psychophysics::StudyDesign& design, const Blinding& blinding) {
    const Condition& first = design.conditions.front();
    const bool apex = blinding.oneExercise && first.stimulus.attribute == Attribute::apex;
    Condition out = blinding.asksAlike() ? first : plainCondition(apex);
    if (blinding.oneStimulus && blinding.asksAlike()) {
        return out;
    }
    out.stimulus.attribute = oneAttribute(design.conditions) && (blinding.asksAlike() || apex)
                                 ? first.stimulus.attribute
                                 : kWidest;
    out.stimulus.fixed.clear();
    out.stimulus.reference = catalogue::middleReference(out);
    return out;
}

} // namespace

core::Result<std::string> maskedDesign(const std::string& designJson, const Blinding& blinding,
                                       const std::vector<SealedCondition>& codes) {
    auto design = catalogue::readStudy(QByteArray::fromStdString(designJson), "design");
    CHIRON_TRY(design);
    const Condition like = shared(*design, blinding);
    design->conditions.clear();
    for (const SealedCondition& code : codes) {
        Condition condition = like;
        condition.id = "sealed_";
        for (const char each : code.sealedCode) {
            condition.id += std::isalnum(static_cast<unsigned char>(each)) != 0
                                ? static_cast<char>(std::tolower(static_cast<unsigned char>(each)))
                                : '_';
        }
        condition.title = {{"en", code.sealedCode}};
        condition.instructions.clear(); // "put the glove on" would identify a condition
        design->conditions.push_back(std::move(condition));
    }
    return catalogue::studyJson(*design).toStdString();
}

} // namespace chiron::database
