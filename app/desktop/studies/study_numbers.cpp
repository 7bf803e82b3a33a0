// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, units and texts of studies.
#include "desktop/studies/study_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <cmath>

namespace chiron::desktop::study_words {

using psychophysics::Attribute;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyWords)
};

QString dash() {
    return QStringLiteral("–");
}

/// The digits with which numbers that stand beside each other are written.
int digitsOfNeighbours(const std::vector<double>& numbers) {
    return digitsThatDiffer(numbers, kUsualDigits,
                            [](double one, int digits) { return number(one, QLocale::c(), digits); });
}

QString inUnit(const QString& digits, const Unit& unit) {
    return unit.text.isEmpty() ? digits : QStringLiteral("%1 %2").arg(digits, unit.text);
}

QString inPercent(const QString& digits) {
    return QStringLiteral("%1 %").arg(digits);
}

} // namespace

Unit unitOf(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return {1.0, QStringLiteral("N/m")};
    case Attribute::mass:
        return {1e3, QStringLiteral("g")};
    case Attribute::deformation:
        return {1.0, QStringLiteral("s")};
    case Attribute::roughness:
        return {1e6, QStringLiteral("µm")};
    case Attribute::friction:
        return {1.0, QString()};
    case Attribute::viscosity:
        return {1.0, QStringLiteral("N·s/m")};
    case Attribute::apex:
        return {1e3, QStringLiteral("mm")};
    }
    return {};
}

QString number(double value, const QLocale& locale, int digits) {
    if (!std::isfinite(value))
        return dash();
    if (value == 0.0)
        return locale.toString(0);
    const int whole = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    if (whole > 7 || whole < -4)
        return locale.toString(value, 'g', digits);
    return locale.toString(value, 'f', std::max(0, digits - whole));
}

QString withError(double value, double error, const QLocale& locale) {
    if (!std::isfinite(value) || !std::isfinite(error))
        return QStringLiteral("%1 ± %2").arg(number(value, locale), number(error, locale, 2));
    // Both to the same place: that of the value's third digit, or of the error's first if that is further on.
    const auto placeOf = [](double x, int digits) {
        return x == 0.0 ? 0 : std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(x)))));
    };
    const int decimals = std::max(placeOf(value, kUsualDigits), placeOf(error, 1));
    return QStringLiteral("%1 ± %2").arg(locale.toString(value, 'f', decimals),
                                         locale.toString(error, 'f', decimals));
}

QString plainNumber(double value, const QLocale& locale) {
    constexpr int kDigits = 6;
    return std::isfinite(value) ? locale.toString(value, 'g', kDigits) : dash();
}

QString value(double si, Attribute attribute, const QLocale& locale) {
    const Unit unit = study_words::unitOf(attribute);
    return inUnit(number(si * unit.factor, locale), unit);
}

QStringList values(const std::vector<double>& si, Attribute attribute, const QLocale& locale) {
    const Unit unit = study_words::unitOf(attribute);
    std::vector<double> shown;
    for (const double one : si)
        shown.push_back(one * unit.factor);
    const int digits = digitsOfNeighbours(shown);
    QStringList words;
    for (const double one : shown)
        words << inUnit(number(one, locale, digits), unit);
    return words;
}

int digitsThatDiffer(const std::vector<double>& numbers, int fewest,
                     const std::function<QString(double, int)>& written) {
    constexpr int kMost = 9;
    constexpr double kSame = 1e-9; // two ways to compute one number differ by less
    const auto somethingReadsAlike = [&](int digits) {
        for (std::size_t i = 1; i < numbers.size(); ++i) {
            const double a = numbers[i - 1];
            const double b = numbers[i];
            if (std::abs(a - b) > kSame * std::max(std::abs(a), std::abs(b)) &&
                written(a, digits) == written(b, digits))
                return true;
        }
        return false;
    };
    int digits = fewest;
    while (digits < kMost && somethingReadsAlike(digits))
        ++digits;
    return digits;
}

QString percent(double ratio, const QLocale& locale) {
    return std::isfinite(ratio) ? inPercent(number(100.0 * ratio, locale)) : dash();
}

QStringList percents(const std::vector<double>& ratios, const QLocale& locale) {
    std::vector<double> shown;
    for (const double ratio : ratios)
        shown.push_back(100.0 * ratio);
    const int digits = digitsOfNeighbours(shown);
    QStringList words;
    for (const double one : shown)
        words << (std::isfinite(one) ? inPercent(number(one, locale, digits)) : dash());
    return words;
}

QString interval(double low, double high, const QLocale& locale) {
    if (!std::isfinite(low) || !std::isfinite(high))
        return {};
    const int digits = digitsOfNeighbours({low, high});
    return QStringLiteral("%1 … %2").arg(number(low, locale, digits), number(high, locale, digits));
}

QString intervalPercent(double low, double high, const QLocale& locale) {
    const QString shown = interval(100.0 * low, 100.0 * high, locale);
    return shown.isEmpty() ? shown : inPercent(shown);
}

double ratioOf(double difference) {
    return std::pow(10.0, difference) - 1.0;
}

double differenceOf(double ratio) {
    return std::log10(1.0 + ratio);
}

std::string shownLanguage(const psychophysics::StudyText& text, const QString& language) {
    for (const std::string& wanted : {language.toStdString(), std::string("en")})
        if (const auto found = text.find(wanted); found != text.end() && !found->second.empty())
            return wanted;
    return text.empty() ? std::string() : text.begin()->first;
}

QString text(const psychophysics::StudyText& text, const QString& language) {
    auto found = text.find(language.toStdString());
    if (found == text.end() || found->second.empty())
        found = text.find("en");
    if (found == text.end())
        found = text.begin();
    return found == text.end() ? QString() : QString::fromStdString(found->second);
}

QString shortSha(const std::string& sha256) {
    constexpr std::size_t kDigits = 12;
    return QString::fromStdString(sha256.substr(0, kDigits));
}

QString moment(const std::string& utc, const QLocale& locale) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
    return time.isValid() ? locale.toString(time.toLocalTime(), QLocale::ShortFormat) : QString();
}

QString parameter(const std::string& name) {
    if (name == "threshold")
        return Words::tr("Threshold");
    if (name == "slope")
        return Words::tr("Slope");
    if (name == "mean")
        return Words::tr("Mean");
    if (name == "sd")
        return Words::tr("Standard deviation");
    if (name == "lapse" || name == "lapse_rate")
        return Words::tr("Lapse rate");
    if (name == "guess" || name == "lower_asymptote")
        return Words::tr("Guess rate");
    return QString::fromStdString(name).replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace chiron::desktop::study_words
