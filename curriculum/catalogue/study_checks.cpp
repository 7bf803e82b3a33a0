// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"
#include "catalogue/study_parts.h"
#include "core/units.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

using psychophysics::Attribute;
using psychophysics::Condition;
using psychophysics::ProcedureScale;
using psychophysics::ProcedureSpec;
using psychophysics::Task;

// The range that the simulation and a desktop device can make use of.
ValueRange valueRange(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return {1.0, 20000.0};
    case Attribute::mass:
        return {0.001, 10.0};
    case Attribute::deformation:
        return {0.001, 100.0};
    case Attribute::roughness:
        return {1e-7, 0.01};
    case Attribute::friction:
        return {0.005, 5.0};
    case Attribute::viscosity:
        return {0.01, 200.0};
    case Attribute::apex:
        return {0.005, 0.045}; // of the sphere that apexOf() makes
    }
    return {};
}

namespace {

QString word(std::string_view token) {
    return QString::fromUtf8(token.data(), static_cast<qsizetype>(token.size()));
}

/// Returns the kinds of procedure that can drive a task, with the kinds recommended for it first. A kind can
/// drive a task if it takes the task's outcome.
QStringList drivingKinds(Task task) {
    std::vector<const psychophysics::ProcedureKind*> kinds;
    for (const psychophysics::ProcedureKind* kind : psychophysics::procedureKinds())
        if (kind->drives(task))
            kinds.push_back(kind);
    std::stable_sort(kinds.begin(), kinds.end(), [task](const auto* a, const auto* b) {
        return a->recommended(task) > b->recommended(task);
    });
    QStringList ids;
    for (const psychophysics::ProcedureKind* kind : kinds)
        ids << word(kind->id());
    return ids;
}

void checkTask(const Condition& condition, const QString& path, Problems& problems) {
    for (std::size_t i = 0; i < condition.procedures.size(); ++i) {
        const QString at = elementPath(memberPath(path, "procedures"), static_cast<qsizetype>(i));
        const psychophysics::ProcedureKind& kind = psychophysics::kindFor(condition.procedures[i]);
        if (!kind.drives(condition.task))
            problems.push_back({memberPath(at, "kind"), quoted(word(kind.id())),
                                QStringLiteral("for the task %1 one of %2")
                                    .arg(word(psychophysics::token(condition.task)),
                                         drivingKinds(condition.task).join(", "))});
        else if (const auto fault = kind.faultFor(condition.procedures[i], condition.task))
            problems.push_back({memberPath(at, word(fault->key)), word(fault->found), word(fault->expected)});
    }
    if (condition.stimulus.attribute == Attribute::apex && condition.task != Task::adjustment)
        problems.push_back({memberPath(path, "task"), quoted(word(psychophysics::token(condition.task))),
                            QStringLiteral("adjustment: the apex is pointed at")});
}

// Checks that every level named by a procedure is in the range that can be presented.
void checkLevels(const Condition& condition, const QString& path, Problems& problems) {
    const auto& table = condition.stimulus.differences;
    const bool logarithm = condition.scale == ProcedureScale::logDifference;
    if ((logarithm && table.front() <= 0.0))
        return;
    constexpr double kSlack = 1e-9; // levels that are written as logarithms are rounded
    const double lowest = logarithm ? std::log10(table.front()) : table.front();
    const double highest = logarithm ? std::log10(table.back()) : table.back();
    for (std::size_t i = 0; i < condition.procedures.size(); ++i) {
        const QString at = elementPath(memberPath(path, "procedures"), static_cast<qsizetype>(i));
        const auto inside = [&](const QString& key, const std::vector<double>& levels) {
            const auto outside = std::find_if(levels.begin(), levels.end(), [&](double x) {
                return x < lowest - kSlack || x > highest + kSlack;
            });
            if (outside != levels.end())
                problems.push_back(
                    {memberPath(at, key), QString::number(*outside),
                     QStringLiteral("%1 to %2, as the table of differences has").arg(lowest).arg(highest)});
        };
        const ProcedureSpec& spec = condition.procedures[i];
        const psychophysics::ProcedureKind& kind = psychophysics::kindFor(spec);
        for (const psychophysics::Parameter& row : kind.rows())
            if (row.inTable)
                inside(word(row.key), std::get<std::vector<double>>(row.get(spec)));
        if (kind.onlyScale().value_or(condition.scale) != condition.scale)
            problems.push_back(
                {memberPath(path, "scale"),
                 quoted(logarithm ? QStringLiteral("log_difference") : QStringLiteral("difference")),
                 QStringLiteral("%1 for %2")
                     .arg(logarithm ? "difference" : "log_difference", word(kind.id()))});
    }
}

} // namespace

bool takesBothSides(psychophysics::Task task) noexcept {
    return task == Task::twoAfc || task == Task::yesNo || task == Task::adjustment || task == Task::magnitude;
}

double middleReference(const Condition& condition) {
    const ValueRange range = valueRange(condition.stimulus.attribute);
    const double multiple = psychophysics::ranksThree(condition.task) ? 2.0 : 1.0;
    const auto& differences = condition.stimulus.differences;
    const double below = differences.empty() ? 0.0 : std::min(0.0, multiple * differences.front());
    const double above = differences.empty() ? 0.0 : std::max(0.0, multiple * differences.back());
    return std::sqrt(range.lowest * std::pow(10.0, -below) * range.highest * std::pow(10.0, -above));
}

void checkTable(const Condition& condition, const QString& path, Problems& problems) {
    const QString stimulus = memberPath(path, "stimulus");
    const QString at = elementPath(memberPath(stimulus, "differences"), 0);
    const auto& differences = condition.stimulus.differences;
    const double first = differences.front();
    if (condition.scale == ProcedureScale::logDifference && first <= 0.0)
        problems.push_back(
            {at, QString::number(first), QStringLiteral("more than 0: the scale takes its logarithm")});
    else if (!takesBothSides(condition.task) && first <= 0.0)
        problems.push_back(
            {at, QString::number(first),
             QStringLiteral("more than 0 for the task %1").arg(word(psychophysics::token(condition.task)))});
    const ValueRange range = valueRange(condition.stimulus.attribute);
    const double reference = condition.stimulus.reference;
    const QString expected = QStringLiteral("%1 to %2 %3")
                                 .arg(range.lowest)
                                 .arg(range.highest)
                                 .arg(word(psychophysics::unitOf(condition.stimulus.attribute)));
    if (!(reference >= range.lowest && reference <= range.highest)) {
        problems.push_back({memberPath(stimulus, "reference"), QString::number(reference), expected});
        return;
    }
    const double multiple = psychophysics::ranksThree(condition.task) ? 2.0 : 1.0;
    for (const std::size_t i : {std::size_t{0}, differences.size() - 1}) {
        const double value = reference * std::pow(10.0, multiple * differences[i]);
        if (!(value >= range.lowest && value <= range.highest))
            problems.push_back({elementPath(memberPath(stimulus, "differences"), static_cast<qsizetype>(i)),
                                QStringLiteral("an object of %1").arg(value), expected});
    }
}

void checkProbe(const psychophysics::StudyDesign& design, const QString& path, Problems& problems) {
    const double probe_N = design.trial.probeAtLeast_N;
    if (probe_N <= 0.0)
        return;
    if (probe_N >= design.fidelity.peakForce_N) {
        problems.push_back({path, QString::number(probe_N),
                            QStringLiteral("less than the largest force of a trial, %1 N")
                                .arg(design.fidelity.peakForce_N)});
        return;
    }
    for (const Condition& condition : design.conditions) {
        const auto& stimulus = condition.stimulus;
        if (stimulus.attribute != Attribute::mass || stimulus.differences.empty())
            continue; // other objects push back as hard as the person presses or pulls
        const double multiple = psychophysics::ranksThree(condition.task) ? 2.0 : 1.0;
        const double lightest_N = core::kStandardGravity * stimulus.reference *
                                  std::pow(10.0, std::min(0.0, multiple * stimulus.differences.front()));
        if (probe_N > lightest_N)
            problems.push_back({path, QString::number(probe_N),
                                QStringLiteral("at most %1 N, which is what the lightest object weighs")
                                    .arg(lightest_N, 0, 'g', 3)});
    }
}

void checkCondition(const Condition& condition, const QString& path, Problems& problems) {
    checkTask(condition, path, problems);
    checkTable(condition, path, problems);
    checkLevels(condition, path, problems);
}

} // namespace chiron::catalogue
