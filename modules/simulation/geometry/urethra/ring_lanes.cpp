// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/ring_lanes.h"

#include <cmath>
#include <cstring>

// Sanitizers are not initialised yet when the loader resolves such functions.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define CHIRON_LANES __attribute__((target_clones("avx2", "default")))
#else
#define CHIRON_LANES
#endif

namespace chiron::simulation {

namespace {

/// Vectors of numbers at any address. Only local variables have these types, because the way of passing them
/// would depend on the processor.
typedef float Lane __attribute__((vector_size(4 * kLaneWidth), aligned(4), may_alias));
typedef float Four __attribute__((vector_size(4 * kFour), aligned(4), may_alias));

constexpr int kStep = kFour; ///< offsets into the numbers of a curve
constexpr int kEdge = 2 * kFour;
constexpr int kSlope = 3 * kFour;
constexpr int kSlopeStep = 4 * kFour;
constexpr int kCurve = kCurveFours * kFour;
/// Added to a normal's squared length (1e-20 or more), so that a wall without extent gives no NaN.
constexpr float kLeastSquare = 1e-36F;

[[gnu::always_inline]] inline const Lane& lane(const float* from) noexcept {
    return *reinterpret_cast<const Lane*>(from);
}
[[gnu::always_inline]] inline Lane& lane(float* to) noexcept {
    return *reinterpret_cast<Lane*>(to);
}
[[gnu::always_inline]] inline const Four& four(const float* from) noexcept {
    return *reinterpret_cast<const Four*>(from);
}
[[gnu::always_inline]] inline Four& four(float* to) noexcept {
    return *reinterpret_cast<Four*>(to);
}

/// Stores a lane, or the part of it for which there is room. `Whole`: the sides consist of whole blocks, as
/// P1's 8, and no test is needed.
template <bool Whole>
[[gnu::always_inline]] inline void put(const Lane& values, float* to, int room) noexcept {
    if (Whole || room >= kLaneWidth)
        lane(to) = values;
    else
        std::memcpy(to, &values, static_cast<std::size_t>(room) * sizeof(float));
}

template <bool Whole>
[[gnu::always_inline]] inline void putCross(const Lane (&a)[3], const Lane (&b)[3],
                                            const std::array<float*, 6>& out, int at, int room) noexcept {
    put<Whole>(a[1] * b[2] - a[2] * b[1], out[3] + at, room);
    put<Whole>(a[2] * b[0] - a[0] * b[2], out[4] + at, room);
    put<Whole>(a[0] * b[1] - a[1] * b[0], out[5] + at, room);
}

[[gnu::always_inline]] inline void normalise(float* x, float* y, float* z, int count) noexcept {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float scale = 1.0F / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i] + kLeastSquare);
        x[i] *= scale;
        y[i] *= scale;
        z[i] *= scale;
    }
}

template <bool Whole>
[[gnu::always_inline]] inline void innerRing(const float* row, const float* spread, const float* curves,
                                             float u, const SideTables& tables, RingSize size,
                                             const std::array<float*, 6>& to) noexcept {
    const std::array<float*, 6> out = to; // a copy whose address nobody has, so stores cannot change it
    const float* const place = tables.v;
    const float* const isFirst = tables.first;
    for (int j = 0; j < size.columns; ++j, curves += kCurve)
        for (int q = 0; q < size.perPatch; q += kLaneWidth) {
            const int at = j * size.perPatch + q;
            const int room = size.perPatch - q;
            const Lane v = lane(place + q);
            const Lane first = lane(isFirst + q);
            Lane along[3];
            Lane around[3];
            for (int axis = 0; axis < 3; ++axis) {
                const Lane more = lane(spread + axis * kLaneWidth);
                const float step = curves[kStep + axis];
                put<Whole>(lane(row + axis * kLaneWidth) + u * more + (curves[axis] + v * step),
                           out[axis] + at, room);
                along[axis] = more + (curves[kSlope + axis] + v * curves[kSlopeStep + axis]);
                around[axis] = lane(row + (3 + axis) * kLaneWidth) +
                               u * lane(spread + (3 + axis) * kLaneWidth) +
                               (step + first * curves[kEdge + axis]);
            }
            putCross<Whole>(along, around, out, at, room);
            row += kRowLanes * kLaneWidth;
            spread += kRowLanes * kLaneWidth;
        }
    normalise(out[3], out[4], out[5], size.vertices());
}

template <bool Whole>
[[gnu::always_inline]] inline void sectionRing(const float* row, const float* slope, const float* point,
                                               const float* chord, const SideTables& tables, RingSize size,
                                               const std::array<float*, 6>& to) noexcept {
    const std::array<float*, 6> out = to; // a copy whose address nobody has, so stores cannot change it
    for (int j = 0; j < size.columns; ++j) {
        const int here = j * kFour;
        const int before = (j > 0 ? j - 1 : size.columns - 1) * kFour;
        for (int q = 0; q < size.perPatch; q += kLaneWidth) {
            const int at = j * size.perPatch + q;
            const int room = size.perPatch - q;
            const Lane v = lane(tables.v + q);
            const Lane first = lane(tables.first + q);
            Lane along[3];
            Lane around[3];
            for (int axis = 0; axis < 3; ++axis) {
                const float step = chord[here + axis];
                // Difference to the mean of both chords
                const float edge = 0.5F * (chord[before + axis] - step);
                put<Whole>(lane(row + axis * kLaneWidth) + (point[here + axis] + v * step), out[axis] + at,
                           room);
                along[axis] = lane(slope + axis * kLaneWidth);
                around[axis] = lane(row + (3 + axis) * kLaneWidth) + (step + first * edge);
            }
            putCross<Whole>(along, around, out, at, room);
            row += kRowLanes * kLaneWidth;
            slope += kSlopeLanes * kLaneWidth;
        }
    }
    normalise(out[3], out[4], out[5], size.vertices());
}

} // namespace

CHIRON_LANES void bulgeLanes(const double* point, const double* handleOut, const double* handleIn,
                             const SideTables& tables, RingSize size, int component, float* row) noexcept {
    float* block = row + component * kLaneWidth;
    for (int j = 0; j < size.columns; ++j) {
        const int next = j + 1 < size.columns ? j + 1 : 0;
        const int before = j > 0 ? j - 1 : size.columns - 1;
        const float out = static_cast<float>(handleOut[j]);
        const float in = static_cast<float>(handleIn[next]);
        const float chord = static_cast<float>(point[next] - point[j]);
        float* const first = block + kSlopeLanes * kLaneWidth;
        for (int q = 0; q < size.blocksAPatch() * kLaneWidth;
             q += kLaneWidth, block += kRowLanes * kLaneWidth) {
            lane(block) =
                out * lane(tables.out + q) - in * lane(tables.in + q) + chord * lane(tables.chord + q);
            lane(block + kSlopeLanes * kLaneWidth) = out * lane(tables.outTurn + q) -
                                                     in * lane(tables.inTurn + q) +
                                                     chord * lane(tables.chordTurn + q);
        }
        // At the point itself: the mean of 3 hOut − chord after the point and 3 hIn − chord before it.
        *first = static_cast<float>(1.5 * (handleOut[j] + handleIn[j]) - 0.5 * (point[next] - point[before]));
    }
}

CHIRON_LANES void curveColumns(const SpanColumns& in, const std::array<float, 3>& weights,
                               const std::array<float, 3>& slopeWeights, int columns,
                               float* curves) noexcept {
    for (int j = 0; j <= columns; ++j) {
        const Four q1 = four(in.q1 + j * kFour);
        const Four q2 = four(in.q2 + j * kFour);
        const Four q3 = four(in.q3 + j * kFour);
        four(curves + j * kCurve) = q1 * weights[0] + q2 * weights[1] + q3 * weights[2];
        four(curves + j * kCurve + kSlope) =
            q1 * slopeWeights[0] + q2 * slopeWeights[1] + q3 * slopeWeights[2];
    }
    const float* const last = curves + (columns - 1) * kCurve;
    Four stepBefore = four(in.chord + (columns - 1) * kFour) + (four(last + kCurve) - four(last));
    for (int j = 0; j < columns; ++j) {
        float* const curve = curves + j * kCurve;
        const Four step = four(in.chord + j * kFour) + (four(curve + kCurve) - four(curve));
        four(curve + kStep) = step;
        four(curve + kEdge) = 0.5F * (stepBefore - step);
        four(curve + kSlopeStep) = four(curve + kCurve + kSlope) - four(curve + kSlope);
        // Added last, so that the differences above keep the precision of their own size
        four(curve) += four(in.point + j * kFour);
        stepBefore = step;
    }
}

CHIRON_LANES void innerRingLanes(const float* row, const float* spread, const float* curves, float u,
                                 const SideTables& tables, RingSize size,
                                 const std::array<float*, 6>& out) noexcept {
    if (size.perPatch % kLaneWidth == 0)
        innerRing<true>(row, spread, curves, u, tables, size, out);
    else
        innerRing<false>(row, spread, curves, u, tables, size, out);
}

CHIRON_LANES void sectionRingLanes(const float* row, const float* slope, const float* point,
                                   const float* chord, const SideTables& tables, RingSize size,
                                   const std::array<float*, 6>& out) noexcept {
    if (size.perPatch % kLaneWidth == 0)
        sectionRing<true>(row, slope, point, chord, tables, size, out);
    else
        sectionRing<false>(row, slope, point, chord, tables, size, out);
}

CHIRON_LANES void slopeLanes(const float* spread, const float* curves, float perLength,
                             const SideTables& tables, RingSize size, float* slope) noexcept {
    for (int j = 0; j < size.columns; ++j, curves += kCurve)
        for (int q = 0; q < size.perPatch; q += kLaneWidth) {
            const Lane v = lane(tables.v + q);
            for (int axis = 0; axis < 3; ++axis)
                lane(slope + axis * kLaneWidth) = (lane(spread + axis * kLaneWidth) +
                                                   (curves[kSlope + axis] + v * curves[kSlopeStep + axis])) *
                                                  perLength;
            spread += kRowLanes * kLaneWidth;
            slope += kSlopeLanes * kLaneWidth;
        }
}

CHIRON_LANES void subtractLanes(const float* a, const float* b, float* difference, int count) noexcept {
    for (int i = 0; i < count; i += kLaneWidth)
        lane(difference + i) = lane(a + i) - lane(b + i);
}

CHIRON_LANES void addLanes(const float* a, float* sum, int count) noexcept {
    for (int i = 0; i < count; i += kLaneWidth)
        lane(sum + i) += lane(a + i);
}

} // namespace chiron::simulation
