// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace chiron::tests {

/// Holds lines of text against those that somebody read and kept, in one file of sections ("== name"). A
/// change that is meant is kept anew: with CHIRON_STORE_OUTLINES set nothing is compared, the file is written
/// at the end, and its difference is read in review.
class KeptText {
public:
    using Same = bool (*)(const QString& was, const QString& is);
    /// `same`: which lines count as the same; by default only equal ones.
    explicit KeptText(
        QString file, Same same = [](const QString& was, const QString& is) { return was == is; })
        : m_file(std::move(file)), m_same(same) {
        QFile stored(m_file);
        if (!stored.open(QIODevice::ReadOnly))
            return;
        QString name;
        for (const QString& line : QString::fromUtf8(stored.readAll()).split(QLatin1Char('\n')))
            if (line.startsWith(QLatin1String("== ")))
                name = line.mid(3);
            else if (!line.isEmpty())
                m_kept[name] << line;
    }
    ~KeptText() {
        QFile stored(m_file);
        if (!keeps() || m_seen.isEmpty() || !stored.open(QIODevice::WriteOnly))
            return;
        for (auto it = m_seen.begin(); it != m_seen.end(); ++it)
            stored.write((QStringLiteral("== ") + it.key() + QLatin1Char('\n') +
                          it.value().join(QLatin1Char('\n')) + QLatin1Char('\n'))
                             .toUtf8());
    }
    KeptText(const KeptText&) = delete;
    KeptText& operator=(const KeptText&) = delete;

    /// Empty where these are the kept lines; else the first that differs.
    QString differs(const QString& name, const QStringList& lines) {
        m_seen[name] = lines;
        if (keeps())
            return {};
        const QStringList kept = m_kept.value(name);
        if (kept.isEmpty())
            return name + QStringLiteral(": nothing is kept of this. ") + kAnew;
        for (qsizetype i = 0; i < std::max(kept.size(), lines.size()); ++i)
            if (!m_same(kept.value(i), lines.value(i)))
                return QStringLiteral("%1, line %2\n   was: %3\n   is:  %4\n%5")
                    .arg(name + stepAt(lines, i))
                    .arg(i + 1)
                    .arg(kept.value(i).left(600), lines.value(i).left(600), kAnew);
        return {};
    }
    /// What is kept and was not held against anything: of something that is gone.
    QStringList unseen() const {
        QStringList names;
        for (const QString& name : m_kept.keys())
            if (!keeps() && !m_seen.contains(name))
                names << name;
        return names;
    }

    /// Outside of quotes numbers with a point may differ by their last digit (0.1, or 0.2 % of large ones),
    /// which rounding decides; all else is the same.
    static bool nearly(const QString& was, const QString& is) {
        if (was == is)
            return true;
        static const QRegularExpression number(QStringLiteral("-?[0-9]+\\.[0-9]+"));
        auto a = number.globalMatch(was), b = number.globalMatch(is);
        qsizetype fromA = 0, fromB = 0;
        while (a.hasNext() && b.hasNext()) {
            const auto x = a.next(), y = b.next();
            if (was.mid(fromA, x.capturedStart() - fromA) != is.mid(fromB, y.capturedStart() - fromB))
                return false;
            if (was.left(x.capturedStart()).count(QLatin1Char('"')) % 2 == 1 && x.captured() != y.captured())
                return false;
            const double p = x.captured().toDouble(), q = y.captured().toDouble();
            if (std::abs(p - q) > std::max(0.1001, 2e-3 * std::abs(p)))
                return false;
            fromA = x.capturedEnd();
            fromB = y.capturedEnd();
        }
        return !a.hasNext() && !b.hasNext() && was.mid(fromA) == is.mid(fromB);
    }

    /// The same words, parted by blanks, and numbers within a millionth of themselves or `floor` of each
    /// other: libraries of mathematics round differently on other processors, and what swings or is searched
    /// for carries that on; a changed law moves far more. Infinite is not alike.
    static bool within(const QString& was, const QString& is, double floor) {
        if (was == is)
            return true;
        const QStringList a = was.split(QLatin1Char(' ')), b = is.split(QLatin1Char(' '));
        if (a.size() != b.size())
            return false;
        for (qsizetype i = 0; i < a.size(); ++i) {
            if (a[i] == b[i])
                continue;
            bool first = false, second = false;
            const double x = a[i].toDouble(&first), y = b[i].toDouble(&second);
            if (!first || !second || !std::isfinite(x) || !std::isfinite(y) ||
                std::abs(x - y) > 1e-6 * std::max(std::abs(x), std::abs(y)) + floor)
                return false;
        }
        return true;
    }

private:
    /// A section's step ("-- as it is made") that a line is of.
    static QString stepAt(const QStringList& lines, qsizetype at) {
        for (qsizetype i = std::min(at, lines.size() - 1); i >= 0; --i)
            if (lines[i].startsWith(QLatin1String("-- ")))
                return QStringLiteral(", ") + lines[i].mid(3);
        return {};
    }
    static bool keeps() { return qEnvironmentVariableIsSet("CHIRON_STORE_OUTLINES"); }
    static inline const QString kAnew =
        QStringLiteral("If it should be so, run the whole test once with CHIRON_STORE_OUTLINES=1, and read "
                       "the difference of the kept file.");

    QString m_file;
    Same m_same;
    QMap<QString, QStringList> m_kept, m_seen;
};

/// What is new and what is gone since the lines were last looked at; all of them at first.
class LineChanges {
public:
    QStringList of(const QStringList& now) {
        QStringList said;
        for (const QString& line : now)
            if (!m_before.contains(line))
                said << line;
        for (const QString& line : m_before)
            if (!now.contains(line))
                said << QStringLiteral("no more ") + line.trimmed().left(60);
        m_before = now;
        return said;
    }
    void forget() { m_before.clear(); }

private:
    QStringList m_before;
};

} // namespace chiron::tests
