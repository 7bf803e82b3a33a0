// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonObject>
#include <array>
#include <charconv>
#include <string_view>

namespace chiron::catalogue {

namespace {

void appendText(std::string& out, const QString& text) {
    constexpr std::string_view kHex = "0123456789abcdef";
    out += '"';
    for (const char c : text.toUtf8()) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out.append(1, '\\').append(1, c);
        else if (byte < 0x20)
            out.append("\\u00").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
        else
            out += c;
    }
    out += '"';
}

void appendNumber(std::string& out, double number) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number + 0.0).ptr;
    out.append(text.data(), end);
}

void append(std::string& out, const QJsonValue& value) {
    if (value.isObject()) {
        const QJsonObject object = value.toObject(); // iterates sorted by key
        char separator = '{';
        for (auto it = object.begin(); it != object.end(); ++it) {
            out += separator;
            separator = ',';
            appendText(out, it.key());
            out += ':';
            append(out, it.value());
        }
        out += object.isEmpty() ? "{}" : "}";
    } else if (value.isArray()) {
        const QJsonArray array = value.toArray();
        char separator = '[';
        for (const QJsonValue element : array) {
            out += separator;
            separator = ',';
            append(out, element);
        }
        out += array.isEmpty() ? "[]" : "]";
    } else if (value.isString()) {
        appendText(out, value.toString());
    } else if (value.isDouble()) {
        appendNumber(out, value.toDouble());
    } else {
        out += value.isBool() ? (value.toBool() ? "true" : "false") : "null";
    }
}

} // namespace

std::string canonicalJson(const QJsonValue& value) {
    std::string out;
    append(out, value);
    return out;
}

std::string sha256Hex(const std::string& bytes) {
    const QByteArray view = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
    return QCryptographicHash::hash(view, QCryptographicHash::Sha256).toHex().toStdString();
}

} // namespace chiron::catalogue
