// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "psychophysics/study/study_design.h"

#include <QJsonObject>
#include <array>

// The parts of a study's JSON, shared by its reader, writer and checks.
namespace chiron::catalogue {

/// A number (or, below, a whole number or a switch) with its key and its allowed range.
template <class Owner> struct NumberKey {
    const char* name;
    double Owner::*member;
    double lowest, highest;
};
template <class Owner> struct WholeKey {
    const char* name;
    int Owner::*member;
    int lowest, highest;
};
template <class Owner> struct SwitchKey {
    const char* name;
    bool Owner::*member;
};

using psychophysics::FidelityLimits;
using psychophysics::TrialRules;

inline constexpr NumberKey<TrialRules> kTrialNumbers[] = {
    {"explore_limit_s", &TrialRules::exploreLimit_s, 0.0, 3600.0},
    {"answer_limit_s", &TrialRules::answerLimit_s, 0.0, 3600.0},
    {"between_trials_s", &TrialRules::betweenTrials_s, 0.0, 60.0},
    {"break_at_least_s", &TrialRules::breakAtLeast_s, 0.0, 3600.0}};
inline constexpr WholeKey<TrialRules> kTrialWholes[] = {
    {"practice_trials", &TrialRules::practiceTrials, 0, 200},
    {"break_every", &TrialRules::breakEvery, 0, 10000}};
inline constexpr SwitchKey<TrialRules> kTrialSwitches[] = {{"feedback", &TrialRules::feedback},
                                                           {"masking_sound", &TrialRules::maskingSound},
                                                           {"visible_objects", &TrialRules::visibleObjects},
                                                           {"must_touch_all", &TrialRules::mustTouchAll}};
/// Kept apart from the numbers that are always written: designs of earlier versions lack it and must keep
/// their bytes.
inline constexpr NumberKey<TrialRules> kProbe[] = {
    {"probe_at_least_N", &TrialRules::probeAtLeast_N, 0.0, 100.0}};
inline constexpr NumberKey<FidelityLimits> kFidelityNumbers[] = {
    {"force_error_rms_N", &FidelityLimits::forceErrorRms_N, 0.001, 100.0},
    {"stiffness_error", &FidelityLimits::stiffnessError, 0.001, 10.0},
    {"late_ticks", &FidelityLimits::lateTicks, 0.0, 1.0},
    {"saturated", &FidelityLimits::saturated, 0.0, 1.0},
    {"peak_force_N", &FidelityLimits::peakForce_N, 0.01, 100.0},
    {"mean_speed_m_per_s", &FidelityLimits::meanSpeed_m_per_s, 0.001, 10.0}};
inline constexpr WholeKey<FidelityLimits> kFidelityWholes[] = {
    {"repeats_at_most", &FidelityLimits::repeatsAtMost, 1, 100}};

/// Tokens, in the order of their enumerations.
inline constexpr std::array<const char*, 2> kScales{"difference", "log_difference"};
inline constexpr std::array<const char*, 4> kOrders{"fixed", "random", "latin_square", "williams"};
inline constexpr std::array<const char*, 4> kItemKinds{"likert", "number", "choice", "text"};
inline constexpr std::array<const char*, 4> kWhens{"before", "after", "enrolment", "after_condition"};

/// These functions read the remaining parts of a study. Faults are added to the problems of `json`.
psychophysics::Questionnaire readQuestionnaire(const ObjectReader& json);
TrialRules readTrialRules(const ObjectReader& json);
FidelityLimits readFidelityLimits(const ObjectReader& json);
std::vector<psychophysics::Questionnaire> readQuestionnaires(const ObjectReader& study);
/// Reads a text in several languages, at least "en". An optional text whose key is missing is read as empty.
psychophysics::StudyText readStudyText(const ObjectReader& json, const char* key, bool required);
std::string readIdentifier(const ObjectReader& json, const char* key);
double readNumber(const ObjectReader& json, const char* key, double lowest, double highest, double otherwise);
int readWhole(const ObjectReader& json, const char* key, int lowest, int highest, int otherwise);
bool readSwitch(const ObjectReader& json, const char* key, bool otherwise);
void addProblem(const ObjectReader& json, const char* key, const QString& found, const QString& expected);

/// Reads one of `words`. A word that is not among them is a problem and yields `otherwise`.
template <class Word, std::size_t n>
Word readWord(const ObjectReader& json, const char* key, const std::array<const char*, n>& words,
              Word otherwise) {
    if (!json.has(QLatin1String(key)))
        return otherwise;
    const std::string given = json.text(QLatin1String(key));
    QStringList known;
    for (std::size_t i = 0; i < n; ++i) {
        known << QLatin1String(words[i]);
        if (given == words[i])
            return static_cast<Word>(i);
    }
    addProblem(json, key, quoted(QString::fromStdString(given)),
               QStringLiteral("one of ") + known.join(", "));
    return otherwise;
}

/// Adds a problem at `key` if `id` has been seen before.
void refuseTwice(const ObjectReader& json, const char* key, const std::string& id,
                 std::vector<std::string>& seen);

/// Checks that every object can answer with the force at which it counts as touched, and that a trial may
/// reach that force.
void checkProbe(const psychophysics::StudyDesign& design, const QString& path, Problems& problems);
/// Checks what no single value can show: that task, table, scale and procedures of a condition fit together.
void checkCondition(const psychophysics::Condition& condition, const QString& path, Problems& problems);
/// Checks the part of it that does not depend on the procedures: that task, scale and table of differences
/// fit together, and that every object is possible.
void checkTable(const psychophysics::Condition& condition, const QString& path, Problems& problems);

} // namespace chiron::catalogue
