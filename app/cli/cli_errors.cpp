// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"

namespace chiron::cli {

namespace {

QString escaped(const QString& text, bool keepLineEnds) {
    QString out;
    out.reserve(text.size());
    for (const QChar c : text) {
        const bool isControl = c.category() == QChar::Other_Control || c.category() == QChar::Other_Format ||
                               c.category() == QChar::Separator_Line ||
                               c.category() == QChar::Separator_Paragraph;
        if (isControl && !(keepLineEnds && c == QLatin1Char('\n')))
            out += QStringLiteral("\\u%1").arg(c.unicode(), 4, 16, QLatin1Char('0'));
        else
            out += c;
    }
    return out;
}

} // namespace

QString quoted(const QString& value) {
    constexpr qsizetype kLongest = 120;
    const QString shown = value.size() > kLongest ? value.left(kLongest) + QStringLiteral("…") : value;
    return QLatin1Char('"') + escaped(shown, false) + QLatin1Char('"');
}

QString printable(const QString& text) {
    return escaped(text, true);
}

tl::unexpected<core::Error> wrongUse(const QString& message) {
    return core::fail(core::ErrorCode::wrongUse, message.toStdString());
}

tl::unexpected<core::Error> badInput(const QString& message) {
    return core::fail(core::ErrorCode::badInput, message.toStdString());
}

tl::unexpected<core::Error> noFolder(const QString& path) {
    return core::fail(core::ErrorCode::storage,
                      QStringLiteral("%1: the folder cannot be made; expected a place that may be written to")
                          .arg(quoted(path))
                          .toStdString());
}

tl::unexpected<core::Error> stdoutBroke() {
    return core::fail(core::ErrorCode::storage,
                      "stdout: could not be written completely; expected room on its disk, or a reader that "
                      "reads to the end");
}

int exitCodeOf(core::ErrorCode code) {
    switch (code) {
    case core::ErrorCode::doesNotHold:
    case core::ErrorCode::cancelled:
        return 1;
    case core::ErrorCode::wrongUse:
    case core::ErrorCode::notAllowed:
        return 2;
    case core::ErrorCode::badInput:
    case core::ErrorCode::notFound:
        return 3;
    case core::ErrorCode::storage:
    case core::ErrorCode::locked:
        return 4;
    case core::ErrorCode::device:
        return 5;
    }
    return 4;
}

} // namespace chiron::cli
