// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/object_handling/catalogue/object_handling_content.h"

#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "core/units.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ObjectHandlingParameters;

struct Number {
    const char* name;
    double Parameters::*member;
    double perUnit; ///< content units per SI unit
};

struct Whole {
    const char* name;
    int Parameters::*member;
};

constexpr double kMm = 1000.0;
constexpr double kG = 1000.0;

constexpr Number kNumbers[] = {
    {"bed_rate_Hz", &Parameters::bedRate_Hz, 1.0},
    {"mass_low_g", &Parameters::massLow_kg, kG},
    {"mass_high_g", &Parameters::massHigh_kg, kG},
    {"mass_ratio", &Parameters::massRatio, 1.0},
    {"radius_mm", &Parameters::radius_m, kMm},
    {"places_radius_mm", &Parameters::placesRadius_m, kMm},
    {"target_radius_mm", &Parameters::targetRadius_m, kMm},
    {"squeeze_limit_N", &Parameters::squeezeLimit_N, 1.0},
    {"jaw_length_mm", &Parameters::jawLength_m, kMm},
    {"grasp_reach_mm", &Parameters::graspReach_m, kMm},
    {"release_clearance_mm", &Parameters::releaseClearance_m, kMm},
    {"lift_height_mm", &Parameters::liftHeight_m, kMm},
    {"drop_speed_mm_per_s", &Parameters::dropSpeed_m_per_s, kMm},
    {"hold_s", &Parameters::hold_s, 1.0},
    {"trial_limit_s", &Parameters::trialLimit_s, 1.0},
    {"between_trials_s", &Parameters::betweenTrials_s, 1.0},
    {"maximum_force_N", &Parameters::maximumForce_N, 1.0},
};

constexpr Whole kWholes[] = {
    {"bed_latency_ticks", &Parameters::bedLatency_ticks},
    {"objects", &Parameters::objects},
    {"trials", &Parameters::trials},
};

constexpr const char* kOthers[] = {"task", "object", "bed", "organ_bed", "bed_mesh"};

void readTask(const ObjectReader& parameters, Parameters& p) {
    const std::string task = parameters.text("task");
    if (task == "weigh")
        p.task = simulation::HandlingTask::weigh;
    else if (task == "place")
        p.task = simulation::HandlingTask::place;
    else
        parameters.problems().push_back({memberPath(parameters.path(), "task"),
                                         quoted(QString::fromStdString(task)),
                                         QStringLiteral("\"place\" or \"weigh\"")});
}

std::vector<QString> knownKeys() {
    std::vector<QString> known;
    for (const Number& key : kNumbers)
        known.push_back(QLatin1String(key.name));
    for (const Whole& key : kWholes)
        known.push_back(QLatin1String(key.name));
    for (const char* key : kYieldKeys)
        known.push_back(QLatin1String(key));
    for (const char* key : kOthers)
        known.push_back(QLatin1String(key));
    return known;
}

} // namespace

ExerciseParameters readObjectHandling(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    for (const Number& key : kNumbers)
        if (parameters.has(QLatin1String(key.name)))
            p.*key.member = parameters.number(QLatin1String(key.name)) / key.perUnit;
    for (const Whole& key : kWholes)
        if (parameters.has(QLatin1String(key.name)))
            p.*key.member = parameters.integer(QLatin1String(key.name));
    if (parameters.has("task"))
        readTask(parameters, p);
    if (parameters.has("organ_bed"))
        p.organBed = parameters.boolean("organ_bed");
    readYield(parameters, p.yield);
    if (parameters.has("object"))
        p.object = readObject(parameters.object("object"));
    if (parameters.has("bed"))
        p.bed = readObject(parameters.object("bed"));
    if (parameters.has("bed_mesh"))
        p.bedMesh = readMesh(parameters.object("bed_mesh"));
    refuseUnknownKeys(parameters, knownKeys(), QStringLiteral("a parameter of object_handling"));
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
