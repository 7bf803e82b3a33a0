// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/painted_shapes.h"

#include <QProcess>
#include <QString>
#include <QStringList>

#include <vector>

namespace chiron::tests {

/// How the lines of a page are put in order: as they stand on the paper, or as they were drawn, which keeps
/// together what stands in one of several columns.
enum class PdfOrder { laidOut, drawn };

/// The text of a PDF as pdftotext reads it. That program is part of poppler-utils, which scripts/setup
/// installs: without it no report is tested, so its absence ends the test program.
inline QString pdfText(const QString& pdf, PdfOrder order = PdfOrder::laidOut) {
    QProcess reader;
    reader.start(QStringLiteral("pdftotext"),
                 {order == PdfOrder::laidOut ? QStringLiteral("-layout") : QStringLiteral("-raw"), pdf,
                  QStringLiteral("-")});
    if (!reader.waitForStarted(-1))
        qFatal("pdftotext could not be started (%s): run scripts/setup, which installs poppler-utils",
               qPrintable(reader.errorString()));
    reader.waitForFinished(-1);
    if (reader.exitStatus() != QProcess::NormalExit || reader.exitCode() != 0)
        qFatal("pdftotext could not read %s: %s", qPrintable(pdf), reader.readAllStandardError().constData());
    return QString::fromUtf8(reader.readAllStandardOutput()).normalized(QString::NormalizationForm_C);
}

inline QStringList pdfLines(const QString& pdf) {
    return pdfText(pdf).split(QLatin1Char('\n'));
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
    const QString copied = visibleLetters(pdfText(pdf, PdfOrder::drawn));
    QStringList lost;
    for (const QString& words : wordsIn(painted))
        if (!copied.contains(visibleLetters(words)))
            lost << words;
    return lost;
}

} // namespace chiron::tests
