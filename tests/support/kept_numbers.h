// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/kept_text.h"

#include <initializer_list>
#include <span>
#include <vector>

namespace chiron::tests {

/// Lines of words and numbers as a model gives them, for KeptText.
class NumberLines {
public:
    void add(const QString& words, std::span<const double> numbers) {
        QString line = words;
        for (const double x : numbers)
            line +=
                QLatin1Char(' ') + (std::abs(x) < 1e-14 ? QStringLiteral("0") : QString::number(x, 'g', 10));
        m_lines << line;
    }
    void add(const QString& words, std::initializer_list<double> numbers = {}) {
        add(words, std::span<const double>(numbers.begin(), numbers.size()));
    }
    /// Of a vector or matrix of Eigen, column after column.
    template <class Matrix> void addMatrix(const QString& words, const Matrix& matrix) {
        const typename Matrix::PlainObject values = matrix;
        add(words, std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
    }
    const QStringList& lines() const { return m_lines; }

private:
    QStringList m_lines;
};

/// Lines of numbers that may differ as KeptText::within() says.
inline bool sameNumbers(const QString& was, const QString& is) {
    return KeptText::within(was, is, 1e-12);
}

} // namespace chiron::tests
