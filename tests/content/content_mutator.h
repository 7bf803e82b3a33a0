// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <QByteArray>
#include <QJsonObject>
#include <QJsonValue>
#include <QString>
#include <variant>
#include <vector>

/// One way of spoiling a valid content file.
struct Mutation {
    QString kind;
    QByteArray text; ///< the spoiled file
    QString path;    ///< JSON path that the message must name; empty where only line and column can be known
    bool syntax = false; ///< not JSON any more: the message names line and column, path "$"
};

/// Spoils a valid JSON file in seeded ways, each of which a loader must refuse.
class ContentMutator {
public:
    ContentMutator(const QByteArray& valid, chiron::core::Random& random);

    static constexpr int kKinds = 14;
    Mutation mutate(int kind);

private:
    using Step = std::variant<QString, qsizetype>;
    struct Node {
        std::vector<Step> steps;
        QString path;
        QJsonValue value;
    };

    void collect(const QJsonValue& value, const Node& at);
    const Node& anyNode(bool (*accept)(const Node&));
    QByteArray withRaw(const Node& node, const QByteArray& raw) const;
    Mutation typeChange();
    Mutation rangeBreak();
    Mutation unknownKey();
    Mutation misspeltKey();
    Mutation removedKey();
    Mutation duplicateKey();
    Mutation truncation();
    Mutation notANumber();
    Mutation hugeNumber();
    Mutation wrongEncoding();
    Mutation deepNesting();
    Mutation brokenPunctuation();
    Mutation controlCharacter();
    Mutation hugeText();

    QByteArray m_valid;
    QJsonObject m_root;
    std::vector<Node> m_nodes;
    chiron::core::Random& m_random;
};
