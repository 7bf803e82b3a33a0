// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/comparison_content.h"

#include "catalogue/resolved_level.h"
#include "catalogue/yield_content.h"
#include "simulation/attributes/object_attributes.h"
#include "simulation/comparison/comparison_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ComparisonParameters;
using Object = simulation::ObjectAttributes;

struct Number {
    const char* name;
    double Parameters::*member;
};
constexpr Number kNumbers[] = {
    {"spacing_m", &Parameters::spacing_m},
    {"pad_radius_m", &Parameters::padRadius_m},
    {"pad_edge_m", &Parameters::padEdge_m},
    {"hook_height_m", &Parameters::hookHeight_m},
    {"hook_reach_m", &Parameters::hookReach_m},
    {"hook_leave_m", &Parameters::hookLeave_m},
    {"explore_limit_s", &Parameters::exploreLimit_s},
    {"answer_limit_s", &Parameters::answerLimit_s},
    {"between_trials_s", &Parameters::betweenTrials_s},
    {"maximum_force_N", &Parameters::maximumForce_N},
};

struct Fixed {
    const char* name;
    double Object::*member;
};
constexpr Fixed kFixed[] = {
    {"stiffness_N_per_m", &Object::stiffness_N_per_m},
    {"stiffening_per_m", &Object::stiffening_per_m},
    {"mass_kg", &Object::mass_kg},
    {"recovery_s", &Object::recoveryTime_s},
    {"recovery_share", &Object::recoveryShare},
    {"roughness_m", &Object::roughness_m},
    {"roughness_wavelength_m", &Object::roughnessWavelength_m},
    {"friction", &Object::friction},
    {"bristle_stiffness_N_per_m", &Object::bristleStiffness_N_per_m},
    {"viscosity_Ns_per_m", &Object::viscosity_Ns_per_m},
    {"damping_Ns_per_m", &Object::damping_Ns_per_m},
};

/// Assumption, 37°: a hand that comes from the side, where nothing is compared, meets 1.6 times the stiffness
/// of the top, and two pads do not act together above 7 mm below it. Steeper edges are stiffer, and flatter
/// ones meet earlier.
constexpr double kPadSlope = 0.75;
/// Of a stored session; a hundred times the stiffness of the top is no pad any more.
constexpr double kSteepestPad = 10.0;

constexpr std::array<const char*, 6> kAttributes{"stiffness", "mass",     "deformation",
                                                 "roughness", "friction", "viscosity"};
constexpr std::array<const char*, 4> kControls{"none", "gain", "swapped", "constant"};
constexpr const char* kOthers[] = {"attribute",
                                   "places",
                                   "values",
                                   "arrangements",
                                   "object",
                                   "button_answers",
                                   "button_needs_all",
                                   "probe_at_least_N",
                                   "adjusts",
                                   "control",
                                   "leave_before_again",
                                   "free_first",
                                   "touched_once_lifted",
                                   "pad_slope"};

template <std::size_t N>
int wordOf(const ObjectReader& json, const char* key, const std::array<const char*, N>& words) {
    const std::string word = json.text(QLatin1String(key));
    for (std::size_t i = 0; i < N; ++i)
        if (word == words[i])
            return static_cast<int>(i);
    json.problems().push_back({memberPath(json.path(), QLatin1String(key)),
                               quoted(QString::fromStdString(word)),
                               QStringLiteral("a word this program knows")});
    return 0;
}

template <class Value, class Rows> void readRows(const ObjectReader& json, const char* key, Rows& rows) {
    for (const QJsonValue& row : json.json()[QLatin1String(key)].toArray()) {
        const QJsonArray members = row.toArray();
        if (members.size() != 3) {
            json.problems().push_back({memberPath(json.path(), QLatin1String(key)),
                                       QString::number(members.size()),
                                       QStringLiteral("three numbers a row")});
            return;
        }
        std::array<Value, 3> out{};
        for (qsizetype i = 0; i < 3; ++i)
            out[static_cast<std::size_t>(i)] = static_cast<Value>(members[i].toDouble());
        rows.push_back(out);
    }
}

template <class Rows> QJsonArray rowsJson(const Rows& rows) {
    QJsonArray out;
    for (const auto& row : rows)
        out.append(QJsonArray{row[0], row[1], row[2]});
    return out;
}

Object readAttributes(const ObjectReader& json) {
    Object out;
    std::vector<QString> known;
    for (const Fixed& key : kFixed) {
        known.push_back(QLatin1String(key.name));
        if (json.has(known.back()))
            out.*key.member = json.number(known.back());
    }
    refuseUnknownKeys(json, known, QStringLiteral("a fixed attribute"));
    return out;
}

QJsonObject parametersJson(const Parameters& p) {
    QJsonObject out{{"attribute", kAttributes[static_cast<std::size_t>(p.attribute)]},
                    {"places", p.places},
                    {"values", rowsJson(p.values)},
                    {"arrangements", rowsJson(p.arrangements)},
                    {"button_answers", p.buttonAnswers},
                    {"adjusts", p.adjusts},
                    {"control", kControls[static_cast<std::size_t>(p.control)]}};
    for (const Number& key : kNumbers)
        out[QLatin1String(key.name)] = p.*key.member;
    // Absent in sessions of earlier versions, whose buttons answered at any time.
    if (p.buttonNeedsAll)
        out["button_needs_all"] = true;
    // Absent in sessions of earlier versions, in which any touch counted.
    if (p.probeAtLeast_N > 0.0)
        out["probe_at_least_N"] = p.probeAtLeast_N;
    // Absent in sessions of earlier versions, in which a raised tip could take hold again.
    if (p.leaveBeforeAgain)
        out["leave_before_again"] = true;
    // Absent in sessions of earlier versions, in which an object that was pressed counted as touched.
    if (p.touchedOnceLifted)
        out["touched_once_lifted"] = true;
    // Absent in sessions of earlier versions, whose pads fell off ever more steeply.
    if (p.padSlope > 0.0)
        out["pad_slope"] = p.padSlope;
    // Absent in sessions without a free minute, and in those of earlier versions.
    if (p.freeFirst)
        out["free_first"] = true;
    // Absent where nothing gives way, and in sessions of earlier versions.
    if (std::isfinite(p.yield.force_N)) {
        out[QLatin1String(kYieldForceKey)] = p.yield.force_N;
        out[QLatin1String(kYieldFallKey)] = 1000.0 * p.yield.fall_s;
    }
    QJsonObject object;
    for (const Fixed& key : kFixed)
        object[QLatin1String(key.name)] = p.object.*key.member;
    out["object"] = object;
    return out;
}

const std::vector<ParameterRow<Parameters>>& yieldRows() {
    static const std::vector<ParameterRow<Parameters>> kRows{yieldForceRow<Parameters>(),
                                                             yieldFallRow<Parameters>()};
    return kRows;
}

} // namespace

ExerciseParameters readComparison(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    std::vector<QString> known;
    for (const Number& key : kNumbers) {
        known.push_back(QLatin1String(key.name));
        if (parameters.has(known.back()))
            p.*key.member = parameters.number(known.back());
    }
    for (const char* key : kOthers)
        known.push_back(QLatin1String(key));
    for (const QString& key : keysOf(yieldRows()))
        known.push_back(key);
    p.attribute = static_cast<simulation::ComparedAttribute>(wordOf(parameters, "attribute", kAttributes));
    if (parameters.has("control"))
        p.control = static_cast<simulation::ComparisonControl>(wordOf(parameters, "control", kControls));
    p.places = parameters.integer("places");
    readRows<double>(parameters, "values", p.values);
    readRows<int>(parameters, "arrangements", p.arrangements);
    if (parameters.has("object"))
        p.object = readAttributes(parameters.object("object"));
    if (parameters.has("button_answers"))
        p.buttonAnswers = parameters.boolean("button_answers");
    if (parameters.has("button_needs_all"))
        p.buttonNeedsAll = parameters.boolean("button_needs_all");
    if (parameters.has("probe_at_least_N"))
        p.probeAtLeast_N = parameters.number("probe_at_least_N");
    if (parameters.has("adjusts"))
        p.adjusts = parameters.boolean("adjusts");
    if (parameters.has("leave_before_again"))
        p.leaveBeforeAgain = parameters.boolean("leave_before_again");
    if (parameters.has("touched_once_lifted"))
        p.touchedOnceLifted = parameters.boolean("touched_once_lifted");
    if (parameters.has("pad_slope"))
        p.padSlope = parameters.number("pad_slope");
    if (parameters.has("free_first"))
        p.freeFirst = parameters.boolean("free_first");
    for (const ParameterRow<Parameters>& row : yieldRows())
        if (parameters.has(row.key()))
            row.read(parameters, p);
    refuseUnknownKeys(parameters, known, QStringLiteral("a parameter of comparison"));
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

void checkComparison(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    const auto& p = parameters.as<Parameters>();
    if (p.places < 1 || p.places > Parameters::kMaxPlaces)
        problems.push_back({memberPath(path, "places"), QString::number(p.places), QStringLiteral("1 to 3")});
    if (p.values.empty() || p.values.size() > 4096)
        problems.push_back(
            {memberPath(path, "values"), QString::number(p.values.size()), QStringLiteral("1 to 4096 rows")});
    for (const auto& row : p.values)
        if (!std::all_of(row.begin(), row.end(), [](double v) { return std::isfinite(v) && v > 0.0; })) {
            problems.push_back({memberPath(path, "values"), QStringLiteral("a row"),
                                QStringLiteral("three numbers above 0")});
            break;
        }
    if (!(p.probeAtLeast_N >= 0.0 && p.probeAtLeast_N <= 100.0))
        problems.push_back({memberPath(path, "probe_at_least_N"), QString::number(p.probeAtLeast_N),
                            QStringLiteral("0 to 100 N")});
    if (!(p.padSlope >= 0.0 && p.padSlope <= kSteepestPad))
        problems.push_back({memberPath(path, "pad_slope"), QString::number(p.padSlope),
                            QStringLiteral("0 to %1").arg(kSteepestPad)});
    checkYield(p.yield, p.maximumForce_N, path, problems);
    if (p.arrangements.empty() || p.arrangements.size() > 16)
        problems.push_back({memberPath(path, "arrangements"), QString::number(p.arrangements.size()),
                            QStringLiteral("1 to 16 rows")});
}

std::vector<std::string> fixedAttributeNames() {
    std::vector<std::string> names;
    for (const Fixed& key : kFixed)
        names.emplace_back(key.name);
    return names;
}

core::Result<Object> attributesOf(const std::map<std::string, double>& fixed) {
    Object out;
    for (const auto& [name, value] : fixed) {
        const auto* key = std::find_if(std::begin(kFixed), std::end(kFixed),
                                       [&](const Fixed& k) { return name == k.name; });
        if (key == std::end(kFixed))
            return core::fail(core::ErrorCode::badInput,
                              "fixed attribute \"" + name + "\" is not one that objects have");
        if (!std::isfinite(value) || value < 0.0)
            return core::fail(core::ErrorCode::badInput,
                              "fixed attribute \"" + name + "\": a number of 0 or more is expected");
        out.*key->member = value;
    }
    return out;
}

core::Result<Parameters> comparisonOf(const psychophysics::Condition& condition,
                                      const psychophysics::TrialRules& trial) {
    const auto& stimulus = condition.stimulus;
    if (stimulus.attribute == psychophysics::Attribute::apex)
        return core::fail(core::ErrorCode::badInput,
                          "condition " + condition.id + ": the apex is found in the sphere-apex exercise");
    auto object = attributesOf(stimulus.fixed);
    if (!object)
        return core::fail(core::ErrorCode::badInput,
                          "condition " + condition.id + ": " + object.error().message);
    Parameters p;
    // Both enumerations have the same order.
    p.attribute = static_cast<simulation::ComparedAttribute>(stimulus.attribute);
    p.object = *object;
    p.places = psychophysics::placesOf(condition.task);
    for (const double difference : stimulus.differences)
        p.values.push_back({stimulus.reference, stimulus.reference * std::pow(10.0, difference),
                            stimulus.reference * std::pow(10.0, 2.0 * difference)});
    for (const psychophysics::Places& places : psychophysics::arrangements(condition.task)) {
        std::array<int, 3> row{-1, -1, -1};
        std::copy(places.begin(), places.end(), row.begin());
        p.arrangements.push_back(row);
    }
    p.exploreLimit_s = trial.exploreLimit_s;
    p.answerLimit_s = trial.answerLimit_s;
    p.betweenTrials_s = trial.betweenTrials_s;
    p.adjusts = condition.task == psychophysics::Task::adjustment;
    using psychophysics::Task;
    p.buttonAnswers =
        condition.task == Task::twoAfc || condition.task == Task::threeAfc || condition.task == Task::oddity;
    p.buttonNeedsAll = p.buttonAnswers && trial.mustTouchAll;
    p.probeAtLeast_N = trial.mustTouchAll ? trial.probeAtLeast_N : 0.0;
    p.leaveBeforeAgain = p.attribute == simulation::ComparedAttribute::stiffness;
    p.touchedOnceLifted = p.attribute == simulation::ComparedAttribute::mass;
    if (!simulation::isHooked(p.attribute))
        p.padSlope = kPadSlope;
    // No more is felt than the cap, so nobody who lifts an object and sets it down again gets there.
    if (p.attribute == simulation::ComparedAttribute::mass)
        p.yield.force_N = kLatestYield * p.maximumForce_N;
    if (trial.visibleObjects)
        p.cues = {"object", "tool"};
    return p;
}

ExerciseLevel comparisonLevel(const Parameters& parameters, const std::string& study,
                              const std::string& condition) {
    const QJsonObject exercise{{"id", "comparison"}, {"version", 1}};
    QJsonArray cues;
    for (const std::string& cue : parameters.cues)
        cues.append(QString::fromStdString(cue));
    const QString title = QString::fromStdString(study + " / " + condition);
    const QJsonObject level{{"id", QString::fromStdString(condition)},
                            {"number", 1},
                            {"title", QJsonObject{{"en", title}}},
                            {"objective", QJsonObject{{"en", "A study compares objects."}}},
                            {"measured", QJsonObject{{"en", "Answers and exploration."}}},
                            {"cues", cues},
                            {"needs_force", false},
                            {"metrics", QJsonArray{}},
                            {"gates", QJsonArray{}},
                            {"parameters", parametersJson(parameters)}};
    Problems problems; // none can occur: all of it was written just now
    return levelFromResolved(resolvedDocument(exercise, level), problems);
}

} // namespace chiron::catalogue
