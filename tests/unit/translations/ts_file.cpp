// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/translations/ts_file.h"

#include <QFile>
#include <QXmlStreamReader>

namespace chiron::test {
namespace {

void readTranslation(QXmlStreamReader& xml, TsMessage& message) {
    message.finished = xml.attributes().value(QLatin1String("type")).isEmpty();
    if (!message.counts) {
        message.translations << xml.readElementText();
        return;
    }
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("numerusform"))
            message.translations << xml.readElementText();
        else
            xml.skipCurrentElement();
    }
}

TsMessage readMessage(QXmlStreamReader& xml, const QString& context) {
    TsMessage message;
    message.context = context;
    message.counts = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QLatin1String("source"))
            message.source = xml.readElementText();
        else if (xml.name() == QLatin1String("comment"))
            message.comment = xml.readElementText();
        else if (xml.name() == QLatin1String("translation"))
            readTranslation(xml, message);
        else
            xml.skipCurrentElement();
    }
    return message;
}

} // namespace

QString TsMessage::key() const {
    return context + QLatin1String(": ") + source +
           (comment.isEmpty() ? QString() : QLatin1String(" // ") + comment);
}

std::optional<std::vector<TsMessage>> readTs(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return std::nullopt;
    QXmlStreamReader xml(&file);
    if (!xml.readNextStartElement() || xml.name() != QLatin1String("TS"))
        return std::nullopt;
    std::vector<TsMessage> messages;
    while (xml.readNextStartElement()) { // contexts
        QString context;
        while (xml.readNextStartElement()) {
            if (xml.name() == QLatin1String("name"))
                context = xml.readElementText();
            else if (xml.name() == QLatin1String("message"))
                messages.push_back(readMessage(xml, context));
            else
                xml.skipCurrentElement();
        }
    }
    return xml.hasError() ? std::nullopt : std::make_optional(std::move(messages));
}

} // namespace chiron::test
