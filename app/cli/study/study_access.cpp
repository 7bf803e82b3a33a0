// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/study_access.h"

#include "cli/cli_errors.h"

#include <QJsonArray>
#include <array>
#include <cmath>

namespace chiron::cli {

core::Result<database::StudyRecord> findStudy(database::StudyReader reader, const QString& name) {
    bool isNumber = false;
    const qint64 number = name.toLongLong(&isNumber);
    return isNumber ? reader.study(number) : reader.studyByKey(name.toStdString());
}

core::Result<StudySite> openStudy(const Arguments& arguments, Opening opening) {
    auto site =
        opening == Opening::forWriting ? openAsPerson(arguments, opening) : openAsAnybody(arguments, opening);
    CHIRON_TRY(site);
    auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    auto record = findStudy(database::StudyReader(**connection, site->actor), arguments.operand(0));
    CHIRON_TRY(record);
    return StudySite{std::move(*site), std::move(*connection), std::move(*record)};
}

QString stateWord(database::StudyState state) {
    constexpr std::array<const char*, 4> words{"draft", "frozen", "closed", "archived"};
    return QLatin1String(words[static_cast<std::size_t>(state)]);
}

QJsonObject studyJson(const database::StudySummary& s) {
    return {{"id", static_cast<qint64>(s.id)},
            {"key", QString::fromStdString(s.key)},
            {"title", QString::fromStdString(s.title)},
            {"state", stateWord(s.state)},
            {"sha256", QString::fromStdString(s.sha256)},
            {"unblinded", s.unblinded},
            {"created_utc", QString::fromStdString(s.createdUtc)},
            {"frozen_utc", QString::fromStdString(s.frozenUtc)},
            {"participants", s.participants},
            {"completed", s.completed},
            {"trials", s.trials}};
}

QJsonArray warningsJson(const std::vector<psychophysics::Warning>& warnings, bool tokensAlone) {
    QJsonArray array;
    for (const psychophysics::Warning& warning : warnings)
        array.append(tokensAlone ? QString::fromUtf8(warningToken(warning.kind))
                                 : QString::fromStdString(warningText(warning)));
    return array;
}

QString warningTokens(const std::vector<psychophysics::Warning>& warnings) {
    QStringList tokens;
    for (const psychophysics::Warning& warning : warnings)
        tokens << QString::fromUtf8(warningToken(warning.kind));
    tokens.removeDuplicates(); // both ends of an interval may be the prior's
    return tokens.join(QStringLiteral(", "));
}

QJsonObject estimateJson(const psychophysics::RunEstimate& e, bool blinded) {
    const auto number = [](double value) {
        return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
    };
    QJsonObject json{{"weber", number(e.weber)},
                     {"sigma_log10", number(e.sigma_log10)},
                     {"prior_influence", number(e.priorInfluence)},
                     {"ci_low", number(e.weber95.low)},
                     {"ci_high", number(e.weber95.high)},
                     {"trials", hasWarning(e.warnings, psychophysics::WarningKind::sealed)
                                    ? QJsonValue(QJsonValue::Null)
                                    : QJsonValue(e.trials)},
                     {"warnings", warningsJson(e.warnings, blinded)}};
    if (blinded)
        return json;
    json.insert("criterion", e.criterion);
    json.insert("method", QString::fromUtf8(methodText(e.method)));
    json.insert("jnd", number(e.jnd));
    json.insert("unit", QString::fromStdString(e.unit));
    json.insert("pse", number(e.pse));
    json.insert("tie", number(e.tie));
    json.insert("tie_ci", QJsonArray{number(e.tie95.low), number(e.tie95.high)});
    json.insert("exponent", number(e.exponent));
    json.insert("exponent_ci", QJsonArray{number(e.exponent95.low), number(e.exponent95.high)});
    return json;
}

QJsonValue forceClassJson(const std::optional<bool>& felt) {
    return felt ? QJsonValue(*felt ? QStringLiteral("felt") : QStringLiteral("shown"))
                : QJsonValue(QJsonValue::Null);
}

QJsonObject participantJson(const database::Participant& p) {
    constexpr std::array<const char*, 4> words{"enrolled", "consented", "completed", "withdrawn"};
    return {{"code", QString::fromStdString(p.code)},
            {"order", p.order},
            {"state", QLatin1String(words[static_cast<std::size_t>(p.state)])},
            {"simulated", p.simulated},
            {"observer", QString::fromStdString(p.observer)},
            {"consented", !p.consentUtc.empty()}};
}

} // namespace chiron::cli
