// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_rules.h"

#include <QSet>
#include <QString>
#include <QStringDecoder>
#include <optional>

namespace chiron::database {
namespace {

std::optional<QString> decoded(const std::string& text) {
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString string = decoder.decode(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())));
    if (decoder.hasError() || text.find('\0') != std::string::npos || text.starts_with("\xef\xbb\xbf")) {
        return std::nullopt;
    }
    return string;
}

core::Result<void> bad(const std::string& message) {
    return core::fail(core::ErrorCode::badInput, message);
}

} // namespace

PasswordCheck examinePassword(const std::string& name, const std::string& password) {
    const auto text = decoded(password);
    const QList<uint> characters = text ? text->toUcs4() : QList<uint>();
    const QSet<uint> different(characters.begin(), characters.end());
    return {characters.size() >= kMinimumPasswordCharacters, different.size() >= kMinimumDifferentCharacters,
            !text || nameKey(password) != nameKey(name),
            text && password.size() <= static_cast<std::size_t>(kMaximumPasswordBytes)};
}

core::Result<void> checkPassword(const std::string& name, const std::string& password) {
    if (!examinePassword(name, password).ok()) {
        return bad("password not accepted: it needs at least " + std::to_string(kMinimumPasswordCharacters) +
                   " characters, at most " + std::to_string(kMaximumPasswordBytes) +
                   " bytes of valid UTF-8, at least " + std::to_string(kMinimumDifferentCharacters) +
                   " different characters, and must not be the login name");
    }
    return {};
}

core::Result<void> checkName(const std::string& name) {
    const auto text = decoded(name);
    const std::string rule =
        "name not accepted: it needs 1 to " + std::to_string(kMaximumNameCharacters) +
        " characters of valid UTF-8, no control characters, commas or spaces at the ends";
    if (!text || text->trimmed() != *text || text->isEmpty() || text->contains(QLatin1Char(','))) {
        return bad(rule);
    }
    const QList<uint> characters = text->toUcs4();
    for (const uint character : characters) {
        const auto category = QChar::category(character);
        if (category == QChar::Other_Control || category == QChar::Other_Format ||
            category == QChar::Separator_Line || category == QChar::Separator_Paragraph) {
            return bad(rule + "; it holds an invisible character");
        }
    }
    if (characters.size() > kMaximumNameCharacters) {
        return bad(rule);
    }
    if (nameKey(name) == "simulated" || nameKey(name).starts_with("erased-")) {
        return bad("name not accepted: \"" + name + "\" is kept for the program itself");
    }
    return {};
}

core::Result<void> checkText(const std::string& field, const std::string& text, int maximumCharacters) {
    const auto string = decoded(text);
    if (!string || string->toUcs4().size() > maximumCharacters) {
        return bad(field + ": expected valid UTF-8 of at most " + std::to_string(maximumCharacters) +
                   " characters");
    }
    return {};
}

core::Result<void> checkNames(const std::string& name, const std::string& displayName) {
    auto good = checkName(name);
    return good ? checkText("display name", displayName, kMaximumDisplayNameCharacters) : good;
}

std::string nameKey(const std::string& name) {
    return QString::fromStdString(name)
        .normalized(QString::NormalizationForm_KC)
        .toCaseFolded()
        .normalized(QString::NormalizationForm_KC)
        .toStdString();
}

} // namespace chiron::database
