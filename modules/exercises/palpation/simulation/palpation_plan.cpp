// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/simulation/palpation_plan.h"

#include "core/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiron::simulation {

namespace {

using Parameters = PalpationParameters;
using Trial = PalpationTrial;

constexpr int kDraws = 1000;
/// R ≤ 0.75 h: the range in which the lump's law is valid (models.md §3).
constexpr double kLargestRadiusShare = 0.75;

int regionCount(const Parameters& p) {
    return std::max(1, p.regionColumns) * std::max(1, p.regionRows);
}

core::Vec2 regionSize_m(const Parameters& p) {
    return {2.0 * p.areaHalf_m.x() / std::max(1, p.regionColumns),
            2.0 * p.areaHalf_m.y() / std::max(1, p.regionRows)};
}

/// Says whether the place lies in a region and keeps the inset from its border.
bool isInside(const Parameters& p, const core::Vec2& place_m) {
    const int region = palpationRegion(p, place_m);
    if (region < 0)
        return false;
    const core::Vec2 off = (place_m - palpationRegionMiddle_m(p, region)).cwiseAbs();
    const core::Vec2 most = (0.5 - kRegionInset) * regionSize_m(p) + core::Vec2::Constant(1e-12);
    return off.x() <= most.x() && off.y() <= most.y();
}

bool keepsFromDistractors(const Parameters& p, const core::Vec2& place_m) {
    return std::none_of(p.tissue.regions.begin(), p.tissue.regions.end(), [&](const StiffRegion& region) {
        return (region.centre_m - place_m).norm() < p.spacing_m;
    });
}

/// Says whether a lump may have this place, regardless of the other lumps.
bool isPlace(const Parameters& p, const core::Vec2& place_m) {
    const core::Vec2 moved_m = palpationMovedPlace_m(p, place_m);
    return isInside(p, place_m) && keepsFromDistractors(p, place_m) &&
           (moved_m == place_m || (isInside(p, moved_m) && keepsFromDistractors(p, moved_m)));
}

bool keepsFromOthers(const Parameters& p, const Trial& trial, int count, const core::Vec2& place_m) {
    return std::none_of(trial.lump.begin(), trial.lump.begin() + count,
                        [&](const Lump& other) { return (other.place_m - place_m).norm() < p.spacing_m; });
}

/// Places lumps in the middles of regions, one after the other from `first`. Returns the number of lumps that
/// got one.
int placeInMiddles(const Parameters& p, int first, Trial& trial) {
    int placed = 0;
    for (int i = 0; i < regionCount(p) && placed < trial.lumps; ++i) {
        const core::Vec2 middle_m = palpationRegionMiddle_m(p, (first + i) % regionCount(p));
        if (isPlace(p, middle_m) && keepsFromOthers(p, trial, placed, middle_m))
            trial.lump[static_cast<std::size_t>(placed++)].place_m = middle_m;
    }
    return placed;
}

core::Vec2 placeIn(const Parameters& p, int region, core::Random& places) {
    const core::Vec2 most = (0.5 - kRegionInset) * regionSize_m(p);
    const double x_m = places.uniform(-most.x(), most.x());
    const double y_m = places.uniform(-most.y(), most.y());
    return palpationRegionMiddle_m(p, region) + core::Vec2(x_m, y_m);
}

/// Draws all places of a trial once, each in a region of its own. Returns whether they may all be used.
bool drawPlacesOnce(const Parameters& p, core::Random& places, std::vector<int>& regions, Trial& trial) {
    bool kept = true;
    // The beginning of a shuffle: every set of regions is equally likely
    for (int i = 0; i < trial.lumps; ++i) {
        const int left = static_cast<int>(regions.size()) - i;
        const int other = i + static_cast<int>(places.below(static_cast<std::uint64_t>(left)));
        std::swap(regions[static_cast<std::size_t>(i)], regions[static_cast<std::size_t>(other)]);
        const core::Vec2 place_m = placeIn(p, regions[static_cast<std::size_t>(i)], places);
        kept = kept && isPlace(p, place_m) && keepsFromOthers(p, trial, i, place_m);
        trial.lump[static_cast<std::size_t>(i)].place_m = place_m;
    }
    return kept;
}

void drawPlaces(const Parameters& p, core::Random& places, Trial& trial) {
    std::vector<int> regions(static_cast<std::size_t>(regionCount(p)));
    std::iota(regions.begin(), regions.end(), 0);
    if (trial.lumps <= regionCount(p))
        for (int draw = 0; draw < kDraws; ++draw)
            if (drawPlacesOnce(p, places, regions, trial))
                return;
    trial.lumps =
        placeInMiddles(p, static_cast<int>(places.below(static_cast<std::uint64_t>(regionCount(p)))), trial);
}

void drawKinds(const Parameters& p, core::Random& kinds, core::Random& depths, Trial& trial) {
    for (int i = 0; i < trial.lumps; ++i) {
        const LumpKind& kind = p.kinds[static_cast<std::size_t>(kinds.below(p.kinds.size()))];
        Lump& lump = trial.lump[static_cast<std::size_t>(i)];
        lump.radius_m = kind.radius_m;
        lump.depth_m = std::max(kind.radius_m / kLargestRadiusShare,
                                kind.depth_m + depths.uniform(-p.depthSpread_m, p.depthSpread_m));
        lump.ratio = kind.ratio;
        trial.hardness[static_cast<std::size_t>(i)] = kind.hardness;
    }
}

/// Draws which trials are catch trials: the beginning of a shuffle of those that may be one.
std::vector<bool> drawCatchTrials(const Parameters& p, core::Random& which, std::size_t trials) {
    const std::size_t first = p.lumpFirst ? 1 : 0;
    std::vector<bool> isCatch(trials, false);
    std::fill_n(isCatch.begin() + static_cast<std::ptrdiff_t>(first),
                std::clamp<std::ptrdiff_t>(p.catchTrials, 0, static_cast<std::ptrdiff_t>(trials - first)),
                true);
    for (std::size_t i = first; i + 1 < trials; ++i) {
        const std::size_t other = i + static_cast<std::size_t>(which.below(trials - i));
        const bool kept = isCatch[i];
        isCatch[i] = isCatch[other];
        isCatch[other] = kept;
    }
    return isCatch;
}

} // namespace

int palpationRegion(const PalpationParameters& parameters, const core::Vec2& p_m) noexcept {
    const core::Vec2& half = parameters.areaHalf_m;
    if (!(std::abs(p_m.x()) <= half.x() && std::abs(p_m.y()) <= half.y()))
        return -1;
    const int columns = std::max(1, parameters.regionColumns);
    const int rows = std::max(1, parameters.regionRows);
    const int column =
        std::min(columns - 1, static_cast<int>((p_m.x() + half.x()) / (2.0 * half.x()) * columns));
    const int row = std::min(rows - 1, static_cast<int>((p_m.y() + half.y()) / (2.0 * half.y()) * rows));
    return column + columns * row;
}

core::Vec2 palpationRegionMiddle_m(const PalpationParameters& parameters, int region) noexcept {
    const int columns = std::max(1, parameters.regionColumns);
    const core::Vec2 size(2.0 * parameters.areaHalf_m.x() / columns,
                          2.0 * parameters.areaHalf_m.y() / std::max(1, parameters.regionRows));
    return {(region % columns + 0.5) * size.x() - parameters.areaHalf_m.x(),
            (region / columns + 0.5) * size.y() - parameters.areaHalf_m.y()};
}

core::Vec2 palpationMovedPlace_m(const PalpationParameters& parameters, const core::Vec2& place_m) noexcept {
    return parameters.control.moveAfter_s > 0.0 ? core::Vec2(place_m + parameters.control.move_m) : place_m;
}

int mostPalpationLumps(const PalpationParameters& parameters) {
    int most = static_cast<int>(TissueParameters::kMaxLumps);
    for (int first = 0; first < regionCount(parameters); ++first) {
        Trial trial;
        trial.lumps = static_cast<int>(TissueParameters::kMaxLumps);
        most = std::min(most, placeInMiddles(parameters, first, trial));
    }
    return most;
}

std::vector<PalpationTrial> planPalpationTrials(const PalpationParameters& parameters, std::uint64_t seed) {
    core::Random which = core::Random::stream(seed, "palpation.catch");
    core::Random numbers = core::Random::stream(seed, "palpation.number");
    core::Random places = core::Random::stream(seed, "palpation.place");
    core::Random kinds = core::Random::stream(seed, "palpation.kind");
    core::Random depths = core::Random::stream(seed, "palpation.depth");
    std::vector<Trial> trials(static_cast<std::size_t>(std::max(1, parameters.trials)));
    const std::vector<bool> isCatch = drawCatchTrials(parameters, which, trials.size());
    const int low = std::clamp(parameters.lumpsLow, 0, static_cast<int>(TissueParameters::kMaxLumps));
    const int high = std::clamp(parameters.lumpsHigh, low, static_cast<int>(TissueParameters::kMaxLumps));
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const int drawn = low + static_cast<int>(numbers.below(static_cast<std::uint64_t>(high - low + 1)));
        trials[i].introduction = parameters.lumpFirst && i == 0;
        trials[i].lumps = isCatch[i] || parameters.kinds.empty() ? 0
                          : trials[i].introduction               ? std::max(1, drawn)
                                                                 : drawn;
        drawPlaces(parameters, places, trials[i]);
        drawKinds(parameters, kinds, depths, trials[i]);
    }
    return trials;
}

} // namespace chiron::simulation
