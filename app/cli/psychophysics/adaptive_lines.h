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
    std::optional<psychophysics::Stimulus> presented; ///< none: as asked for
};

/// "1", "0 -0.35", "b<a<c", "a=b<c", "undo", "spoiled". `orders`: outcomes are the rankings of three objects, 6 or with ties 13 (a the reference, b, c twice the
/// difference). Failure: badInput saying what was found and expected.
core::Result<AdaptiveLine> parseAdaptiveLine(const QString& line, int outcomes, bool orders, std::size_t dimensions);

/// The outcome of an order such as "b<a<c" or "b<a=c": the ranks given to a, b, c, as psychophysics::rankings() counts them. -1: not an order.
int outcomeOfOrder(const QString& word);

/// What a procedure prints: stimulus (a number, or an object by dimension; null once done), trial, reversals, done, entropy_margin, estimate.
QJsonObject adaptiveState(const psychophysics::Procedure& procedure, const QStringList& dimensions);

} // namespace chiron::cli
