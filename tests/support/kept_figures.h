// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/kept_text.h"

#include <string>
#include <vector>

namespace chiron::tests {

/// What something computes and says, as lines of text to be kept (kept_text.h): a name and its figures to
/// nine digits, or words.
class Figures {
public:
    template <class... Numbers> void add(const QString& name, Numbers... numbers) {
        QString line = name + QLatin1Char(':');
        ((line += QLatin1Char(' ') + QString::number(static_cast<double>(numbers), 'g', 9)), ...);
        lines << line;
    }
    template <class Number> void each(const QString& name, const std::vector<Number>& numbers) {
        QString line = name + QLatin1Char(':');
        for (const Number number : numbers)
            line += QLatin1Char(' ') + QString::number(static_cast<double>(number), 'g', 9);
        lines << line;
    }
    void say(const QString& name, const std::string& words) {
        QString line = name + QStringLiteral(": ") + QString::fromStdString(words);
        lines << line.replace(QLatin1Char('\n'), QLatin1Char('|'));
    }
    void say(const QString& name, const std::vector<std::string>& words) {
        for (const std::string& one : words)
            say(name, one);
    }

    QStringList lines;
};

/// Lines of figures that may differ as KeptText::within() says; what is smaller than a thousand-millionth is
/// 0.
inline bool sameFigures(const QString& was, const QString& is) {
    return KeptText::within(was, is, 1e-9);
}

} // namespace chiron::tests
