// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/psychophysics/adaptive_lines.h"

#include "cli/cli_errors.h"
#include "psychophysics/study/arrangement.h"

#include <QJsonArray>
#include <algorithm>
#include <cmath>

namespace chiron::cli {

namespace {

using namespace psychophysics;

QString expected(int outcomes, bool orders) {
    if (orders)
        return outcomes == kRankings
                   ? QStringLiteral(
                         "an order such as b<a<c or b<a=c, an outcome from 0 to 12, undo or spoiled")
                   : QStringLiteral("an order such as b<a<c, an outcome from 0 to 5, undo or spoiled");
    return outcomes == 2 ? QStringLiteral("0, 1, undo or spoiled")
                         : QStringLiteral("an outcome from 0 to %1, undo or spoiled").arg(outcomes - 1);
}

core::Result<Stimulus> presentedOf(const QStringList& words, std::size_t dimensions) {
    Stimulus stimulus;
    for (const QString& word : words) {
        bool ok = false;
        const double value = word.toDouble(&ok);
        if (!ok || !std::isfinite(value))
            return badInput(
                QStringLiteral("%1: expected the stimulus presented, a number").arg(quoted(word)));
        stimulus.push_back(value);
    }
    if (stimulus.size() != dimensions)
        return badInput(
            QStringLiteral("%1 numbers after the response: expected none, or the stimulus presented (%2)")
                .arg(words.size())
                .arg(dimensions));
    return stimulus;
}

QJsonValue finite(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

QJsonObject procedureEstimateJson(const ProcedureEstimate& estimate) {
    QJsonObject json{{"known", estimate.known}, {"method", QString::fromStdString(estimate.method)}};
    for (const NamedEstimate& parameter : estimate.parameters) {
        const QString name = QString::fromStdString(parameter.name);
        json.insert(name, finite(parameter.mean));
        json.insert(name + "_sd", finite(parameter.sd));
        json.insert(name + "_low", finite(parameter.low));
        json.insert(name + "_high", finite(parameter.high));
    }
    QJsonArray warnings;
    for (const std::string& warning : estimate.warnings)
        warnings.append(QString::fromStdString(warning));
    json.insert("warnings", warnings);
    return json;
}

} // namespace

int outcomeOfOrder(const QString& word) {
    Ranking ranks{-1, -1, -1};
    std::int8_t rank = 0;
    for (qsizetype i = 0; i < word.size(); ++i) {
        const char c = word[i].toLower().toLatin1();
        if (i % 2 == 1) { // between two names
            if (c != '<' && c != '=')
                return -1;
            rank = static_cast<std::int8_t>(rank + (c == '<' ? 1 : 0));
        } else if (c < 'a' || c > 'c' || ranks[static_cast<std::size_t>(c - 'a')] >= 0) {
            return -1;
        } else {
            ranks[static_cast<std::size_t>(c - 'a')] = rank;
        }
    }
    return word.size() == 5 ? rankingOf(ranks) : -1;
}

core::Result<AdaptiveLine> parseAdaptiveLine(const QString& line, int outcomes, bool orders,
                                             std::size_t dimensions) {
    AdaptiveLine read;
    QString joined = line.simplified();
    for (const QString& sign : {QStringLiteral("<"), QStringLiteral("=")})
        joined.replace(QStringLiteral(" ") + sign, sign).replace(sign + QStringLiteral(" "), sign);
    QStringList words = joined.split(u' ', Qt::SkipEmptyParts);
    if (words.isEmpty())
        return badInput(QStringLiteral("empty: expected %1").arg(expected(outcomes, orders)));
    const QString word = words.takeFirst();
    if (word == u"undo" || word == u"spoiled") {
        if (!words.isEmpty())
            return badInput(
                QStringLiteral("%1 after %2: expected nothing").arg(quoted(words.join(u' ')), word));
        read.kind = word == u"undo" ? AdaptiveLine::Kind::undo : AdaptiveLine::Kind::spoiled;
        return read;
    }
    if (word.contains(u'=') && outcomes != kRankings)
        return badInput(QStringLiteral("%1: ties are not allowed by this procedure; expected %2")
                            .arg(quoted(word), expected(outcomes, orders)));
    const bool isIndex = word.size() <= 3 && std::all_of(word.begin(), word.end(),
                                                         [](QChar c) { return c >= u'0' && c <= u'9'; });
    // An order has no meaning if the procedure does not ask for orders.
    read.outcome = isIndex ? word.toInt() : orders ? outcomeOfOrder(word) : -1;
    if (read.outcome < 0 || read.outcome >= outcomes)
        return badInput(QStringLiteral("%1: expected %2").arg(quoted(word), expected(outcomes, orders)));
    if (!words.isEmpty()) {
        auto presented = presentedOf(words, dimensions);
        CHIRON_TRY(presented);
        read.presented = std::move(*presented);
    }
    return read;
}

QJsonObject adaptiveState(const Procedure& procedure, const QStringList& dimensions) {
    QJsonObject json{
        {"trial", procedure.trials()}, {"reversals", procedure.reversals()}, {"done", procedure.done()}};
    json.insert("stimulus", QJsonValue::Null);
    json.insert("entropy_margin", QJsonValue::Null);
    if (!procedure.done()) {
        const Choice choice = procedure.next();
        json.insert("entropy_margin", finite(choice.entropyMargin));
        if (choice.stimulus.size() == 1) {
            json.insert("stimulus", choice.stimulus[0]);
        } else {
            QJsonObject stimulus;
            for (std::size_t i = 0; i < choice.stimulus.size(); ++i)
                stimulus.insert(dimensions.value(static_cast<qsizetype>(i), QString::number(i)),
                                choice.stimulus[i]);
            json.insert("stimulus", stimulus);
        }
        if (choice.candidate >= 0)
            json.insert("candidate", choice.candidate);
    }
    json.insert("estimate", procedureEstimateJson(procedure.estimate()));
    return json;
}

} // namespace chiron::cli
