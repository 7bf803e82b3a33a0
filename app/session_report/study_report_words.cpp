// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_report_words.h"

#include "session_report/procedure_words.h"
#include "session_report/study_report_text.h"

#include <QDateTime>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::session_report::study_report_words {

using psychophysics::Attribute;
using psychophysics::Task;

namespace {

struct Unit {
    double factor;
    const char* text;
};

/// The unit in which values of an attribute are shown: shown = SI · factor.
Unit shownUnit(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return {1.0, " N/m"};
    case Attribute::mass:
        return {1e3, " g"};
    case Attribute::deformation:
        return {1.0, " s"};
    case Attribute::roughness:
        return {1e6, " µm"};
    case Attribute::friction:
        return {1.0, ""};
    case Attribute::viscosity:
        return {1.0, " N·s/m"};
    case Attribute::apex:
        return {1e3, " mm"};
    }
    return {1.0, ""};
}

QString spaced(std::string_view token) {
    return QString::fromUtf8(token.data(), static_cast<qsizetype>(token.size()))
        .replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace

QString attribute(Attribute attribute) {
    const QString words[] = {Words::tr("Stiffness"), Words::tr("Mass"),     Words::tr("Deformation"),
                             Words::tr("Roughness"), Words::tr("Friction"), Words::tr("Viscosity"),
                             Words::tr("Apex")};
    return words[static_cast<std::size_t>(attribute)];
}

QString task(Task task) {
    const QString words[] = {Words::tr("Ranking of three"),
                             Words::tr("Two alternatives (2AFC)"),
                             Words::tr("Three alternatives (3AFC)"),
                             Words::tr("Odd one out of three"),
                             Words::tr("Same or different"),
                             Words::tr("Yes or no"),
                             Words::tr("Adjustment"),
                             Words::tr("Magnitude estimation"),
                             Words::tr("Ranking of three, with ties")};
    return words[static_cast<std::size_t>(task)];
}

QString procedure(std::string_view kind) {
    return procedureTitle(kind);
}

QString order(psychophysics::OrderDesign order) {
    const QString words[] = {Words::tr("As listed"), Words::tr("Random"), Words::tr("Latin square"),
                             Words::tr("Williams design")};
    return words[static_cast<std::size_t>(order)];
}

QString state(database::StudyState state) {
    const QString words[] = {Words::tr("Draft"), Words::tr("Frozen"), Words::tr("Closed"),
                             Words::tr("Archived")};
    return words[static_cast<std::size_t>(state)];
}

QString participantState(database::ParticipantState state) {
    const QString words[] = {Words::tr("Consent missing"), Words::tr("Takes part"), Words::tr("Completed"),
                             Words::tr("Withdrawn")};
    return words[static_cast<std::size_t>(state)];
}

QString runState(database::StudyRunState state) {
    const QString words[] = {Words::tr("Open"), Words::tr("Completed"), Words::tr("Stopped")};
    return words[static_cast<std::size_t>(state)];
}

QString spoiled(const std::string& token) {
    const std::map<std::string, QString> words{{"force_error", Words::tr("Force not as commanded")},
                                               {"stiffness_error", Words::tr("Felt value off")},
                                               {"late_ticks", Words::tr("Late ticks")},
                                               {"saturation", Words::tr("Device at its limit")},
                                               {"speed", Words::tr("Moved too fast")},
                                               {"peak_force", Words::tr("Pressed too hard")},
                                               {"time", Words::tr("Time was up")},
                                               {"untouched", Words::tr("Not all touched")},
                                               {"taken_back", Words::tr("Taken back")},
                                               {"experimenter", Words::tr("Discarded by the experimenter")},
                                               {"stopped", Words::tr("Interrupted")},
                                               {"withheld", Words::tr("Sealed reason")}};
    const auto found = words.find(token);
    return found == words.end() ? spaced(token) : found->second;
}

QString codes(const std::vector<std::string>& list) {
    QStringList words;
    for (const std::string& code : list)
        words << QString::fromStdString(code);
    return words.join(QStringLiteral(", "));
}

QString number(double value, const QLocale& locale) {
    constexpr int kDigits = 3;
    if (!std::isfinite(value))
        return QStringLiteral("–");
    if (value == 0.0)
        return locale.toString(0);
    const int whole = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    if (whole > 7 || whole < -4)
        return locale.toString(value, 'g', kDigits);
    return locale.toString(value, 'f', std::max(0, kDigits - whole));
}

QString plainNumber(double value, const QLocale& locale) {
    constexpr int kDigits = 6;
    return std::isfinite(value) ? locale.toString(value, 'g', kDigits) : QStringLiteral("–");
}

QString percent(double ratio, const QLocale& locale) {
    return std::isfinite(ratio) ? number(100.0 * ratio, locale) + QStringLiteral(" %") : QStringLiteral("–");
}

QString intervalPercent(double low, double high, const QLocale& locale) {
    if (!std::isfinite(low) || !std::isfinite(high))
        return QStringLiteral("–");
    return QStringLiteral("%1 … %2 %").arg(number(100.0 * low, locale), number(100.0 * high, locale));
}

QString value(double si, Attribute attribute, const QLocale& locale) {
    const Unit unit = shownUnit(attribute);
    return std::isfinite(si) ? number(si * unit.factor, locale) + QString::fromUtf8(unit.text)
                             : QStringLiteral("–");
}

QString day(const std::string& utc, const QLocale& locale) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
    return time.isValid() ? locale.toString(time.date(), QLocale::ShortFormat) : QString();
}

QString text(const psychophysics::StudyText& text, const std::string& language) {
    auto found = text.find(language);
    if (found == text.end() || found->second.empty())
        found = text.find("en");
    if (found == text.end())
        found = text.begin();
    return found == text.end() ? QString() : QString::fromStdString(found->second);
}

} // namespace chiron::session_report::study_report_words
