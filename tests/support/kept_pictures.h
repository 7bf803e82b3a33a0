// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <vector>

namespace chiron::tests {

/// Holds pictures against those that somebody looked at and kept, as mean colours of 16 × 12 fields in tenths
/// of 1/255, in a file that is read once. What is drawn by hand (scenes, plots, gauges) is told by no number;
/// a change of it is looked at, then kept anew: with CHIRON_STORE_PICTURES set nothing is compared, and the
/// file is written at the end. CHIRON_PICTURES=<folder> saves what is drawn.
class KeptPictures {
public:
    explicit KeptPictures(QString file) : m_file(std::move(file)) {
        QFile stored(m_file);
        if (stored.open(QIODevice::ReadOnly))
            m_kept = QJsonDocument::fromJson(stored.readAll()).object();
    }
    ~KeptPictures() {
        if (!keeps() || m_seen.isEmpty())
            return;
        for (auto it = m_seen.begin(); it != m_seen.end(); ++it)
            m_kept[it.key()] = it.value();
        QFile stored(m_file);
        if (stored.open(QIODevice::WriteOnly))
            stored.write(QJsonDocument(m_kept).toJson(QJsonDocument::Compact).replace("],\"", "],\n\"") +
                         '\n');
    }
    KeptPictures(const KeptPictures&) = delete;
    KeptPictures& operator=(const KeptPictures&) = delete;

    /// Empty where the picture is the kept one; else what differs. `tolerance`: of a field's mean, of 255.
    QString differs(const QString& name, const QImage& picture, double tolerance = kSame) {
        if (const QString folder = qEnvironmentVariable("CHIRON_PICTURES"); !folder.isEmpty())
            picture.save(QDir(folder).filePath(name + QStringLiteral(".png")));
        const QJsonArray now = fieldsOf(picture);
        m_seen[name] = now;
        if (keeps())
            return {};
        const QJsonArray kept = m_kept[name].toArray();
        if (kept.size() != now.size())
            return name + QStringLiteral(": no such picture is kept. Look at it (CHIRON_PICTURES=<folder>), "
                                         "then run once with CHIRON_STORE_PICTURES=1");
        double most = 0.0;
        qsizetype where = 0;
        for (qsizetype i = 0; i < now.size(); ++i)
            if (const double d = 0.1 * std::abs(now[i].toDouble() - kept[i].toDouble()); d > most) {
                most = d;
                where = i / 3;
            }
        if (most <= tolerance)
            return {};
        return QStringLiteral("%1: not as it was looked at: by %2 of 255 in column %3 of %4, row %5 of %6. "
                              "If it should look so, look at it "
                              "(CHIRON_PICTURES=<folder>), then run once with CHIRON_STORE_PICTURES=1")
            .arg(name)
            .arg(most, 0, 'f', 1)
            .arg(where % kColumns + 1)
            .arg(kColumns)
            .arg(where / kColumns + 1)
            .arg(kRows);
    }

    static constexpr double kSame = 0.15; ///< rounding, and not a line moved by a pixel

private:
    static constexpr int kColumns = 16, kRows = 12;
    static bool keeps() { return qEnvironmentVariableIsSet("CHIRON_STORE_PICTURES"); }

    static QJsonArray fieldsOf(const QImage& picture) {
        const QImage image = picture.convertToFormat(QImage::Format_RGB32);
        std::vector<std::array<double, 3>> sums(kColumns * kRows, std::array<double, 3>{});
        std::vector<double> counts(sums.size(), 0.0);
        for (int y = 0; y < image.height(); ++y) {
            const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
            for (int x = 0; x < image.width(); ++x) {
                const auto field = static_cast<std::size_t>(y * kRows / image.height() * kColumns +
                                                            x * kColumns / image.width());
                sums[field][0] += qRed(line[x]);
                sums[field][1] += qGreen(line[x]);
                sums[field][2] += qBlue(line[x]);
                counts[field] += 1.0;
            }
        }
        QJsonArray fields;
        for (std::size_t i = 0; i < sums.size(); ++i)
            for (const double sum : sums[i])
                fields.append(counts[i] > 0.0 ? std::round(10.0 * sum / counts[i]) : 0.0);
        return fields;
    }

    QString m_file;
    QJsonObject m_kept, m_seen;
};

} // namespace chiron::tests
