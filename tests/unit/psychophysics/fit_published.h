// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>

#include <vector>

namespace chiron::published {

/// A file of published numbers in tests/unit/psychophysics/data.
QJsonObject dataFile(const char* name);
std::vector<double> numbers(const QJsonValue& array);
/// Rows [x, k, n].
psychophysics::PsychometricData rows(const QJsonValue& array);

/// Counts comparisons and keeps the worst, as a share of what is allowed; prints one line at the end.
class Tally {
public:
    explicit Tally(QString title) : m_title(std::move(title)) {}
    void startCase(const QString& id);
    /// |got − expected| against what is allowed; prints it where it is more.
    void compare(const char* what, double got, double expected, double allowed);
    /// got must not be below expected by more than allowed.
    void notBelow(const char* what, double got, double expected, double allowed);
    void require(const char* what, bool holds);
    bool endCase(); ///< whether all of it held
    /// "file: N cases, M passed, worst difference ... of the tolerance (case, number)". True where all
    /// passed.
    bool report();

private:
    void note(const char* what, double ratio, const QString& words);
    QString m_title, m_case, m_worst = QStringLiteral("none");
    int m_cases = 0, m_passed = 0;
    bool m_open = false, m_holds = true;
    double m_worstRatio = 0.0;
};

} // namespace chiron::published
