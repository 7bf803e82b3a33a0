// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_spec.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <optional>

namespace chiron::cli {

/// One line that `psychophysics adaptive` reads.
struct AdaptiveLine {
    enum class Kind { outcome, undo, spoiled } kind = Kind::outcome;
    int outcome = -1;
    std::optional<psychophysics::Stimulus> presented; ///< empty: the stimulus that was asked for
};

/// Parses "1", "0 -0.35", "b<a<c", "a=b<c", "undo" or "spoiled". If `orders` is true, the outcomes are the
/// rankings of three objects: 6, or 13 with ties (a is the reference; b and c differ from it by the
/// difference and by twice the difference).
/// Errors: badInput naming what was found and what was expected.
core::Result<AdaptiveLine> parseAdaptiveLine(const QString& line, int outcomes, bool orders,
                                             std::size_t dimensions);

/// The outcome index of an order such as "b<a<c" or "b<a=c": the ranks of a, b and c in the numbering of
/// psychophysics::rankings(). Returns -1 if the word is not an order.
int outcomeOfOrder(const QString& word);

/// The state that a procedure prints: stimulus (a number, or an object keyed by dimension; null once done),
/// trial, reversals, done, entropy_margin, estimate.
QJsonObject adaptiveState(const psychophysics::Procedure& procedure, const QStringList& dimensions);

} // namespace chiron::cli
