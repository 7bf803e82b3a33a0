// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_published.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace chiron::published {

QJsonObject dataFile(const char* name) {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

std::vector<double> numbers(const QJsonValue& array) {
    std::vector<double> values;
    for (const QJsonValue value : array.toArray()) {
        values.push_back(value.isDouble() ? value.toDouble() : std::numeric_limits<double>::quiet_NaN());
    }
    return values;
}

psychophysics::PsychometricData rows(const QJsonValue& array) {
    psychophysics::PsychometricData data;
    for (const QJsonValue row : array.toArray()) {
        const std::vector<double> xkn = numbers(row);
        data.x.push_back(xkn.at(0));
        data.k.push_back(xkn.at(1));
        data.n.push_back(xkn.at(2));
    }
    return data;
}

void Tally::startCase(const QString& id) {
    m_case = id;
    m_open = m_holds = true;
    ++m_cases;
}

void Tally::compare(const char* what, double got, double expected, double allowed) {
    const double ratio = std::abs(got - expected) / allowed;
    note(what, std::isnan(ratio) ? std::numeric_limits<double>::infinity() : ratio,
         QStringLiteral("got %1, expected %2 ± %3")
             .arg(got, 0, 'g', 9)
             .arg(expected, 0, 'g', 9)
             .arg(allowed, 0, 'g', 3));
}

void Tally::notBelow(const char* what, double got, double expected, double allowed) {
    const double ratio = std::max(0.0, expected - got) / allowed;
    note(what, std::isnan(got) ? std::numeric_limits<double>::infinity() : ratio,
         QStringLiteral("got %1, at least %2 − %3")
             .arg(got, 0, 'g', 12)
             .arg(expected, 0, 'g', 12)
             .arg(allowed, 0, 'g', 3));
}

void Tally::require(const char* what, bool holds) {
    if (!holds) {
        note(what, std::numeric_limits<double>::infinity(), QStringLiteral("does not hold"));
    }
}

void Tally::note(const char* what, double ratio, const QString& words) {
    if (ratio > m_worstRatio) {
        m_worstRatio = ratio;
        m_worst = m_case + QLatin1Char(' ') + QLatin1String(what);
    }
    if (ratio > 1.0) {
        m_holds = false;
        std::printf("    %s %s: %s\n", qPrintable(m_case), what, qPrintable(words));
    }
}

bool Tally::endCase() {
    m_passed += m_open && m_holds ? 1 : 0;
    m_open = false;
    return m_holds;
}

bool Tally::report() {
    std::printf("| %s | %d | %d | %.3g of the tolerance (%s) |\n", qPrintable(m_title), m_cases, m_passed,
                m_worstRatio, qPrintable(m_worst));
    std::fflush(stdout);
    return m_cases > 0 && m_passed == m_cases;
}

} // namespace chiron::published
