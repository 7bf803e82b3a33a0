// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/trial_sink.h"

#include <span>
#include <string>

namespace chiron::recording {

/// Returns BLAKE2b-256 over the little-endian sequence, firstTick and frames, then forceHash and payload of a
/// chunk. It guards against accidents (data.md, Proof). `payloadDigest` itself is not read.
Digest payloadDigestOf(const Chunk& chunk);

/// Returns BLAKE2b-256 over the unrounded doubles of tissue and commanded of every used tool, frame after
/// frame: the values that a replay of the same ticks must reproduce. Equal hashes <=> equal bits. Hashed form
/// of a tool: a u16 mask with bit i (0..5) set where tissue[i] is not +0.0 and bit 6 + i set where
/// commanded[i] has other bits than tissue[i]; then those doubles (bits, little-endian) in that order. The
/// form is one to one, and takes a quarter of the bytes when the force is passed on unchanged. After a
/// frame's tools come its recorded quantities (TickHeader::quantities), if any is not +0.0: u16 1 << 15, u32
/// mask, those doubles. Scores depend on them too, and a squeeze, for example, is in no wrench.
Digest forceHashOf(std::span<const core::HapticFrame> frames);

/// Lower-case hexadecimal, for messages.
std::string toHex(const Digest& digest);

} // namespace chiron::recording
