// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/level_checks.h"

#include "catalogue/exercise_contents.h"
#include "scoring/metric_catalogue.h"
#include "simulation/scene_parameters.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>

namespace chiron::catalogue {

namespace {

QString listPlace(const char* list, std::size_t index, const char* key) {
    return memberPath(elementPath(memberPath(QStringLiteral("$"), list), static_cast<qsizetype>(index)), key);
}

void checkMetrics(const ExerciseLevel& level, Problems& problems) {
    std::vector<QString> known;
    for (const auto& metric : scoring::metricCatalogue())
        known.push_back(QString::fromUtf8(metric.id.data(), static_cast<qsizetype>(metric.id.size())));
    for (std::size_t i = 0; i < level.metrics.size(); ++i) {
        const MetricChoice& choice = level.metrics[i];
        const QString id = QString::fromStdString(choice.id);
        if (scoring::findMetric(choice.id) == nullptr)
            problems.push_back({listPlace("metrics", i, "id"), quoted(id),
                                QStringLiteral("a metric of the catalogue") + didYouMean(id, known)});
        else if (scoring::findMetric(choice.id, choice.version) == nullptr)
            problems.push_back({listPlace("metrics", i, "version"), QString::number(choice.version),
                                QStringLiteral("a version of %1, the newest is %2")
                                    .arg(id)
                                    .arg(scoring::findMetric(choice.id)->version)});
        for (std::size_t k = 0; k < i; ++k)
            if (level.metrics[k].id == choice.id)
                problems.push_back(
                    {listPlace("metrics", i, "id"), quoted(id), QStringLiteral("each metric once")});
    }
}

void checkGates(const ExerciseLevel& level, const QJsonArray& json, Problems& problems) {
    for (std::size_t i = 0; i < level.gates.size(); ++i) {
        const scoring::Gate& gate = level.gates[i];
        const auto metric =
            std::find_if(level.metrics.begin(), level.metrics.end(),
                         [&](const MetricChoice& choice) { return choice.id == gate.metric; });
        if (metric == level.metrics.end()) {
            problems.push_back({listPlace("gates", i, "metric"), quoted(QString::fromStdString(gate.metric)),
                                QStringLiteral("one of the level's own metrics")});
            continue;
        }
        const auto* definition = scoring::findMetric(metric->id, metric->version);
        const QString unit = json[static_cast<qsizetype>(i)].toObject()["unit"].toString();
        if (definition != nullptr && unit.toStdString() != definition->unit)
            problems.push_back({listPlace("gates", i, "unit"), quoted(unit),
                                QStringLiteral("the metric's unit, %1")
                                    .arg(quoted(QString::fromStdString(std::string(definition->unit))))});
        if (!gate.minimum && !gate.maximum)
            problems.push_back({listPlace("gates", i, "maximum"), QStringLiteral("missing"),
                                QStringLiteral("minimum or maximum or both")});
        if (gate.minimum && gate.maximum && *gate.minimum > *gate.maximum)
            problems.push_back({listPlace("gates", i, "minimum"), QString::number(*gate.minimum),
                                QStringLiteral("at most the maximum, %1").arg(*gate.maximum)});
        for (std::size_t k = 0; k < i; ++k)
            if (level.gates[k].metric == gate.metric)
                problems.push_back({listPlace("gates", i, "metric"),
                                    quoted(QString::fromStdString(gate.metric)),
                                    QStringLiteral("each metric gated once")});
    }
}

/// Checks the mounting. If the scripted operators of an exercise take the device's frame D for W, its devices
/// cannot be mounted anywhere else.
void checkMounting(const ExerciseLevel& level, Problems& problems) {
    if (level.mounting.empty())
        return;
    const ExerciseContent* content = findExerciseContent(level.exercise);
    const int most =
        content != nullptr && content->mountable != nullptr ? content->mountable(level.parameters) : 0;
    const auto given = static_cast<int>(level.mounting.size());
    if (most == 0)
        problems.push_back({QStringLiteral("$.mounting"), QStringLiteral("given"),
                            QStringLiteral("none: the devices of %1 stand as they are built")
                                .arg(QString::fromStdString(level.exercise))});
    else if (given > most)
        problems.push_back({QStringLiteral("$.mounting"), QStringLiteral("%1 bases").arg(given),
                            QStringLiteral("at most one for each of the level's %1 instruments").arg(most)});
}

} // namespace

void checkLevel(const ExerciseLevel& level, const QJsonObject& json, Problems& problems) {
    checkMetrics(level, problems);
    checkGates(level, json["gates"].toArray(), problems);
    checkMounting(level, problems);
    if (!simulation::hasCue(level.cues, "object") && !level.needsForce)
        problems.push_back(
            {QStringLiteral("$.needs_force"), QStringLiteral("false"),
             QStringLiteral("true, since the cue object is off and nothing else tells where it is")});
    if (level.shownForce && !level.needsForce)
        problems.push_back({QStringLiteral("$.shown_force_variant"), QStringLiteral("given"),
                            QStringLiteral("none: the level runs without force as it is")});
    if (level.shownForce && simulation::hasCue(level.shownForce->cues, "object") &&
        !simulation::hasCue(level.cues, "object"))
        problems.push_back({QStringLiteral("$.shown_force_variant.cues"), QStringLiteral("\"object\""),
                            QStringLiteral("cues that show force, not the object")});
}

} // namespace chiron::catalogue
