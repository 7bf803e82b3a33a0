// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/apex_output.h"
#include "cli/study/study_access.h"
#include "cli/text_table.h"
#include "session/study/study_analysis.h"
#include "session_report/group_words.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::cli {

namespace {

using psychophysics::GroupEstimate;

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QJsonValue number(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

QJsonArray interval(const psychophysics::Interval& ends) {
    return {number(ends.low), number(ends.high)};
}

QJsonObject replayedJson(const session::ReplayedChoices& r) {
    return {{"trials", r.trials},
            {"same", r.same},
            {"ties", r.ties},
            {"first_difference", r.firstDifference},
            {"same_procedures", r.sameProcedures},
            {"identical", r.identical()}};
}

/// Omits physical units and methods while the study is blinded.
QJsonObject groupJson(const GroupEstimate& g, bool blinded) {
    QJsonObject json{{"weber", number(g.weber)},
                     {"ci_low", number(g.weber95.low)},
                     {"ci_high", number(g.weber95.high)},
                     {"bootstrap", interval(g.bootstrap95)},
                     {"prediction", interval(g.prediction95)},
                     {"sigma_log10", number(g.sigma_log10)},
                     {"sd_between_log10", number(g.sdBetweenLog10)},
                     {"i_squared", number(g.iSquared)},
                     {"heterogeneity_p", number(g.heterogeneityP)},
                     {"participants", g.participants},
                     {"left_out", g.leftOut},
                     {"warnings", warningsJson(g.warnings, blinded)}};
    if (blinded)
        return json;
    json.insert("jnd", number(g.jnd));
    json.insert("unit", text(g.unit));
    json.insert("method", text(g.method));
    json.insert("pse", number(g.pse));
    json.insert("pse_ci", interval(g.pse95));
    json.insert("exponent", number(g.exponent));
    json.insert("exponent_ci", interval(g.exponent95));
    return json;
}

/// The quality of the trials per participant; available also while the study is blinded.
QJsonArray qualityJson(const session::StudyAnalysis& analysis) {
    // Keyed by code, so that the order of enrolment cannot be seen.
    std::map<QString, QJsonObject> rows;
    for (const auto& [participant, code] : analysis.codes)
        for (const database::ParticipantQuality& q : analysis.quality) {
            if (q.participant != participant)
                continue;
            const auto count = [&](int n) { return q.whole ? QJsonValue(n) : QJsonValue(QJsonValue::Null); };
            QJsonObject reasons;
            for (const auto& [reason, times] : q.spoiled)
                reasons.insert(text(reason), times);
            rows[text(code)] = {
                {"participant", text(code)},
                {"conditions_done", q.conditionsDone},
                {"conditions", q.conditions},
                {"late_ticks", number(q.lateTicks)},
                {"worst_lateness_us", number(q.worstLateness_us)},
                {"device", q.device.empty() ? QJsonValue(QJsonValue::Null) : QJsonValue(text(q.device))},
                {"force_class", forceClassJson(q.felt)},
                {"presentations", count(q.presentations)},
                {"practice", count(q.practice)},
                {"scored", count(q.scored)},
                {"repeated", q.whole ? QJsonValue(reasons) : QJsonValue(QJsonValue::Null)},
                {"exploration_s", number(q.exploration_s)}};
        }
    QJsonArray list;
    for (const auto& [code, row] : rows)
        list.append(row);
    return list;
}

/// The id of a condition, or its sealed code.
QString labelOf(const session::AnalysedCondition& condition) {
    return text(condition.condition);
}

struct Told {
    QJsonArray runs, conditions;
    TextTable table{{"participant", "condition", ">trials", ">Weber", ">low", ">high", ">prior's part",
                     ">same choices", "in the group", "warnings"}};
    TextTable marks = apexTable(false); ///< for conditions in which the participants look for an apex
    QString statements;                 ///< for each condition, the runs on which its group value is based
    bool compared = false, marked = false;
};

void tellRuns(Told& told, const session::AnalysedCondition& condition, const QString& label, bool blinded) {
    std::map<std::string, int> counts;
    for (const session::AnalysedRun& run : condition.runs) {
        const psychophysics::RunEstimate& e = run.estimate;
        QJsonObject json{{"participant", text(run.participant.code)},
                         {"condition", label},
                         {"run", ++counts[run.participant.code]},
                         {"simulated", run.participant.simulated},
                         {"estimate", estimateJson(e, blinded)},
                         {"replayed", replayedJson(run.replayed)},
                         {"force_class", forceClassJson(run.felt)},
                         {"in_group", run.presence == session::Presence::used},
                         {"group_use", text(std::string(session::presenceToken(run.presence)))}};
        if (run.apex)
            json.insert("apex", apexJson(*run.apex, blinded));
        told.runs.append(json);
        if (run.apex) {
            told.marked = true;
            addApexRow(told.marks, text(run.participant.code), label, *run.apex, blinded);
            continue;
        }
        told.compared = true;
        told.table.add(
            {text(run.participant.code), label,
             hasWarning(e.warnings, psychophysics::WarningKind::sealed) ? QStringLiteral("sealed")
                                                                        : QString::number(e.trials),
             session_report::markedValue(shortNumber(e.weber), e), shortNumber(e.weber95.low),
             shortNumber(e.weber95.high), shortNumber(e.priorInfluence),
             QStringLiteral("%1/%2").arg(run.replayed.same + run.replayed.ties).arg(run.replayed.trials),
             session_report::presenceWords(run.presence), warningTokens(e.warnings)});
    }
}

void tellGroup(Told& told, const session::AnalysedCondition& condition, const QString& label, bool blinded) {
    const GroupEstimate& g = condition.group;
    int same = 0, trials = 0;
    for (const session::AnalysedRun& run : condition.runs) {
        same += run.replayed.same + run.replayed.ties;
        trials += run.replayed.trials;
    }
    QJsonObject json{{"condition", label},
                     {"group", groupJson(g, blinded)},
                     {"statement", QJsonArray::fromStringList(
                                       session_report::groupSentences(condition.roll, QLocale::c()))},
                     {"replayed", QJsonObject{{"trials", trials}, {"same", same}}}};
    if (condition.apex)
        json.insert("apex", apexJson(*condition.apex, blinded));
    told.conditions.append(json);
    if (condition.apex) {
        addApexRow(told.marks, QStringLiteral("(group of %1)").arg(condition.apex->participants), label,
                   *condition.apex, blinded);
        return;
    }
    told.table.add({QStringLiteral("(group of %1)").arg(g.participants), label, QString(),
                    shortNumber(g.weber), shortNumber(g.weber95.low), shortNumber(g.weber95.high), QString(),
                    QStringLiteral("%1/%2").arg(same).arg(trials), QString(), warningTokens(g.warnings)});
}

QJsonObject comparisonJson(const session::ComparedConditions& each, const QString& first,
                           const QString& second) {
    const psychophysics::ConditionComparison& c = each.weber;
    QJsonObject json{{"condition_a", first},
                     {"condition_b", second},
                     {"ratio", number(c.ratio)},
                     {"ci_low", number(c.ratio95.low)},
                     {"ci_high", number(c.ratio95.high)},
                     {"p", number(c.pValue)},
                     {"p_holm", number(c.pHolm)},
                     {"paired", c.paired},
                     {"n", c.participants},
                     {"n_a", c.first},
                     {"n_b", c.second},
                     {"bootstrap", interval(c.bootstrap95)},
                     {"sd_between_log10", number(c.sdBetweenLog10)},
                     {"warnings", warningsJson(c.warnings, false)}};
    if (each.models.participants > 0)
        json.insert("threshold_models", QJsonObject{{"likelihood_ratio", number(each.models.likelihoodRatio)},
                                                    {"degrees_of_freedom", each.models.freedom},
                                                    {"p", number(each.models.pValue)},
                                                    {"aic_difference", number(each.models.aicDifference)},
                                                    {"participants", each.models.participants}});
    return json;
}

QString pWords(double p) {
    return !std::isfinite(p) ? QString() : p < 0.001 ? QStringLiteral("< 0.001") : QString::number(p, 'f', 3);
}

/// The ratios of Weber fractions, the second condition's divided by the first's.
QString tellComparisons(const session::StudyAnalysis& analysis, QJsonArray& array) {
    const bool thresholds = session::testsThresholds(analysis.comparisons);
    QStringList headings{"condition A", "condition B", ">B/A", ">low", ">high", ">p", ">p (Holm)", "people"};
    if (thresholds)
        headings << ">p of two thresholds";
    headings << "warnings";
    TextTable table(headings);
    for (const session::ComparedConditions& each : analysis.comparisons) {
        const QString first = labelOf(analysis.conditions[each.first]),
                      second = labelOf(analysis.conditions[each.second]);
        array.append(comparisonJson(each, first, second));
        const psychophysics::ConditionComparison& c = each.weber;
        QStringList cells{first,
                          second,
                          shortNumber(c.ratio),
                          shortNumber(c.ratio95.low),
                          shortNumber(c.ratio95.high),
                          pWords(c.pValue),
                          pWords(c.pHolm),
                          c.paired ? QStringLiteral("%1 in both").arg(c.participants)
                                   : QStringLiteral("two groups: %1 and %2").arg(c.first).arg(c.second)};
        if (thresholds)
            cells << pWords(each.models.pValue);
        table.add(cells << warningTokens(c.warnings));
    }
    return analysis.comparisons.empty() ? QString() : QStringLiteral("\n") + table.toText();
}

/// For conditions whose Weber fractions are compared: why some pairs are not compared, and which participants
/// are in no comparison.
QStringList missingComparisons(const session::StudyAnalysis& analysis) {
    const bool marks = std::any_of(analysis.conditions.begin(), analysis.conditions.end(),
                                   [](const auto& each) { return each.apex.has_value(); });
    if (analysis.blind() || marks)
        return {};
    std::vector<session::GroupRoll> rolls;
    for (const session::AnalysedCondition& condition : analysis.conditions)
        rolls.push_back(condition.roll);
    return session_report::comparisonSentences(
        rolls, analysis.comparisons, [&](std::size_t at) { return labelOf(analysis.conditions[at]); },
        QLocale::c());
}

void tellStatement(Told& told, const session::AnalysedCondition& condition) {
    for (const QString& sentence : session_report::groupSentences(condition.roll, QLocale::c()))
        told.statements += QStringLiteral("%1: %2\n").arg(labelOf(condition), sentence);
}

} // namespace

core::Result<CommandOutput> analyseStudies(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    const std::string& sha256 = study->record.summary.sha256;
    if (sha256.empty())
        return core::fail(core::ErrorCode::wrongUse, "study \"" + study->record.summary.key +
                                                         "\": a draft has no data; expected a frozen study");
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(seed);
    database::StudyReader reader = study->reader();
    auto analysis = session::analyseStudy(reader, study->number(), *seed,
                                          {.withShown = arguments.has(QStringLiteral("with-shown"))});
    CHIRON_TRY(analysis);
    const bool blinded = analysis->blind();
    QJsonArray comparisons;
    const QString compared = tellComparisons(*analysis, comparisons);
    const QStringList missing = missingComparisons(*analysis);
    Told told;
    told.marks = apexTable(blinded);
    auto& conditions = analysis->conditions;
    for (const session::AnalysedCondition& condition : conditions)
        if (!blinded && condition.runs.empty())
            tellStatement(told, condition);
    std::erase_if(conditions, [](const auto& each) { return each.runs.empty(); });
    // Neither the order of the design nor that of enrolment may show.
    if (blinded)
        std::sort(conditions.begin(), conditions.end(),
                  [](const auto& a, const auto& b) { return labelOf(a) < labelOf(b); });
    for (const session::AnalysedCondition& condition : conditions) {
        tellStatement(told, condition);
        tellRuns(told, condition, labelOf(condition), blinded);
        tellGroup(told, condition, labelOf(condition), blinded);
    }
    return CommandOutput{
        QJsonDocument(QJsonObject{{"study", text(study->record.summary.key)},
                                  {"sha256", text(sha256)},
                                  {"blinded", blinded},
                                  {"conditions", told.conditions},
                                  {"comparisons", comparisons},
                                  {"not_compared", QJsonArray::fromStringList(missing)},
                                  {"rule", session_report::groupRule()},
                                  {"runs", told.runs},
                                  {"quality", qualityJson(*analysis)}}),
        (told.compared || !told.marked ? told.table.toText() : QString()) +
            (told.marked ? told.marks.toText() : QString()) + QStringLiteral("\n") +
            session_report::groupRule() + QLatin1Char('\n') + told.statements + compared +
            (missing.isEmpty() ? QString()
                               : QStringLiteral("\n") + missing.join(QLatin1Char('\n')) + QLatin1Char('\n')),
        0};
}

} // namespace chiron::cli
