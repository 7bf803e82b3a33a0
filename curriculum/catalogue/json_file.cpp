// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/json_file.h"

#include "catalogue/json_scanner.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QStringDecoder>

namespace chiron::catalogue {

namespace {

constexpr qsizetype kMebibyte = 1 << 20;
constexpr std::size_t kMostProblems = 20;

tl::unexpected<core::Error> refuse(const QString& name, const QByteArray& bytes, qsizetype offset,
                                   const QString& text) {
    const TextPlace place = placeOf(bytes, offset);
    return core::fail(
        core::ErrorCode::badInput,
        QStringLiteral("%1:%2:%3: %4").arg(name).arg(place.line).arg(place.column).arg(text).toStdString());
}

bool isUtf8(const QByteArray& bytes, QStringDecoder::Flag flag) {
    QStringDecoder decoder(QStringDecoder::Utf8, flag);
    const QString decoded = decoder(bytes);
    Q_UNUSED(decoded);
    return !decoder.hasError();
}

/// Returns the offset of the first byte that is not valid UTF-8, or -1.
qsizetype firstBadByte(const QByteArray& bytes) {
    if (isUtf8(bytes, QStringDecoder::Flag::Stateless))
        return -1;
    qsizetype good = 0; // bisection: every prefix is valid up to the fault; a sequence that the prefix's end
                        // cuts is not a fault
    qsizetype bad = bytes.size() + 1;
    while (bad - good > 1) {
        const qsizetype middle = (good + bad) / 2;
        (isUtf8(bytes.left(middle), QStringDecoder::Flag::Default) ? good : bad) = middle;
    }
    while (good > 0 && !isUtf8(bytes.left(good), QStringDecoder::Flag::Stateless))
        --good; // back to the start of the invalid sequence
    return good;
}

} // namespace

core::Result<JsonFile> JsonFile::read(const QString& path, qsizetype mebibytes) {
    const QFileInfo info(path);
    QFile file(path);
    if ((info.exists() && !info.isFile()) || !file.open(QIODevice::ReadOnly))
        return core::fail(core::ErrorCode::notFound,
                          QStringLiteral("%1: %2: expected a file that can be read")
                              .arg(path, info.exists() && !info.isFile() ? QStringLiteral("not a file")
                                                                         : file.errorString())
                              .toStdString());
    return parse(file.read(mebibytes * kMebibyte + 1), path, mebibytes);
}

core::Result<JsonFile> JsonFile::parse(const QByteArray& bytes, const QString& name, qsizetype mebibytes) {
    if (bytes.size() > mebibytes * kMebibyte)
        return refuse(name, bytes, 0,
                      QStringLiteral("$: longer than %1 MiB: expected a content file of at most %1 MiB")
                          .arg(mebibytes));
    if (const qsizetype bad = firstBadByte(bytes); bad >= 0)
        return refuse(name, bytes, bad,
                      QStringLiteral("$: byte 0x%1: expected UTF-8")
                          .arg(static_cast<int>(static_cast<uchar>(bytes[bad])), 2, 16, QLatin1Char('0')));
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (error.error != QJsonParseError::NoError)
        return refuse(name, bytes, error.offset,
                      QStringLiteral("$: %1: expected JSON").arg(error.errorString()));
    if (!document.isObject())
        return refuse(name, bytes, 0, QStringLiteral("$: an array: expected an object"));
    JsonFile file;
    file.m_name = name;
    file.m_bytes = bytes;
    file.m_root = document.object();
    JsonScanner scanner(file.m_bytes);
    scanner.scan();
    file.m_offsets = scanner.offsets();
    if (!scanner.problems().empty())
        return tl::unexpected(file.error(scanner.problems()));
    return file;
}

core::Error JsonFile::error(const Problems& problems) const {
    QString text;
    for (std::size_t i = 0; i < problems.size() && i < kMostProblems; ++i) {
        const Problem& problem = problems[i];
        QString known = problem.path;
        while (!m_offsets.contains(known) && known.size() > 1)
            known.truncate(qMax(qsizetype{1}, qMax(known.lastIndexOf(u'.'), known.lastIndexOf(u'['))));
        const TextPlace place = placeOf(m_bytes, m_offsets.value(known, 0));
        text += QStringLiteral("%1%2:%3:%4: %5: %6: expected %7")
                    .arg(i == 0 ? QString() : QStringLiteral("\n"), m_name)
                    .arg(place.line)
                    .arg(place.column)
                    .arg(problem.path, problem.found, problem.expected);
    }
    if (problems.size() > kMostProblems)
        text += QStringLiteral("\nand %1 more").arg(problems.size() - kMostProblems);
    return {core::ErrorCode::badInput, text.toStdString()};
}

} // namespace chiron::catalogue
