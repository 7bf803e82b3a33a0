// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/painted_shapes.h"

#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>

namespace chiron::tests {

/// The text of a PDF as somebody copies it. "-layout" keeps columns apart; "-raw" is the order of painting.
/// scripts/setup installs the reader: without it, a test that asks for the text fails.
inline QString textOfPdf(const QString& pdf, const QString& order = QStringLiteral("-layout")) {
    const QString reader = QStandardPaths::findExecutable(QStringLiteral("pdftotext"));
    if (reader.isEmpty())
        qFatal("pdftotext is not installed: scripts/setup installs it, in poppler-utils");
    QProcess process;
    process.start(reader, {order, pdf, QStringLiteral("-")});
    if (!process.waitForFinished() || process.exitCode() != 0)
        qFatal("pdftotext cannot read %s", qPrintable(pdf));
    return QString::fromUtf8(process.readAllStandardOutput());
}

/// A text without spaces and marks that nobody sees; signs that look alike (µ and μ) are one.
inline QString visibleLetters(const QString& text) {
    QString letters;
    for (const QChar letter : text.normalized(QString::NormalizationForm_KC))
        if (!letter.isSpace() && letter.category() != QChar::Other_Format &&
            letter.category() != QChar::Other_Control)
            letters += letter;
    return letters;
}

/// The texts that are painted on the pages of a report and cannot be copied from its PDF as they are seen.
inline QStringList notCopied(const std::vector<PaintedShape>& painted, const QString& pdf) {
    const QString copied = visibleLetters(textOfPdf(pdf, QStringLiteral("-raw")));
    QStringList lost;
    for (const QString& words : wordsIn(painted))
        if (!copied.contains(visibleLetters(words)))
            lost << words;
    return lost;
}

} // namespace chiron::tests
