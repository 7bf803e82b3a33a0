// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"

#include "catalogue/resolved_level.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::SphereApexParameters;

// Leaves the centres a disc of at least 20 mm.
constexpr double kSmallestRadius_m = 0.005, kLargestRadius_m = 0.045;
/// For a trial without a limit: nobody searches longer.
constexpr double kNoLimit_s = 600.0;

constexpr const char* kMetrics[] = {
    "apex_error_mean",      "apex_error_sd", "apex_misses", "apex_bias_x", "apex_bias_y", "time",
    "path_length",          "sparc",         "force_max",   "force_mean",  "force_rms",   "force_p95",
    "force_time_over_limit"};

core::Error wrong(const psychophysics::Condition& condition, const std::string& what) {
    return {core::ErrorCode::badInput, "condition " + condition.id + ": " + what};
}

bool take(Parameters& p, const std::string& name, double value) {
    if (name == "stiffness_N_per_m")
        p.stiffnessLow_N_per_m = p.stiffnessHigh_N_per_m = value;
    else if (name == "damping_Ns_per_m")
        p.damping_Ns_per_m = value;
    else if (name == "friction")
        p.frictionLow = p.frictionHigh = value;
    else if (name == "bristle_stiffness_N_per_m")
        p.bristleStiffness_N_per_m = value;
    else
        return false;
    return true;
}

/// Writes the keys of content/schema/sphere_apex_parameters.json.
QJsonObject json(const Parameters& p) {
    constexpr double kMm = 1000.0;
    return {{"radius_mm", p.radius_m * kMm},
            {"centre_disc_radius_mm", p.centreDiscRadius_m * kMm},
            {"workspace_radius_mm", p.workspaceRadius_m * kMm},
            {"stiffness_low_N_per_m", p.stiffnessLow_N_per_m},
            {"stiffness_high_N_per_m", p.stiffnessHigh_N_per_m},
            {"damping_N_s_per_m", p.damping_Ns_per_m},
            {"friction_low", p.frictionLow},
            {"friction_high", p.frictionHigh},
            {"bristle_stiffness_N_per_m", p.bristleStiffness_N_per_m},
            {"trials", p.trials},
            {"trial_limit_s", p.trialLimit_s},
            {"between_trials_s", p.betweenTrials_s},
            {"maximum_force_N", p.maximumForce_N}};
}

} // namespace

core::Result<Parameters> apexOf(const psychophysics::Condition& condition,
                                const psychophysics::TrialRules& trial, int trials) {
    if (condition.stimulus.attribute != psychophysics::Attribute::apex)
        return tl::unexpected(wrong(condition, "no apex is looked for"));
    const double radius_m = condition.stimulus.reference;
    if (!(radius_m >= kSmallestRadius_m && radius_m <= kLargestRadius_m))
        return tl::unexpected(wrong(
            condition,
            "a radius of 5 to 45 mm is expected, so that the sphere can lie in other places each time"));
    Parameters p;
    for (const auto& [name, value] : condition.stimulus.fixed)
        if (!std::isfinite(value) || value < 0.0 || !take(p, name, value))
            return tl::unexpected(
                wrong(condition,
                      "fixed attribute \"" + name +
                          "\": of a sphere stiffness, damping, friction and bristle_stiffness are expected"));
    p.radius_m = radius_m;
    p.centreDiscRadius_m = std::min(p.centreDiscRadius_m, p.workspaceRadius_m - radius_m);
    p.trials = std::clamp(trials, 1, kApexTrialsAtMost);
    p.trialLimit_s = trial.exploreLimit_s > 0.0 ? trial.exploreLimit_s : kNoLimit_s;
    p.betweenTrials_s = trial.betweenTrials_s;
    if (trial.visibleObjects)
        p.cues = {"object", "tool"};
    return p;
}

ExerciseLevel apexLevel(const Parameters& parameters, const std::string& study,
                        const std::string& condition) {
    QJsonArray cues, metrics, shownCues{"tool", "arrow"};
    for (const std::string& cue : parameters.cues) {
        cues.append(QString::fromStdString(cue));
        if (cue == "object")
            shownCues.prepend("object");
    }
    for (const char* metric : kMetrics)
        metrics.append(QJsonObject{{"id", metric}, {"version", 1}});
    const QString title = QString::fromStdString(study + " / " + condition);
    const QJsonObject level{
        {"id", QString::fromStdString(condition)},
        {"number", kApexStudyLevel},
        {"title", QJsonObject{{"en", title}}},
        {"objective", QJsonObject{{"en", "A study: a sphere's highest point is found by touch."}}},
        {"measured", QJsonObject{{"en", "Where the mark lies beside the apex, and exploration."}}},
        {"cues", cues},
        {"needs_force", true},
        {"shown_force_variant",
         QJsonObject{
             {"cues", shownCues},
             {"note", QJsonObject{{"en", "This device renders no force. Force is shown, not felt."}}}}},
        {"metrics", metrics},
        {"gates", QJsonArray{}},
        {"parameters", json(parameters)}};
    const QJsonObject exercise{{"id", "sphere_apex"}, {"version", 1}};
    Problems problems; // none can occur: all of it was written just now
    return levelFromResolved(resolvedDocument(exercise, level), problems);
}

} // namespace chiron::catalogue
