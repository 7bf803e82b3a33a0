// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/catalogue/palpation_content.h"

#include "catalogue/tissue_content.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/tissue_pinch.h"

#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::PalpationParameters;
using Control = simulation::PalpationControl;

constexpr double kMm = 1e3;

struct Number {
    const char* name;
    double Parameters::*member;
    double perUnit; ///< content units per SI unit
};

struct Whole {
    const char* name;
    int Parameters::*member;
};

struct Flag {
    const char* name;
    bool Parameters::*member;
};

constexpr Number kNumbers[] = {
    {"depth_spread_mm", &Parameters::depthSpread_m, kMm},
    {"spacing_mm", &Parameters::spacing_m, kMm},
    {"hit_radius_mm", &Parameters::hitRadius_m, kMm},
    {"band_low_N", &Parameters::bandLow_N, 1.0},
    {"band_high_N", &Parameters::bandHigh_N, 1.0},
    {"cover_force_N", &Parameters::coverForce_N, 1.0},
    {"finger_spacing_mm", &Parameters::fingerSpacing_m, kMm},
    {"trial_limit_s", &Parameters::trialLimit_s, 1.0},
    {"between_trials_s", &Parameters::betweenTrials_s, 1.0},
    {"maximum_force_N", &Parameters::maximumForce_N, 1.0},
};

constexpr Whole kWholes[] = {
    {"lumps_low", &Parameters::lumpsLow},       {"lumps_high", &Parameters::lumpsHigh},
    {"catch_trials", &Parameters::catchTrials}, {"region_columns", &Parameters::regionColumns},
    {"region_rows", &Parameters::regionRows},   {"hands", &Parameters::hands},
    {"fingers", &Parameters::fingers},          {"trials", &Parameters::trials},
};

constexpr Flag kFlags[] = {
    {"lump_first", &Parameters::lumpFirst},
    {"asks_size", &Parameters::asksSize},
    {"asks_hardness", &Parameters::asksHardness},
    {"asks_confidence", &Parameters::asksConfidence},
};

constexpr const char* kOthers[] = {"tissue",
                                   "lump_kinds",
                                   "area_half_x_mm",
                                   "area_half_y_mm",
                                   "control_force_off",
                                   "control_move_after_s",
                                   "control_move_x_mm",
                                   "control_move_y_mm",
                                   "yield_force_N",
                                   "yield_fall_ms",
                                   "pinch",
                                   "jaw_length_mm",
                                   "jaw_friction"};

void take(const ObjectReader& json, const char* key, double& out, double perUnit) {
    if (json.has(QLatin1String(key)))
        out = json.number(QLatin1String(key)) / perUnit;
}

void readKinds(const ObjectReader& parameters, Parameters& p) {
    p.kinds.clear();
    parameters.eachObject("lump_kinds", [&](const ObjectReader& one) {
        simulation::LumpKind kind;
        kind.radius_m = one.number("radius_mm") / kMm;
        kind.depth_m = one.number("depth_mm") / kMm;
        kind.ratio = one.number("ratio");
        kind.hardness = one.integer("hardness");
        refuseUnknownKeys(one, {"radius_mm", "depth_mm", "ratio", "hardness"},
                          QStringLiteral("a number of a lump"));
        p.kinds.push_back(kind);
    });
}

std::optional<simulation::PinchParameters> readPinch(const ObjectReader& parameters) {
    if (!parameters.has("pinch") || !parameters.boolean("pinch"))
        return std::nullopt;
    simulation::PinchParameters pinch;
    take(parameters, "jaw_length_mm", pinch.jawLength_m, kMm);
    take(parameters, "jaw_friction", pinch.friction, 1.0);
    return pinch;
}

Control readControl(const ObjectReader& parameters) {
    Control control;
    if (parameters.has("control_force_off"))
        control.forceOff = parameters.boolean("control_force_off");
    take(parameters, "control_move_after_s", control.moveAfter_s, 1.0);
    take(parameters, "control_move_x_mm", control.move_m.x(), kMm);
    take(parameters, "control_move_y_mm", control.move_m.y(), kMm);
    return control;
}

std::vector<QString> knownKeys() {
    std::vector<QString> known;
    for (const Number& key : kNumbers)
        known.push_back(QLatin1String(key.name));
    for (const Whole& key : kWholes)
        known.push_back(QLatin1String(key.name));
    for (const Flag& key : kFlags)
        known.push_back(QLatin1String(key.name));
    for (const char* key : kOthers)
        known.push_back(QLatin1String(key));
    return known;
}

} // namespace

ExerciseParameters readPalpation(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    for (const Number& key : kNumbers)
        take(parameters, key.name, p.*key.member, key.perUnit);
    if (parameters.has("yield_force_N"))
        if (const double yields_N = parameters.number("yield_force_N"); yields_N > 0.0) // 0: never yields
            p.yield.force_N = yields_N;
    take(parameters, "yield_fall_ms", p.yield.fall_s, 1e3);
    for (const Whole& key : kWholes)
        if (parameters.has(QLatin1String(key.name)))
            p.*key.member = parameters.integer(QLatin1String(key.name));
    for (const Flag& key : kFlags)
        if (parameters.has(QLatin1String(key.name)))
            p.*key.member = parameters.boolean(QLatin1String(key.name));
    take(parameters, "area_half_x_mm", p.areaHalf_m.x(), kMm);
    take(parameters, "area_half_y_mm", p.areaHalf_m.y(), kMm);
    if (parameters.has("tissue"))
        p.tissue = readTissue(parameters.object("tissue"));
    if (parameters.has("lump_kinds"))
        readKinds(parameters, p);
    p.pinch = readPinch(parameters);
    p.control = readControl(parameters);
    refuseUnknownKeys(parameters, knownKeys(), QStringLiteral("a parameter of palpation"));
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
