// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"

#include "modules/exercises/palpation/cues/findings_book.h"

#include <cmath>
#include <string>
#include <string_view>

namespace chiron::scoring {

namespace {

constexpr int kMostRegions = 64; ///< per side

/// Reads named values, and remembers whether one was missing or impossible.
class TruthReader {
public:
    explicit TruthReader(std::span<const NamedValue> truth) : m_truth(truth) {}

    double optional(std::string_view id) const {
        for (const NamedValue& value : m_truth)
            if (value.id == id && std::isfinite(value.value))
                return value.value;
        return 0.0;
    }
    double number(std::string_view id) {
        for (const NamedValue& value : m_truth)
            if (value.id == id && std::isfinite(value.value))
                return value.value;
        m_whole = false;
        return 0.0;
    }
    double atLeast(double least, std::string_view id) {
        const double value = number(id);
        m_whole = m_whole && value >= least;
        return value;
    }
    /// A trace file may contain any number, so the value is checked before it is converted to an integer.
    int count(std::string_view id, int least, int most) {
        const double value = std::round(number(id));
        m_whole = m_whole && value >= least && value <= most;
        return m_whole ? static_cast<int>(value) : least;
    }
    bool whole() const { return m_whole; }

private:
    std::span<const NamedValue> m_truth;
    bool m_whole = true;
};

LumpTruth lumpOf(TruthReader& read, int number) {
    const std::string lump = "lump_" + std::to_string(number) + "_";
    LumpTruth out;
    out.place_W = {read.number(lump + "x_m"), read.number(lump + "y_m"), read.number(lump + "z_m")};
    out.depth_m = read.number(lump + "depth_m");
    out.radius_m = read.atLeast(0.0, lump + "radius_m");
    out.hardness =
        read.count(lump + "hardness", 0, static_cast<int>(simulation::FindingsBook::kHighestRating));
    return out;
}

} // namespace

std::optional<PalpationTruth> palpationTruthOf(std::span<const NamedValue> truth) {
    TruthReader read(truth);
    PalpationTruth out;
    const int lumps = read.count("lumps", 0, static_cast<int>(simulation::kMaxShownLumps));
    for (int i = 0; i < lumps; ++i)
        out.lumps.push_back(lumpOf(read, i));
    out.areaHalf_m = {read.atLeast(1e-6, "area_half_x_m"), read.atLeast(1e-6, "area_half_y_m")};
    out.regionColumns = read.count("region_columns", 1, kMostRegions);
    out.regionRows = read.count("region_rows", 1, kMostRegions);
    out.hitRadius_m = read.atLeast(0.0, "hit_radius_m");
    out.bandLow_N = read.optional("band_low_N");
    out.bandHigh_N = read.optional("band_high_N");
    out.coverForce_N = read.optional("cover_force_N");
    out.introduction = read.optional("introduction") != 0.0;
    out.asksSize = read.optional("asks_size") != 0.0;
    out.asksHardness = read.optional("asks_hardness") != 0.0;
    return read.whole() ? std::optional(std::move(out)) : std::nullopt;
}

} // namespace chiron::scoring
