// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtTest>
#include <algorithm>
#include <cmath>

// One printed line a source of published numbers: how many were compared, how many held, and the worst
// difference.
class PublishedLine {
public:
    explicit PublishedLine(const char* source) : m_source(source) {}

    void compare(double computed, double published, double tolerance) {
        const double difference = std::abs(computed - published);
        ++m_cases;
        m_passed += difference <= tolerance ? 1 : 0;
        m_worst = std::max(m_worst, std::isnan(difference) ? HUGE_VAL : difference);
        if (!(difference <= tolerance))
            qInfo("%s, case %d: computed %.10g, published %.10g", m_source, m_cases, computed, published);
    }
    bool holds() const {
        qInfo("%s: %d cases, %d passed, worst difference %.2g", m_source, m_cases, m_passed, m_worst);
        return m_passed == m_cases && m_cases > 0;
    }

private:
    const char* m_source;
    int m_cases = 0;
    int m_passed = 0;
    double m_worst = 0.0;
};
