// SPDX-License-Identifier: GPL-3.0-or-later
#include "content_mutator.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QStringEncoder>

namespace {

const QString kMarker = QStringLiteral("@@spoiled@@");

QJsonValue replaced(const QJsonValue& value, const std::vector<std::variant<QString, qsizetype>>& steps,
                    std::size_t depth, const QJsonValue& with) {
    if (depth == steps.size())
        return with;
    if (const auto* key = std::get_if<QString>(&steps[depth])) {
        QJsonObject object = value.toObject();
        object[*key] = replaced(object[*key], steps, depth + 1, with);
        return object;
    }
    QJsonArray array = value.toArray();
    const qsizetype index = std::get<qsizetype>(steps[depth]);
    array[index] = replaced(array[index], steps, depth + 1, with);
    return array;
}

} // namespace

ContentMutator::ContentMutator(const QByteArray& valid, chiron::core::Random& random)
    : m_valid(valid), m_root(QJsonDocument::fromJson(valid).object()), m_random(random) {
    collect(m_root, {{}, QStringLiteral("$"), m_root});
}

void ContentMutator::collect(const QJsonValue& value, const Node& at) {
    m_nodes.push_back({at.steps, at.path, value});
    const auto child = [&](const Step& step, const QString& path, const QJsonValue& inner) {
        Node node{at.steps, path, inner};
        node.steps.push_back(step);
        collect(inner, node);
    };
    const QJsonObject object = value.toObject();
    for (const QString& key : object.keys())
        child(key, at.path + u'.' + key, object[key]);
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i)
        child(i, at.path + QStringLiteral("[%1]").arg(i), array[i]);
}

const ContentMutator::Node& ContentMutator::anyNode(bool (*accept)(const Node&)) {
    for (;;) {
        const Node& node = m_nodes[m_random.below(m_nodes.size())];
        if (accept(node))
            return node;
    }
}

/// The file with `raw` in the node's place, whether or not it is JSON.
QByteArray ContentMutator::withRaw(const Node& node, const QByteArray& raw) const {
    const QJsonValue marked = replaced(m_root, node.steps, 0, kMarker);
    return QJsonDocument(marked.toObject()).toJson().replace('"' + kMarker.toUtf8() + '"', raw);
}

Mutation ContentMutator::mutate(int kind) {
    switch (kind) {
    case 0:
        return typeChange();
    case 1:
        return rangeBreak();
    case 2:
        return unknownKey();
    case 3:
        return misspeltKey();
    case 4:
        return removedKey();
    case 5:
        return duplicateKey();
    case 6:
        return truncation();
    case 7:
        return notANumber();
    case 8:
        return hugeNumber();
    case 9:
        return wrongEncoding();
    case 10:
        return deepNesting();
    case 11:
        return brokenPunctuation();
    case 12:
        return controlCharacter();
    default:
        return hugeText();
    }
}

Mutation ContentMutator::typeChange() {
    const Node& node = anyNode([](const Node& n) { return n.path != "$"; });
    const QByteArray others[] = {"\"20\"", "7", "true", "null", "[7]", "{\"a\": 7}"};
    for (;;) {
        const QByteArray& raw = others[m_random.below(6)];
        const QJsonValue other = QJsonDocument::fromJson('[' + raw + ']').array().at(0);
        if (other.type() == node.value.type())
            continue;
        return {"type change", withRaw(node, raw), node.path, false};
    }
}

Mutation ContentMutator::rangeBreak() {
    const Node& node = anyNode([](const Node& n) { return n.value.isDouble(); });
    const QByteArray outside[] = {"-2000000000", "2000000000", "1e12", "-1e300"};
    return {"range break", withRaw(node, outside[m_random.below(4)]), node.path, false};
}

Mutation ContentMutator::unknownKey() {
    const Node& node = anyNode([](const Node& n) { return n.value.isObject(); });
    QJsonObject object = node.value.toObject();
    const QString key = QStringLiteral("stray_%1").arg(m_random.below(1000));
    object[key] = 1;
    const QJsonValue root = replaced(m_root, node.steps, 0, object);
    return {"unknown key", QJsonDocument(root.toObject()).toJson(), node.path + u'.' + key, false};
}

Mutation ContentMutator::misspeltKey() {
    const Node& node =
        anyNode([](const Node& n) { return n.value.isObject() && !n.value.toObject().isEmpty(); });
    QJsonObject object = node.value.toObject();
    const QStringList keys = object.keys();
    const QString key = keys[static_cast<qsizetype>(m_random.below(static_cast<std::uint64_t>(keys.size())))];
    const QString misspelt = key + QStringLiteral("z");
    object[misspelt] = object[key];
    object.remove(key);
    const QJsonValue root = replaced(m_root, node.steps, 0, object);
    return {"misspelt key", QJsonDocument(root.toObject()).toJson(), node.path + u'.' + misspelt, false};
}

Mutation ContentMutator::removedKey() {
    const QStringList required{"id", "title", "objective", "en"};
    for (;;) {
        const Node& node = anyNode([](const Node& n) { return n.value.isObject(); });
        const QString key = required[static_cast<qsizetype>(m_random.below(4))];
        QJsonObject object = node.value.toObject();
        if (!object.contains(key))
            continue;
        object.remove(key);
        const QJsonValue root = replaced(m_root, node.steps, 0, object);
        return {"removed key", QJsonDocument(root.toObject()).toJson(), node.path + u'.' + key, false};
    }
}

Mutation ContentMutator::duplicateKey() {
    const Node& node =
        anyNode([](const Node& n) { return n.value.isObject() && !n.value.toObject().isEmpty(); });
    QJsonObject object = node.value.toObject();
    const QStringList keys = object.keys();
    const QString key = keys[static_cast<qsizetype>(m_random.below(static_cast<std::uint64_t>(keys.size())))];
    object[kMarker] = object[key];
    const QJsonValue root = replaced(m_root, node.steps, 0, object);
    QByteArray text = QJsonDocument(root.toObject()).toJson();
    return {"duplicate key", text.replace(kMarker.toUtf8(), key.toUtf8()), node.path + u'.' + key, false};
}

Mutation ContentMutator::truncation() {
    const auto end = static_cast<std::uint64_t>(m_valid.lastIndexOf('}'));
    return {"truncation", m_valid.left(static_cast<qsizetype>(m_random.below(end + 1))), {}, true};
}

Mutation ContentMutator::notANumber() {
    const Node& node = anyNode([](const Node& n) { return n.value.isDouble(); });
    const QByteArray raws[] = {"NaN", "nan", "Infinity", "-Infinity", "0x10",
                               "+5",  ".5",  "1_000",    "--1",       "1e"};
    return {"not a number", withRaw(node, raws[m_random.below(10)]), {}, false};
}

Mutation ContentMutator::hugeNumber() {
    const Node& node = anyNode([](const Node& n) { return n.value.isDouble(); });
    const QByteArray raws[] = {"1e999", "-1e999", "9" + QByteArray(400, '9'), "1e308"};
    return {"huge number", withRaw(node, raws[m_random.below(4)]), {}, false};
}

Mutation ContentMutator::wrongEncoding() {
    const auto way = m_random.below(4);
    if (way < 2) {
        QStringEncoder encoder(way == 0 ? QStringEncoder::Utf16LE : QStringEncoder::Utf16BE,
                               QStringEncoder::Flag::WriteBom);
        return {"UTF-16", encoder(QString::fromUtf8(m_valid)), {}, true};
    }
    QByteArray text = m_valid;
    const char bytes[] = {'\xe4', '\xff', '\xc0', '\x80'};
    text.insert(static_cast<qsizetype>(m_random.below(static_cast<std::uint64_t>(text.size() - 2))),
                bytes[m_random.below(4)]);
    return {"stray byte", text, {}, true};
}

Mutation ContentMutator::deepNesting() {
    const Node& node = anyNode([](const Node& n) { return n.path != "$"; });
    const auto depth = static_cast<qsizetype>(20 + m_random.below(50000));
    const bool objects = m_random.below(2) == 0;
    const QByteArray raw = objects ? QByteArray("{\"a\":").repeated(depth) + '1' + QByteArray(depth, '}')
                                   : QByteArray(depth, '[') + QByteArray(depth, ']');
    return {"deep nesting", withRaw(node, raw), {}, false};
}

Mutation ContentMutator::brokenPunctuation() {
    const char marks[] = {',', ':', '{', '['};
    std::vector<qsizetype> places; // outside of texts
    while (places.empty()) {
        const char mark = marks[m_random.below(4)];
        bool inText = false;
        for (qsizetype i = 0; i < m_valid.size(); ++i) {
            inText = inText != (m_valid[i] == '"');
            if (!inText && m_valid[i] == mark)
                places.push_back(i);
        }
    }
    QByteArray text = m_valid;
    return {"broken punctuation", text.remove(places[m_random.below(places.size())], 1), {}, true};
}

Mutation ContentMutator::controlCharacter() {
    const Node& node = anyNode([](const Node& n) { return n.value.isString(); });
    return {"control character",
            withRaw(node, "\"a\\u000" + QByteArray::number(1 + static_cast<int>(m_random.below(8))) + "b\""),
            node.path, false};
}

Mutation ContentMutator::hugeText() {
    const Node& node = anyNode([](const Node& n) { return n.value.isString(); });
    const auto length = static_cast<qsizetype>(1000 + m_random.below(2000000));
    return {"huge text", withRaw(node, '"' + QByteArray(length, 'x') + '"'),
            length > 1000000 ? QString() : node.path, false};
}
